# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs in full and by a table, on three meshes: error of the path against
processor's seconds. accuracyCost.csv, accuracyCost.png."""

import csv
import glob
import json

import numpy as np

from fsbi import plots
from fsbi.case import Case

SIZES = (1.6, 1.2, 0.96)       # um, edges on the sphere
FINEST = 0.7


def error(run, reference):
    """Largest distance of two paths at a time, over the length of the second."""
    x, y = run.position("a"), reference.position("a")
    return (np.linalg.norm(x - y, axis=1).max()
            / np.linalg.norm(np.diff(y, axis=0), axis=1).sum())


def sampling(folder):
    """Processor's seconds of all samples of a table, and cells of the largest."""
    records = []
    for path in glob.glob(f"{folder}/reduce/runs/*/run.json"):
        with open(path) as file:
            records.append(json.load(file))
    return sum(r["seconds"] for r in records), max(r["cells"] for r in records)


def measured():
    """Rows: way of running, edge, cells, seconds of the table, of the run, error."""
    reference = Case(f"runs/cost{FINEST}")
    rows = []
    for size in SIZES:
        full, short = Case(f"runs/cost{size}"), Case(f"runs/cost{size}.reduced")
        table, cells = sampling(short.folder)
        rows.append(("full", size, full.cells, 0.0, full.processor_seconds,
                     error(full, reference)))
        rows.append(("reduced", size, cells, table, short.processor_seconds,
                     error(short, reference)))
    return rows, reference


def draw(rows, reference):
    figure, axes = plots.plt.subplots(figsize=(6.4, 4.4))
    for i, (way, label, columns) in enumerate((
            ("full", "in full", (4,)),
            ("reduced", "by a table that is there", (4,)),
            ("reduced", "table and one run", (3, 4)))):
        mine = [r for r in rows if r[0] == way]
        x, y = [sum(r[c] for c in columns) for r in mine], [r[5] for r in mine]
        axes.plot(x, y, color=plots.COLOURS[i], marker=plots.MARKERS[i], mfc="white",
                  ls=":" if len(columns) == 2 else "-", label=label)
        for a, b, r in zip(x, y, mine):
            axes.annotate(f"{r[1]:g}", (a, b), (5, 5), textcoords="offset points", fontsize=8.5)
    plots.plain_logarithm(axes)
    axes.set(xlabel="processor's seconds", ylabel="error of the path", yscale="log")
    axes.yaxis.set_major_locator(plots.matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_minor_formatter(plots.matplotlib.ticker.NullFormatter())
    axes.yaxis.set_major_formatter(lambda y, _: f"{100 * y:g} %")
    axes.set_title(f"A sphere beside a wall, edges beside points (µm); error against {FINEST} µm, "
                   f"{reference.processor_seconds:.0f} s", loc="left", fontsize=9.5)
    axes.legend(loc="best", fontsize=9)
    plots.save(figure, "accuracyCost.png")


def main():
    rows, reference = measured()
    rows.append(("full", FINEST, reference.cells, 0.0, reference.processor_seconds, 0.0))
    with open("accuracyCost.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("way", "edge", "cells", "tableSeconds", "runSeconds", "pathError"))
        for way, size, cells, table, run, off in rows:
            writer.writerow((way, size, cells, f"{table:.2f}", f"{run:.2f}", f"{off:.4g}"))
            print(f"    {way}, edges {size:g} um: {cells} cells, table {table:.1f} s, run "
                  f"{run:.2f} s, error {100 * off:.2g} %")
    draw(rows[:-1], reference)


if __name__ == "__main__":
    main()
