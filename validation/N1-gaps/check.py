# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces in gaps against exact ones: results.csv, gaps.png."""

import os
import re
import sys
from typing import Callable, NamedTuple

import numpy as np

from fsbi import plots
from fsbi.bispherical import mirror, wall
from fsbi.case import Case, reference
from fsbi.error_estimates import worth_of_estimates
from fsbi.results import Results

RADIUS, SPEED = 4, 1e-3                 # speed: of the centre or of the surface
STOKES = 6 * np.pi * RADIUS * SPEED


def tabulated(column):
    """Of reference.csv, at its own gaps only."""
    return lambda gap: next(row[column] for row in reference("reference.csv")
                            if row["gap"] == gap)


class Kind(NamedTuple):
    title: str
    exact: Callable                     # of the gap in radii
    measure: Callable                   # of a run, in the same unit


KINDS = {
    "wall": Kind("towards a wall", wall, lambda run: run.force("a")[-1, 1] / STOKES),
    "pair": Kind("two that approach", lambda gap: mirror(gap / 2),
                 lambda run: run.force("a")[-1, 1] / STOKES),
    "slide": Kind("along a wall", tabulated("Ft"),
                  lambda run: run.force("a")[-1, 0] / STOKES),
    "turn": Kind("turning at a wall: torque", tabulated("Tr"),
                 lambda run: run.torque("a")[-1, 2] / (8 / 6 * RADIUS * STOKES))}
SINKS = 2e-5                            # speed of the elastic sphere without a wall
results = Results("N1")
estimates = []                          # of the error of forces, and the error


def finished(folder):
    """None if its first step has not converged."""
    try:
        return Case(folder)
    except (OSError, KeyError, ValueError):
        return None


def rows(kind, order):
    """(gap in radii, error, run), wide to narrow."""
    found = [(float(match[1]), finished(f"runs/{name}")) for name in os.listdir("runs")
             if (match := re.fullmatch(f"{kind}_(.*)_order{order}", name))]
    part = KINDS[kind]
    return [(gap, abs(part.measure(run)) / part.exact(gap) - 1 if run else np.nan, run)
            for gap, run in sorted(found, key=lambda row: -row[0])]


def add(kind, order, gap, error, run):
    cost = dict(seconds=run.seconds, cells=run.cells) if run else {}
    # bound: the project's goal: 2 %
    results.add(f"{'torque' if kind == 'turn' else 'force'}_{kind}", 1 + error, 1, 0.02,
                variant=f"gap {gap:g}, order {order}", **cost)
    if run and order == 4:
        estimates.append((run.history["accuracy"]["forces"][-1], abs(error)))
    if not run:
        print(f"    {kind:5} {gap:6g} radii, order {order}: not converged")
        return
    print(f"    {kind:5} {gap:6g} radii, order {order}: {100 * error:8.3f} %, {run.cells:7d} "
          f"cells, {run.iterations[0]:3.0f} iterations, {run.seconds:5.1f} s")


def add_sinking():
    """The elastic sphere's speed at last, by what is exact at its height."""
    for name in sorted(os.listdir("runs")):
        if not (match := re.fullmatch("soft_(.*)_order2_sag(.*)", name)):
            continue
        gap, sag = float(match[1]), float(match[2])
        run = Case(f"runs/{name}")
        centre = run.history["elasticBodies/a/centre"]
        (t0, t1), (y0, y1) = centre["time"][-2:], centre["y"][-2:]
        value = (y0 - y1) / (t1 - t0) / SINKS * wall((0.5 * (y0 + y1) - RADIUS) / RADIUS)
        print(f"    elastic, {gap:g} radii, gapSag {sag:g}: {value:.5f}, {run.cells} cells, "
              f"{run.seconds:.0f} s")
        if sag > 0:
            # bound: the project's goal: 2 %
            results.add("speed_sinking_elastic", value, 1, 0.02, variant=f"gap {gap:g}",
                        seconds=run.seconds, cells=run.cells)


def draw(table):
    figure, axes = plots.plt.subplots(2, 2, figsize=(9, 7.4), sharey=True, sharex=True)
    for a, kind in zip(axes.flat, KINDS):
        for i, order in enumerate((4, 2)):
            a.loglog(*np.transpose([(gap, 100 * abs(error))
                                    for gap, error, _ in table[kind, order]]),
                     color=plots.COLOURS[i], marker=plots.MARKERS[i], mfc="white",
                     label=f"order {order}")
        a.axhline(2, color="0.7", lw=0.8)
        a.set_title(KINDS[kind].title, loc="left")
    for a in axes[1]:
        a.set(xlabel="gap over the radius")
    for a in axes[:, 0]:
        a.set(ylabel="error (%)")
    axes[0, 0].legend()
    plots.save(figure, "gaps.png")


def main():
    table = {(kind, order): rows(kind, order) for kind in KINDS for order in (2, 4)}
    for (kind, order), found in table.items():
        for row in found:
            add(kind, order, *row)
    add_sinking()
    if sys.argv[1:2] != ["true"]:
        worth_of_estimates(results, estimates)
        draw(table)
    results.write()


if __name__ == "__main__":
    main()
