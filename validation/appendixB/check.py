# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of gradients and of the drag by scheme; write results.csv and draw."""

import csv
import glob
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.convergence import orders
from fsbi.results import Results

DRAG = 6 * np.pi * 8 * 1.4e-4           # 6 pi mu a U
NAMES = {
    ("vertex", "reconstructed"): "default",
    ("vertex", "linear"): "vertex, linear faces",
    ("Gauss", "linear"): "Gauss, linear faces",
    ("leastSquares", "linear"): "least squares, linear faces",
    ("leastSquares", "reconstructed"): "least squares, reconstructed",
}
COLOUR = {"vertex": 0, "Gauss": 1, "leastSquares": 2}
KINDS = {"hexahedra": "-", "perturbed": "--", "tetrahedra": ":"}
quick = sys.argv[1:2] == ["true"]
results = Results("appendixB")


def gradients():
    """Mesh widths and errors by kind of cell, flow and scheme."""
    table = {}
    with open("runs/gradients.csv", newline="") as file:
        for row in csv.DictReader(file):
            key = row["cells"], row["flow"], row["gradients"]
            table.setdefault(key, []).append((float(row["h"]), float(row["error"])))
    return {key: np.array(rows).T for key, rows in table.items()}


def check_gradients(table):
    for kind in KINDS:
        for scheme in ("vertex", "leastSquares"):
            # bound: both are built to be exact for linear fields: round-off
            results.add(f"linear_{scheme}_{kind}_abs", table[kind, "linear", scheme][1].max(),
                        0, 1e-8)
            # bound: of what is exact for linear fields: first order; quick and
            # full alike on three meshes, a tenth below for their irregularity
            results.at_least(f"Stokes_order_{scheme}_{kind}",
                             orders(*table[kind, "Stokes", scheme])[-1], 0.9)
    # bound: linear faces are exact where lines between centres cross faces in
    # the middle, otherwise off by a part that is the same on finer meshes (an
    # order of zero): three quarters of it must be there on the finest
    results.add("linear_Gauss_hexahedra_abs", table["hexahedra", "linear", "Gauss"][1].max(),
                0, 1e-8)
    for kind in ("perturbed", "tetrahedra"):
        error = table[kind, "linear", "Gauss"][1]
        results.at_least(f"linear_Gauss_{kind}_finest_over_coarsest", error[-1] / error[0],
                         0.75)


def drags():
    """Cells and drag over Stokes's by scheme, and the runs."""
    found = {}
    for scheme in NAMES:
        runs = [Case(f) for f in glob.glob(f"runs/{scheme[0]}_{scheme[1]}_*")]
        found[scheme] = sorted(runs, key=lambda run: run.cells)
    return found


def drag(run):
    return run.force("tumourCell")[-1, 0] / DRAG


def check_drags(found):
    # bound: at 6 and 9.5 cells per radius, as in validation/B1-fluidForces
    run = found["vertex", "reconstructed"][-1]
    results.add("drag_default", drag(run), 1, 0.01 if quick else 0.002,
                seconds=run.seconds, cells=run.cells)
    for scheme in NAMES:
        if scheme[1] == "linear":
            # bound: a prototype on other meshes found 3 to 13 % and no fall with
            # the mesh: such a scheme does not reach 1 %
            run = found[scheme][-1]
            results.at_least(f"drag_error_{scheme[0]}_linear", abs(drag(run) - 1), 0.01,
                             seconds=run.seconds, cells=run.cells)
    # bound: a prototype took 2 to 3 times the iterations with least squares
    ratio = (found["leastSquares", "reconstructed"][-1].iterations[0]
             / found["vertex", "reconstructed"][-1].iterations[0])
    results.at_least("iterations_leastSquares_over_default", ratio, 1.5)


def draw(table, found):
    below = dict(fontsize=7, ncols=3, loc="upper center", bbox_to_anchor=(0.5, -0.17))
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(11, 4.8))
    for (kind, line) in KINDS.items():
        for scheme, colour in COLOUR.items():
            h, error = table[kind, "Stokes", scheme]
            left.loglog(h, error, line, marker=plots.MARKERS[colour],
                        color=plots.COLOURS[colour], label=f"{scheme}, {kind}")
    left.set(xlabel="cells' width / radius", ylabel="relative error of the gradient")
    left.set_title("Gradients of Stokes's flow at cells", loc="left")
    left.xaxis.set_minor_formatter("")
    left.legend(**below)
    for i, (scheme, runs) in enumerate(found.items()):
        right.loglog([run.cells for run in runs], [abs(drag(run) - 1) for run in runs],
                     marker=plots.MARKERS[i], color=plots.COLOURS[i], label=NAMES[scheme])
    right.set(xlabel="tetrahedra", ylabel="relative error of the drag")
    right.set_title("Drag on a sphere", loc="left")
    right.legend(**below)
    plots.save(figure, "gradients.png")


def main():
    errors, runs = gradients(), drags()
    check_gradients(errors)
    check_drags(runs)
    for scheme, cases in runs.items():
        print(f"    {NAMES[scheme]}: " + ", ".join(
            f"{run.cells} cells {100 * (drag(run) - 1):+.2f} % in {run.iterations[0]:.0f}"
            " iterations" for run in cases))
    if not quick:
        draw(errors, runs)
    results.write()


if __name__ == "__main__":
    main()
