# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces in gaps against exact ones: results.csv, gaps.png."""

import os
import re
import sys

import numpy as np
from bispherical import mirror, wall

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

STOKES = 6 * np.pi * 4 * 1e-3           # radius, velocity
EXACT = {"wall": wall, "pair": lambda gap: mirror(gap / 2)}
NAMES = {"wall": "a sphere and a wall", "pair": "two spheres"}
results = Results("N1")


def rows(kind, order):
    """(gap in radii, error of the force, run), wide to narrow."""
    found = [(float(match[1]), Case(f"runs/{name}")) for name in os.listdir("runs")
             if (match := re.fullmatch(f"{kind}_(.*)_order{order}", name))]
    return [(gap, abs(run.force("a")[-1, 1]) / STOKES / EXACT[kind](gap) - 1, run)
            for gap, run in sorted(found, key=lambda row: -row[0])]


def add(kind, order, gap, error, run):
    # bound: the project's goal: 2 %
    results.add(f"force_{kind}", 1 + error, 1, 0.02, seconds=run.seconds, cells=run.cells,
                variant=f"gap {gap:g}, order {order}")
    print(f"    {kind} {gap:5g} radii, order {order}: {100 * error:8.3f} %, {run.cells:7d} "
          f"cells, {run.iterations[0]:3.0f} iterations, {run.seconds:5.1f} s")


def draw(table):
    figure, axes = plots.plt.subplots(1, 2, figsize=(9, 4.2), sharey=True)
    for a, kind in zip(axes, EXACT):
        for i, order in enumerate((4, 2)):
            a.loglog(*np.transpose([(gap, 100 * abs(error))
                                    for gap, error, _ in table[kind, order]]),
                     color=plots.COLOURS[i], marker=plots.MARKERS[i], mfc="white",
                     label=f"order {order}")
        a.set_title(NAMES[kind], loc="left")
        a.set(xlabel="gap over the radius")
    axes[0].set(ylabel="error of the force (%)")
    axes[0].legend()
    plots.save(figure, "gaps.png")


def main():
    table = {(kind, order): rows(kind, order) for kind in EXACT for order in (2, 4)}
    for (kind, order), found in table.items():
        for row in found:
            add(kind, order, *row)
    if sys.argv[1:2] != ["true"]:
        draw(table)
    results.write()


if __name__ == "__main__":
    main()
