# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the resistance matrices of the helix with the independent values;
write results.csv and draw."""

import csv
import glob
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.results import Results

# Boundary integrals (regularised Stokeslets on the surface, refined until they
# changed by 0.05 %), F = a u + b w, T = b u + c w along the axis: R 1, pitch 2,
# filament radius 0.1, 5 turns, mu 1
EXACT = {"a": 36.269, "b": -3.2769, "c": 85.948}
ADVANCE = {"axis_held": 0.09082, "axial_only": 0.09035}

quick = sys.argv[1] == "true"
results = Results("S7")


def read(folder):
    with open(folder + "/postProcessing/resistance.csv") as file:
        rows = list(csv.reader(file))
    R = np.array([[float(x) for x in row[2:8]] for row in rows[1:]])
    with open(folder + "/log.fsbiResistance") as file:
        log = file.read()
    cells = int(re.search(r"Cells: (\d+)", log)[1])
    seconds = float(re.search(r"^ *total +([0-9.]+) s", log, re.M)[1])
    return R, cells, seconds


def measures(R):
    """Axial laws, and advance per angle: only axial motion; any translation."""
    free = np.linalg.solve(R[:3, :3], -R[:3, 5])
    return {"a": R[2, 2], "b": 0.5 * (R[2, 5] + R[5, 2]), "c": R[5, 5],
            "axis_held": free[2], "axial_only": -R[2, 5] / R[2, 2]}


def asymmetry(R):
    scale = np.sqrt(np.outer(np.diag(R), np.diag(R)))
    return np.abs((R - R.T) / scale).max()


edges = sorted((float(f.removeprefix("runs/edge")) for f in glob.glob("runs/edge*")),
               reverse=True)
errors = {name: [] for name in (*EXACT, *ADVANCE)}
for edge in edges:
    R, cells, seconds = read(f"runs/edge{edge:g}")
    cost = dict(seconds=seconds, cells=cells)
    for name, value in measures(R).items():
        exact = {**EXACT, **ADVANCE}[name]
        results.add(f"{name}_edge{edge:g}", value, exact, 0.03, **cost)
        errors[name].append(abs(value / exact - 1))
    results.add(f"asymmetry_edge{edge:g}_abs", asymmetry(R), 0, 2e-3, **cost)

if len(edges) > 2:
    figure, axes = plots.plt.subplots()
    for i, (name, error) in enumerate(errors.items()):
        axes.loglog(edges, error, "o-", mfc="white", color=plots.COLOURS[i % 5],
                    ls="-" if i < 3 else "--", label=name.replace("_", " "))
    axes.loglog(edges, 0.02 * (np.array(edges) / edges[0]) ** 2, color="0.6", ls=":",
                label="second order")
    axes.set(xlabel="edge on the filament (radius 0.1 µm)", ylabel="relative error")
    axes.set_title("Helix: resistance and advance", loc="left")
    axes.legend(fontsize=9)
    plots.save(figure, "convergence.png")
results.write()
