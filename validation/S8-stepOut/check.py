# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stepping out of a helix against the resistance of the same mesh: lag, mean
speed, advance, and the way of its axis; write results.csv and draw."""

import glob
import os
import re
import sys
from functools import cache

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results
from model import resistance, turned

BODY, TORQUE, STEPS = "swimmer", 0.1, 24            # m B, pg um2/us2; a turn
quick = sys.argv[1:2] == ["true"]
results = Results("S8")


class Helix:
    """What its resistance makes of the torque: speeds of stepping out and advances."""

    def __init__(self):
        R = resistance("runs/resistance")
        self.mobility = np.linalg.inv(R)
        a, b, c = R[2, 2], R[2, 5], R[5, 5]
        # no force, no torque across the axis
        self.free = TORQUE * self.mobility[5, 5]
        self.advance = self.mobility[2, 5] / self.mobility[5, 5]
        # it may only travel and turn along its axis
        self.axial = TORQUE / (c - b**2 / a)
        # axis held
        rest = np.delete(np.arange(6), [3, 4])
        N = np.linalg.inv(R[np.ix_(rest, rest)])
        self.held = TORQUE * N[3, 3]
        self.advance_held = N[2, 3] / N[3, 3]


@cache
def helix():
    return Helix()


class Run(Case):
    def __init__(self, folder):
        super().__init__(folder)
        ratio, self.kind = re.fullmatch(r"w([\d.]+)([a-z]*)",
                                        os.path.basename(folder)).groups()
        self.variant, self.suffix = f"w{ratio}", f"_{self.kind}" if self.kind else ""
        self.name = self.variant + self.suffix
        self.speed = float(ratio) * helix().free
        magnet = self.history[f"effects/magnetics/{BODY}"]
        self.t, self.lag, self.slips = magnet["time"], magnet["lag"], magnet["slips"][-1]
        m = np.array([magnet["m" + i] for i in "xyz"]).T
        self.moment = m / np.linalg.norm(m, axis=1)[:, None]
        q = self.history[f"bodies/{BODY}/orientation"]
        w, x, y, z = (q[i] for i in q.columns[1:])
        self.axis = np.array([2 * (x * z + w * y), 2 * (y * z - w * x),
                              1 - 2 * (x**2 + y**2)]).T
        self.cost = dict(seconds=self.seconds, cells=self.cells)

    def tilt(self):
        return np.degrees(np.arccos(self.axis[:, 2]))

    def period(self):
        """Time in which the field overtakes it once: it began at a lag of
        pi/2; the lag is smooth."""
        i = np.searchsorted(self.lag, 2.5 * np.pi)
        near = slice(i - 2, i + 2)
        time = np.polynomial.Polynomial.fit(self.lag[near], self.t[near], 3)
        return time(2.5 * np.pi)

    def mean(self):
        return self.speed - 2 * np.pi / self.period()

    def advance(self):
        """Way along the field's axis over the angle turned, from the rates of
        the last steps."""
        n = min(STEPS, len(self.t) // 2)
        return (self.velocity(BODY)[-n:, 2].mean() / self.spin(BODY)[-n:, 2].mean())


def follows(run):
    theory = helix().held if run.kind == "held" else helix().free
    step_out = run.speed / np.sin(run.lag[-6:].mean())
    # bound: second order with 24 steps a turn, (2 pi/24)^2/12 = 0.6 %, and 0.4 % since
    # a new mesh has another resistance
    results.add(f"step_out{run.suffix}", step_out / theory, 1, 0.01, **run.cost,
                variant=run.variant)
    if not run.kind:
        # bound: the project's case table, 3 %
        results.add("step_out_axial_law", step_out / helix().axial, 1, 0.03,
                    variant=run.variant)


def steps_out(run):
    mean, free = run.mean(), helix().free
    # bound: 1 % of the speed of stepping out, 1.3 times as much here at 1.25 times it,
    # and 1 % of the field's for the time in which it slips
    results.add(f"mean_speed{run.suffix}_abs", mean / free,
                (run.speed - np.sqrt(run.speed**2 - free**2)) / free, 0.03, **run.cost,
                variant=run.variant)
    # bound: as below stepping out
    results.add(f"step_out{run.suffix}", np.sqrt(run.speed**2 - (run.speed - mean)**2) / free,
                1, 0.01, variant=run.variant)
    # bound: the project's case table, 3 %
    results.add(f"step_out{run.suffix}_axial_law",
                np.sqrt(run.speed**2 - (run.speed - mean)**2) / helix().axial, 1, 0.03,
                variant=run.variant)


def model_of(run):
    angle = np.radians(75 if run.kind == "tilted" else 90)
    moment = np.array([np.sin(angle), 0, np.cos(angle)])
    lag = {"w0.97": 1.2}.get(run.name, 0 if run.speed < helix().free else np.pi / 2)
    return turned(helix().mobility, moment, TORQUE, run.speed, lag, np.append(0, run.t))


def main():
    free = helix().free
    runs = sorted((Run(f) for f in glob.glob("runs/w*")), key=lambda r: (r.speed, r.kind))
    wrong = [r.name for r in runs if r.slips != (r.speed > free)]
    # bound: theory, none
    results.add("runs_with_wrong_slips_abs", len(wrong), 0, 0.5)
    ways = {}
    for run in runs:
        if run.kind != "tilted":
            (follows if run.speed < free else steps_out)(run)
            advance = helix().advance_held if run.kind else helix().advance
            # bound: as for stepping out, a ratio of two resistances of a new mesh
            results.add(f"advance{run.suffix}", run.advance() / advance, 1, 0.01,
                        variant=run.variant)
        if run.kind != "held":
            axis, moment = model_of(run)
            ways[run.name] = (run, axis)
            # bound: mobilities off by 3 % (case table) of a cone of 4 degrees, and its phase by
            # 0.6 % of a turn in each of two turns: 0.12 and 0.28 degrees
            results.add(f"largest_tilt{run.suffix}_abs", run.tilt().max(),
                        np.degrees(np.arccos(axis[:, 2])).max(), 0.5, variant=run.variant)
            # where the axis points, not only how far
            # bound: twice that of the tilt, across the cone's radius as along it
            results.add(f"axis{run.suffix}_degrees_abs",
                        np.degrees(np.linalg.norm(run.axis - axis[1:], axis=1)).max(), 0, 1,
                        variant=run.variant)
            # the moment stays in the body at its angle to the axis
            alignment = np.einsum("ij,ij->i", run.axis, run.moment)
            given = np.cos(np.radians(75)) if run.kind == "tilted" else 0
            # bound: round-off
            results.add(f"moment_along_axis{run.suffix}_abs",
                        np.abs(alignment - given).max(), 0, 1e-9, variant=run.variant)

    if not quick:
        figure, (left, right) = plots.plt.subplots(1, 2, figsize=(10.4, 4.4))
        w = np.linspace(0, 2.2, 500)
        left.plot(w, w - np.sqrt(np.maximum(w**2 - 1, 0)), color="black", lw=1.2,
                  label="ω, above ω$_c$: ω − √(ω² − ω$_c$²)")
        plain = [r for r in runs if not r.kind]
        left.plot([r.speed / free for r in plain],
                  [(r.mean() if r.slips else r.spin(BODY)[-6:, 2].mean()) / free for r in plain],
                  ls="none", marker="o", mfc="white", color=plots.COLOURS[0], label="fsbiFoam")
        left.set(xlabel="speed of the field / ω$_c$", ylabel="mean speed of the helix / ω$_c$")
        left.set_title("A helix steps out where its resistance says", loc="left")
        left.legend()
        for i, name in enumerate(("w0.5", "w0.5_tilted")):
            run, axis = ways[name]
            turns = run.speed * np.append(0, run.t) / (2 * np.pi)
            right.plot(turns[1:], run.tilt(), color=plots.COLOURS[i], ls="none", marker="o",
                       mfc="white", label=f"moment at {75 if run.kind else 90}° to the axis")
            right.plot(turns, np.degrees(np.arccos(axis[:, 2])), color="black", lw=1.2,
                       label=None if i else "by the mobility matrix alone")
        right.set(xlabel="turns of the field", ylabel="axis off the field's axis (°)")
        right.set_title("It precesses on a cone", loc="left")
        right.legend(fontsize=9)
        plots.save(figure, "stepOut.png")
    results.write()


if __name__ == "__main__":
    main()
