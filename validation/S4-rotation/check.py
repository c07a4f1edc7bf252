# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest stress over Young's modulus, in every step of every run."""

import os
import sys

from fsbi import plots
from fsbi.case import cases
from fsbi.results import Results

quick = sys.argv[1] == "true"
YOUNG = 0.504e-3        # pg/um/us2
BOUND = 1e-10
FORMULATIONS = "totalLagrangian", "updatedLagrangian", "slowProcess"


def stress(run):
    """Angles in degrees and largest stress over E."""
    time, values = run.largest("stress", "sphere")
    turn = os.path.basename(run.folder).split("-")[2]
    return (10 if turn == "steps" else float(turn)) * time, values / YOUNG


def row(name, runs):
    worst = max(runs, key=lambda run: max(stress(run)[1]))
    results.add(f"stress_over_E_{name}_abs", max(stress(worst)[1]), 0, BOUND,
                seconds=sum(run.seconds for run in runs),
                cells=max(run.cells for run in runs))


results = Results("S4")
figure, axes = plots.plt.subplots()
axes.axhline(BOUND, color="black", lw=1.2, label="bound")
for colour, formulation in zip(plots.COLOURS, FORMULATIONS):
    at_once = cases(f"runs/*-{formulation}-[0-9]*")
    in_steps = cases(f"runs/*-{formulation}-steps")
    row(f"{formulation}_in_one_step", at_once)
    row(f"{formulation}_in_steps", in_steps)
    for run in in_steps:
        hexahedra = "hexahedra" in run.folder
        axes.semilogy(*stress(run), color=colour, ls="--" if hexahedra else "-",
                      label=f"{formulation}, {'hexa' if hexahedra else 'tetra'}hedra")
    for run in at_once:
        axes.semilogy(*stress(run), color=colour, ls="none", mfc="white",
                      marker="s" if "hexahedra" in run.folder else "o")
axes.set(xlabel="angle (degrees)", ylabel="largest stress / E", ylim=(1e-15, 1e-7))
axes.set_title("Rigid rotation: in steps of 10° (lines), at once (markers)",
               loc="left")
axes.legend(fontsize=8, ncols=2, loc="upper left")
if not quick:
    plots.save(figure, "stress.png")
results.write()
