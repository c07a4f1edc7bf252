# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the coupling schemes with the monolithic one; write results.csv and
draw passes and seconds per step."""

import glob
import os
import re
import sys

import numpy as np

import passes
from fsbi import ellipsoid, plots
from fsbi.case import Case
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
SCHEMES = ["monolithic", "IQNILS", "Aitken", "semiImplicit", "explicit"]
WHOLE = ["monolithic", "monolithicOrder4"]
REASONS = "diverges|do not agree|reached a residual|turned inside out|not finite"

# Of Allrun: gamma dt, steps, Poisson's ratio, and the highest degree that
# triangles of 1.2 carry on a sphere of radius 4: pi 4/1.2
TURN, STEPS, NU, HIGHEST = 0.05, 3, 0.3, 10

# Largest mu/(G dt) that a scheme serves, by theory (passes.py). Repeated passes
# by a secant or a quasi-Newton method have no limit
LIMITS = {"semiImplicit": passes.relaxed_limit(0.5, NU, HIGHEST),
          "explicit": passes.explicit_limit(NU, HIGHEST)}

# bound: passes end at a residual, |factor - 1| |error| with factors below zero, of
# 1e-6 (rms) of the flow's largest speed 20 gamma: in a step 1e-6 20/4 0.05 of the
# radius, three times that at the tips, and three steps
AGREED = 9 * 1e-6 * 20 / 4 * TURN


class Run(Case):
    def __init__(self, folder):
        super().__init__(folder)
        self.scheme, self.ratio = name_of(folder)
        self.order = 4 if self.scheme.endswith("Order4") else 2
        self.passes = self.history["cost"]["corrections"]
        self.axes = self.history["elasticBodies/cell/semiAxes"].array[-1, 1:]


def name_of(folder):
    scheme, ratio = os.path.basename(folder).split(".", 1)
    return scheme, float(ratio)


def refusal(folder):
    """What a run says that could not make its steps; empty if it did."""
    with open(f"{folder}/log.fsbiFoam") as log:
        return "".join(re.findall(r"FATAL ERROR:\s*(.*)", log.read()))


def deformation_error(run):
    """Against the exact motion in the same steps."""
    exact = ellipsoid.Motion(ellipsoid.neo_hookean(NU), TURN * run.ratio)
    return abs(run.shape("cell")[1][-1] / exact.march(TURN, STEPS * TURN)[1][-1] - 1)


def fourth_order(results, runs):
    """What order 4 makes of the error on the same cells, at every ratio."""
    second = {run.ratio: run for run in runs if run.scheme == "monolithic"}
    for run in runs:
        if run.scheme == "monolithicOrder4":
            other = second[run.ratio]
            found, before = deformation_error(run), deformation_error(other)
            print(f"    r {run.ratio:g}: deformation off by {before:.2e} with order 2"
                  f" ({other.seconds:.1f} s), {found:.2e} with order 4 ({run.seconds:.1f} s)")
            # bound: asked for: errors four times smaller on equal cells
            results.add(f"order4_error_over_order2_r{run.ratio:g}_abs", found / before, 0, 0.25,
                        seconds=run.seconds, cells=run.cells)


def compare(runs, refused):
    results = Results("couplingSchemes")
    same = {(run.order, run.ratio): run.axes for run in runs if run.scheme in WHOLE}
    fourth_order(results, runs)
    for run in runs:
        cost = dict(seconds=run.seconds, cells=run.cells)
        name = f"{run.scheme}_r{run.ratio:g}"
        print(f"    {name}: passes {run.passes}, {run.seconds:.2f} s")
        if run.scheme in WHOLE:
            # bound: the project's aim for a step, from any ratio
            results.add(f"corrections_{name}_abs", run.passes.max(), 0, 5, **cost)
        else:
            difference = np.abs(run.axes / same[run.order, run.ratio] - 1).max()
            results.add(f"axes_{name}_abs", difference, 0, bound_of(run), **cost)
    for folder, reason in refused.items():
        scheme, ratio = name_of(folder)
        print(f"    {scheme}_r{ratio:g}: {reason[:150]}")
        if ratio < LIMITS.get(scheme, np.inf):
            results.add(f"axes_{scheme}_r{ratio:g}_abs", np.nan, 0, AGREED)
        else:
            results.at_least(f"{scheme}_r{ratio:g}_beyond_limit_{LIMITS[scheme]:.2g}_says_why",
                             bool(re.search(REASONS, reason)), 1)
    results.write()


def bound_of(run):
    """bound: repeated passes agree; one pass a step leaves what theory says of the
    small strain of a sphere alone, here up to twice that for the finite one (the
    model's semi-axes change by 12 % at the softest) and the box"""
    if run.scheme == "explicit":
        return AGREED + 2 * passes.splitting(run.ratio, TURN, NU, STEPS)
    return AGREED


def draw(runs, refused):
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(8.4, 3.6))
    for i, scheme in enumerate(SCHEMES):
        these = sorted((r for r in runs if r.scheme == scheme),
                       key=lambda r: r.ratio)
        style = dict(color=plots.COLOURS[i], marker=plots.MARKERS[i], label=scheme)
        ratios = [r.ratio for r in these]
        left.loglog(ratios, [r.passes.mean() for r in these], **style)
        right.loglog(ratios, [r.solve_seconds / len(r.passes) for r in these],
                     **style)
        failed = [name_of(f)[1] for f in refused if name_of(f)[0] == scheme]
        for axes, top in ((left, 100), (right, 15)):
            axes.plot(failed, [top * 1.25**i] * len(failed), color=plots.COLOURS[i],
                      marker="x", ls="none", mew=2)
    left.plot([], [], color="grey", marker="x", ls="none", mew=2, label="no solution")
    left.set(xlabel="µ/(G Δt)", ylabel="passes (Newton's corrections) a step")
    right.set(xlabel="µ/(G Δt)", ylabel="seconds a step, solvers")
    left.legend(fontsize=8, loc="upper left")
    plots.save(figure, "passes.png")


def main():
    folders = sorted(glob.glob("runs/*.*"))
    refused = {folder: refusal(folder) for folder in folders if refusal(folder)}
    runs = [Run(folder) for folder in folders if folder not in refused]
    compare(runs, refused)
    if not quick:
        draw(runs, refused)


if __name__ == "__main__":
    main()
