# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Error of the bent rod's end against seconds: results.csv, peer.csv, a picture."""

import csv
import glob
import json
import os
import sys

import numpy as np

from fsbi import fields, plots
from fsbi.case import Case
from fsbi.errors import Study
from fsbi.results import Results

LENGTH = 10
LITERATURE = 1.8e-4     # error of the stress of a plate with a hole, l2
PEER = "kind degree across cells x y Newton seconds memory".split()
quick = sys.argv[1:2] == ["true"]
results = Results("H2")


def least(path):
    """Processor's seconds, wall's, megabytes of the repetition with the least."""
    return min(np.loadtxt(path, delimiter=",", ndmin=2).tolist())


def own():
    """Coarse to fine; seconds without the loading of libraries."""
    loading = 0 if quick else least("runs/loading.csv")[0]
    rows = []
    for folder in glob.glob("runs/*.order*"):
        kind, order, across = os.path.basename(folder).split(".")
        run = Case(folder)
        points = fields.points(folder + "/constant/polyMesh/points")
        # tetrahedra have no vertex in the middle of the end
        place = fields.at(points, points + fields.internal(folder + "/1/beam/pointD"),
                          (LENGTH, 0.5, 0.5))
        seconds, _, memory = least(folder + "/costs.csv")
        rows.append(dict(kind=kind, method=order, across=int(across), cells=run.cells,
                         x=place[0], y=place[1], seconds=seconds - loading,
                         memory=memory, Newton=run.history["cost"]["corrections"][-1]))
    return sorted(rows, key=lambda r: r["cells"])


def peer():
    """Of this run; those committed where there is no dolfinx."""
    if os.path.isfile("runs/peer.jsonl"):
        with open("runs/peer.jsonl") as file:
            rows = [json.loads(line) for line in file]
        best = {}
        for row in sorted(rows, key=lambda r: -r["seconds"]):
            best[row["kind"], row["degree"], row["across"]] = row
        with open("peer.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, PEER, lineterminator="\n")
            writer.writeheader()
            for key in sorted(best):
                writer.writerow({k: f"{v:.8g}" if isinstance(v, float) else v
                                 for k, v in best[key].items()})
    with open("peer.csv", newline="") as file:
        return [{k: v if k == "kind" else float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]


def error(row, reference):
    """Distance of the ends over the way that it goes."""
    end = np.array([reference["x"], reference["y"]])
    return (np.linalg.norm(end - (row["x"], row["y"]))
            / np.linalg.norm(end - (LENGTH, 0.5)))


def beam_end(length):
    """Of force over E and the section's area 1, nu 0: Timoshenko."""
    return 4 * length**3 + 2 * length / (5 / 6)


def cantilevers(loading):
    for folder in sorted(glob.glob("runs/cantilever.*")):
        _, kind, across = folder.split(".")
        points = fields.points(folder + "/constant/polyMesh/points")
        moved = fields.at(points, fields.internal(folder + "/1/beam/pointD"), (20, 0.5, 0.5))
        cost = dict(seconds=least(folder + "/costs.csv")[0] - loading,
                    cells=Case(folder).cells, variant=f"{kind}_{across}_across")
        # bound: asked for. A root that cannot warp takes some 1e-5 off the theory
        results.add("cantilever", moved[1], 5e-8 * beam_end(20), 0.001, **cost)
        if not quick:
            # bound: asked for
            results.add("cantilever_seconds_abs", cost["seconds"], 0, 0.3, **cost)


def plates(loading):
    """Relative to the l2 norm of the exact stress."""
    study = Study("runs/plate.*")
    for i, run in enumerate(study.runs):
        name = run.folder.removeprefix("runs/plate.")
        cost = dict(seconds=least(run.folder + "/costs.csv")[0] - loading, cells=run.cells,
                    variant=name.replace(".", "x"))
        columns = np.prod([int(n) for n in name.split(".")])
        # bound: asked for, 64 000 cells of a plane mesh in the literature; quick: a
        # tenth of what second order makes of that on as many columns of cells
        bound = LITERATURE * (64000 / columns / 10 if quick else 1)
        for field, place in (("pointSigma", "vertices"), ("sigma", "cells")):
            results.add(f"plate_stress_of_{place}_abs", study.error(field)[i], 0, bound,
                        **cost)
        if not quick:
            # bound: asked for
            results.add("plate_seconds_abs", cost["seconds"], 0, 4, **cost)
    if not quick:
        # bounds: asked for
        results.at_least("plate_order_of_displacement", study.order("pointD"), 3.5)
        results.at_least("plate_order_of_stress", study.order("pointSigma"), 2.8)


def curve(label, rows, reference):
    return (label, [r["seconds"] for r in rows], [error(r, reference) for r in rows])


def main():
    elements = peer()
    reference = next(r for r in elements if r["degree"] == 3)
    elements = [r for r in elements if r["degree"] == 2]
    finest = max((r for r in elements if r["kind"] == "hexahedra"),
                 key=lambda r: r["across"])
    # bound: a tenth of what is asked for; quadratic elements, half as many across
    # as cubic ones have nodes, agree so far
    results.add("reference_abs", error(finest, reference), 0, 2e-4)
    rows = own()
    for row in rows:
        if row["method"] == "order4":
            cost = dict(seconds=row["seconds"], cells=row["cells"],
                        variant=f"{row['kind']}_{row['across']}_across")
            # bounds: asked for
            results.add("bending_abs", error(row, reference), 0, 0.001, **cost)
            if not quick:
                results.add("seconds_abs", row["seconds"], 0, 0.1, **cost)
    loading = 0 if quick else least("runs/loading.csv")[0]
    cantilevers(loading)
    plates(loading)
    if not quick:
        draw(rows, elements, reference)
    results.write()


def draw(rows, elements, reference):
    lines = []
    for kind in ("hexahedra", "tetrahedra"):
        for method, name in (("order4", "order 4"), ("order2", "order 2")):
            lines.append(curve(f"fsbiFoam, {name}, {kind}",
                               [r for r in rows if (r["method"], r["kind"]) == (method, kind)],
                               reference))
        lines.append(curve(f"quadratic elements (dolfinx), {kind}",
                           [r for r in elements if r["kind"] == kind], reference))
    plots.curves("accuracyPerSecondSolids.png", lines, xlabel="processor's seconds",
                 ylabel="error of the end", title="A rod bent far, one load step",
                 xlog=True, ylog=True)


if __name__ == "__main__":
    main()
