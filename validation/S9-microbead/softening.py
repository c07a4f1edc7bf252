# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What becomes of the bead with the law of the source: from the scene's own
start, and softened step by step from a sphere. Appends to results.csv, draws."""

import glob
import os
import sys

import numpy as np

from fsbi import plots
from fsbi.case import reference
from fsbi.history import History
from fsbi.results import Results

RATE = 5e-5
REFERENCE = os.path.join(os.environ["FSBI_DIR"], "validation", "B2-elasticSphere", "reference")
SCENE = 0.225           # capillary number of the scene
SOFT = "StVenantKirchhoff.totalLagrangian"
SLOW = "StVenantKirchhoff.slowProcess"
NEO = "neoHookean.totalLagrangian"
quick = sys.argv[1:2] == ["true"]
results = Results("S9")


class Loads:
    """A run whose bead was made softer and softer."""

    def __init__(self, folder):
        self.folder = folder
        with open(folder + "/loads") as file:
            rows = np.array([line.split() for line in file], float)
        with open(folder + "/log.fsbiFoam") as log:
            self.said = log.read()
        lost = "FATAL" in self.said
        self.lost = rows[-1, 0] if lost else None
        self.Ca, self.end = rows[:len(rows) - lost].T

    def read_shapes(self):
        bead = "elasticBodies/microbead/"
        history = History(self.folder + "/postProcessing/history.h5")
        axes, strain = history[bead + "semiAxes"], history[bead + "deformation"]
        self.time, self.stretch = strain["time"], strain["minStretch"]
        self.D = ((axes["longest"] - axes["shortest"])
                  / (axes["longest"] + axes["shortest"]))
        return self

    def at_end(self, values, before=0.0):
        """At the end of every load, or some shear times before."""
        return np.interp(self.end - before / RATE, self.time, values)

    def says_why(self):
        return "FATAL" in self.said and "softens in compression" in self.said


def starts():
    for folder in sorted(glob.glob("runs/start_*_0.[1-9]_*")):
        run = Loads(folder)
        _, law, share, Ca = os.path.basename(folder).split("_")
        name = f"{law}_flattened{share}_Ca{Ca}"
        # bound: it ends, or stops with the law's message
        if float(share) == 0.5:
            results.at_least(name + "_says_why", run.says_why(), 1)
        else:
            results.at_least(name + "_ends", run.lost is None, 1)


def steady(run, law):
    """Do the loads that were carried settle? The largest change allowed."""
    stretch = run.at_end(run.stretch)
    creep = np.abs(stretch - run.at_end(run.stretch, 0.5))
    steps = np.abs(np.diff(stretch, append=2 * stretch[-1] - stretch[-2]))
    for Ca, change, step in zip(run.Ca, creep, steps):
        # bound: in half a shear time a fifth of what the next load makes (the last:
        # of what it has made itself)
        results.add(f"{law}_Ca{Ca:g}_still_changes_abs", change, 0, 0.2 * step)
    return 0.2 * steps.max()


def compare(runs):
    fold = {row["nu"]: row["Ca"] for row in reference(REFERENCE + "/fold.csv")}[0.133]
    soft, neo = runs[SOFT], runs[NEO]
    allowed = max(steady(soft, SOFT), steady(neo, NEO))
    # bound: a wall and a tether load the bead besides the shear: the fold comes at
    # a Ca below that of a free sphere
    results.at_least("free_fold_over_lost_Ca", fold / (soft.lost or np.inf), 1)
    # bound: the message is there or it is not
    results.at_least("lost_says_why", soft.says_why(), 1)
    # bound: the capillary number of the scene
    results.at_least(NEO + "_carries_Ca", neo.Ca[-1], SCENE)
    return allowed


def slow_process(allowed):
    """From a sphere: it neither fails nor settles."""
    found = {}
    for folder in sorted(glob.glob(f"runs/start_{SLOW}_0_*")):
        run = Loads(folder).read_shapes()
        found[run.Ca[-1]] = run
        # bound: it ends or it does not
        results.at_least(f"{SLOW}_Ca{run.Ca[-1]:g}_ends", run.lost is None, 1)
    run = found[SCENE]
    creep = (run.at_end(run.stretch, 0.5) - run.at_end(run.stretch))[-1]
    # bound: after three shear times still more in half of one than any shape above
    # may change that counts as steady
    results.at_least(f"{SLOW}_Ca{SCENE:g}_creeps", creep, allowed)
    return found


def draw(runs, slow):
    figure, axes = plots.plt.subplots(1, 3, figsize=(13.4, 4.2))
    for i, (law, run) in enumerate(runs.items()):
        name = law.removesuffix(".totalLagrangian")
        for axis, key, values in ((axes[0], "D", run.D), (axes[1], "shortest", run.stretch)):
            exact = reference(f"{REFERENCE}/{name[0].upper()}{name[1:]}.csv")
            axis.plot([r["Ca"] for r in exact], [r[key] for r in exact], lw=1.1, ls="--",
                      color=plots.COLOURS[i], label=f"{name}, free sphere (exact)")
            axis.plot(run.Ca, run.at_end(values), color=plots.COLOURS[i],
                      marker=plots.MARKERS[i], mfc="white", label=f"{name}, beside the wall")
            if run.lost:
                axis.axvspan(run.Ca[-1], run.lost, color=plots.COLOURS[i], alpha=0.2, lw=0)
    for i, (Ca, run) in enumerate(slow.items()):
        axes[2].plot(RATE * run.time, run.stretch, color=plots.COLOURS[2 + i],
                     label=f"µγ/G = {Ca:g}")
    axes[2].set(xlabel="time × shear rate", ylabel="smallest principal stretch", ylim=(0, 1),
                xlim=(0, 3))
    axes[2].legend()
    axes[2].set_title("St.Venant-Kirchhoff, slowProcess, beside the wall", loc="left", fontsize=9.5)
    for axis, label in zip(axes, ("deformation (L−B)/(L+B)", "smallest principal stretch")):
        axis.axvline(SCENE, color="black", lw=0.8, ls=":")
        axis.set(xlabel="µγ/G", ylabel=label, xlim=(0, 0.27))
    axes[0].set_ylim(0, 0.6)
    axes[1].set_ylim(0.3, 1)
    axes[1].axhline(1 / np.sqrt(3), color="black", lw=0.8, ls=":")
    axes[0].legend(fontsize=8)
    axes[0].set_title("Dotted: the scene. Shaded: lost in between",
                      loc="left", fontsize=9.5)
    axes[1].set_title("Dotted: 1/√3, where the law has no stiffness left", loc="left",
                      fontsize=9.5)
    plots.save(figure, "softening.png")


def main():
    starts()
    if not quick:
        laws = {law: Loads("runs/continuation_" + law).read_shapes()
                for law in (SOFT, NEO)}
        draw(laws, slow_process(compare(laws)))
    results.write(append=True)


if __name__ == "__main__":
    main()
