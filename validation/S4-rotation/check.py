# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest stress over Young's modulus, in every step of every run; the
stress that turns with a stretched sphere, or does not."""

import os
import sys

import numpy as np

import stretched
from fsbi import fields, plots
from fsbi.case import Case, cases
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
YOUNG = 0.504e-3        # pg/um/us2
# bound: the solver's tolerance (1e-13 of the forces) times the number of cells
# across (10) squared, which is how far an error of forces adds up in the
# displacement
BOUND = 1e-10
FORMULATIONS = ("totalLagrangian", "updatedLagrangian", "slowProcess",
                "slowProcessTotalStrain")


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


def stress_of_stretched(run):
    """Means over the body at times 1, 2, ..., over E; largest scatter."""
    means, scatter = [], 0
    for time in range(1, stretched.STEPS + 2):
        rows = fields.internal(f"{run.folder}/{time}/sphere/sigma") / YOUNG
        tensors = rows[:, [0, 1, 2, 1, 3, 4, 2, 4, 5]].reshape(-1, 3, 3)
        means.append(tensors.mean(axis=0))
        scatter = max(scatter, np.abs(tensors - means[-1]).max())
    return np.array(means), scatter


def departure(stresses):
    """Of the last stress from the one that turned with the body, relative."""
    exact = stretched.stresses("totalLagrangian")[-1]
    return np.linalg.norm(stresses[-1] - exact) / np.linalg.norm(exact)


def turned_when_stretched():
    """Every formulation has the stress of its definition; slowProcess leaves
    the stress where it was, which a test of rigid rotation cannot see."""
    for formulation in FORMULATIONS:
        run = Case(f"runs/tetrahedra-{formulation}-stretched")
        found, scatter = stress_of_stretched(run)
        expected = stretched.stresses(formulation)
        cost = dict(seconds=run.seconds, cells=run.cells)
        # bound: as BOUND; the error is over E, as there
        error = np.abs(found - expected).max() + scatter
        results.add(f"stretched_then_turned_{formulation}_abs", error, 0, BOUND,
                    **cost)
        if formulation.startswith("slowProcess"):
            # bound: BOUND over the stress, 0.05 E
            results.add(f"stretched_then_turned_{formulation}_departs",
                        departure(found), departure(expected), 2e-9)


results = Results("S4")


def main():
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
    turned_when_stretched()
    results.write()


if __name__ == "__main__":
    main()
