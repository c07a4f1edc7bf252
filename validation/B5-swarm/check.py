# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does every body reach its own target, with the one field and the currents
that the coils may have? Writes results.csv."""

import glob
import itertools
import os
import re

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results
from plan import plan

RADIUS, VIA = 5, (9, 18)                            # um
TOLERANCE, LIMIT, FIELD = 0.5, 1, 1e-3              # um, A, T
FACTOR = 0.8**1.5 * 4e-7 * np.pi * 100 / 0.05       # of the Helmholtz pairs, T/A
results = Results("B5")


def crossings(a, b):
    """How often two paths cross."""
    r, s = np.diff(a, axis=0)[:, None], np.diff(b, axis=0)[None]
    q = b[None, :-1] - a[:-1, None]
    with np.errstate(all="ignore"):
        along, across = np.cross(q, s) / np.cross(r, s), np.cross(q, r) / np.cross(r, s)
    return np.sum((along >= 0) & (along < 1) & (across >= 0) & (across < 1))


def obstacle(run, start, targets, arrival):
    """Far targets, one behind an obstacle, and paths that cross."""
    planned, time = plan(
        [x[:2] for x in start.values()], [[VIA, targets["weak"][:2]], [targets["middle"][:2]]],
        frequencies=(2e-6, 6e-6), advances=(1.25, 1.25), stepOuts=(3.4e-6, 10.3e-6))
    # bound: the scene's end, 1.5 times the plan
    results.add("time_over_plan", arrival / time, 1, 0.5)
    ways = {body: np.vstack([start[body], run.position(body)])[:, :2] for body in targets}
    for body, way in ways.items():
        # bound: issue, five radii
        results.at_least(f"way_over_radius_{body}",
                         np.linalg.norm(np.subtract(targets[body][:2], way[0])) / RADIUS, 5)
    # bound: theory, once and no touch; the obstacle is on the straight way if its centre
    # is less than two radii off
    results.at_least("paths_that_cross", crossings(*ways.values()), 1)
    centres = {**ways, "obstacle": np.zeros((1, 2))}
    for one, other in itertools.combinations(centres, 2):
        gap = np.linalg.norm(centres[one] - centres[other], axis=1).min() - 2 * RADIUS
        results.at_least(f"gap_over_radius_{one}_{other}", gap / RADIUS, 0.1)
    straight = np.linspace(ways["weak"][0], targets["weak"][:2], 1000)
    results.add("obstacle_off_straight_way_over_radius_abs",
                np.linalg.norm(straight, axis=1).min() / RADIUS, 0, 2)
    draw(ways, targets, planned)


def draw(ways, targets, planned):
    figure, axes = plots.plt.subplots(figsize=(6.4, 6))
    axes.add_patch(plots.plt.Circle((0, 0), RADIUS, color="0.8"))
    axes.text(0, 0, "obstacle", ha="center", va="center")
    for i, (body, way) in enumerate(ways.items()):
        axes.plot(*way.T, color=plots.COLOURS[i], label=body)
        for place, fill in ((way[0], False), (way[-1], True)):
            axes.add_patch(plots.plt.Circle(place, RADIUS, color=plots.COLOURS[i],
                                            fill=fill, alpha=0.5))
        axes.plot(*targets[body][:2], "+", color="black", ms=10)
        axes.plot(*planned[:, i].T, color=plots.COLOURS[i], ls=":", lw=1,
                  label="planned without interaction" if i else None)
    axes.plot(*VIA, "x", color=plots.COLOURS[0], ms=9, label="way point")
    axes.set(aspect="equal", xlabel="x (µm)", ylabel="y (µm)")
    axes.set_title("One field, two targets, an obstacle between", loc="left")
    axes.legend()
    plots.save(figure, "crossing.png")


def main():
    for folder in sorted(glob.glob("runs/*")):
        run, name = Case(folder), os.path.basename(folder)
        control = run.history["effects/magnetics/controller"]
        with open(folder + "/constant/effects") as file:
            targets = {name: [float(x) for x in place.split()] for name, place in
                       re.findall(r"(\w+)\s*\{\s*target\s*\(([^)]*)\)", file.read())}
        cost = dict(seconds=run.seconds, cells=run.cells)
        for body, target in targets.items():
            left = np.subtract(target, run.position(body)[-1])
            # bound: the controller's own tolerance
            results.add(f"distance_{body}_{name}_abs", np.linalg.norm(left[:2]), 0, TOLERANCE,
                        **cost)
        there = np.max([control[f"distance.{b}"] for b in targets], axis=0) <= TOLERANCE
        there &= control["leg"] == control["leg"].max()
        # bound: they stay there for a row of the history and more
        results.at_least(f"rest_at_targets_{name}", there.mean(), 0.01)
        current = np.array([control["I." + i] for i in "xyz"]).T
        on = control["mode"] > 0
        # bound: the currents' own limit
        results.add(f"largest_current_{name}_abs", np.abs(current).max(), 0, LIMIT)
        # the currents' own field is the one that bodies are in, the same for all
        for body in targets:
            magnet = run.history[f"effects/magnetics/{body}"]
            B = np.array([magnet["B" + i] for i in "xyz"]).T
            # bound: B and I come from one formula; ten times its constants' digits
            results.add(f"field_at_{body}_{name}_abs",
                        np.abs(B - FACTOR * current).max() / FIELD, 0, 1e-5)
        # bound: no current is none
        results.add(f"field_when_off_{name}_abs", np.abs(current[~on]).max(initial=0), 0, 0)
        if name == "crossing":
            obstacle(run, {"weak": (-15, 0, 5.6), "middle": (18, -21, 5.6)}, targets,
                     control["time"][there].min(initial=np.inf))
    results.write()


if __name__ == "__main__":
    main()
