# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare steps on the old mesh and on a new one; write results.csv and draw."""

import glob
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

CELL, BEAD = "elasticBodies/cell/", "bodies/bead/"
STEP = 1000                             # us
TIMES = range(STEP, 20 * STEP, STEP)    # saved states with a step to follow
FORCES = {
    "tether_of_cell": CELL + "tether",
    "force_on_bead": BEAD + "force/fluid",
    "torque_on_bead": BEAD + "torque/fluid",
}
quick = sys.argv[1] == "true"
results = Results("remeshing")


def last(run, table):
    return run.history[table].array[-1, 1:]


def rows(run, table):
    return run.history[table].array[:, 1:]


def remeshings(run):
    with open(f"{run.folder}/log.fsbiFoam") as log:
        return len(re.findall("^Remeshing", log.read(), re.M))


def stored(time, name):
    """A saved field of the cell, all processors' parts."""
    parts = glob.glob(f"runs/remeshed/{time}/cell/state/{name}") or sorted(
        glob.glob(f"runs/remeshed/processor*/{time}/cell/state/{name}"))
    fields = []
    for part in parts:
        with open(part, "rb") as file:
            content = file.read()
        head = re.search(rb"\n(\d+)\n\(", content)
        rest = content[head.end():]
        # vectors or scalars: up to the closing bracket
        fields.append(np.frombuffer(rest[:rest.rindex(b")")]))
    return np.concatenate(fields)


def state_change(time):
    """The body as the step that makes the new mesh finds it, which is its end
    less its increment, against the body as it was saved before."""
    before = stored(time, "solution")
    found = stored(time + STEP, "solution") - stored(time + STEP, "increment")
    return np.abs(found - before).max() / np.abs(before).max()


def force_changes(table):
    """Relative to the force of the same step on the old mesh."""
    kept = np.array([last(Case(f"runs/kept.{time}"), table) for time in TIMES])
    anew = rows(remeshed, table)[1:]
    return np.linalg.norm(anew - kept, axis=1) / np.linalg.norm(kept, axis=1)


def spread(run, fine, table):
    """Relative difference of two mesh sizes, the mean of all steps."""
    coarse, exact = rows(run, table), rows(fine, table)
    return np.mean(np.linalg.norm(coarse - exact, axis=1) / np.linalg.norm(exact, axis=1))


def draw(changes, sizes):
    figure, axes = plots.plt.subplots()
    for i, (name, change) in enumerate(changes.items()):
        axes.semilogy(range(2, 21), change, color=plots.COLOURS[i],
                      marker=plots.MARKERS[i], ls="none", label=name.replace("_", " "))
        axes.axhline(sizes[name], color=plots.COLOURS[i], ls="--", lw=1)
    axes.set(xticks=range(2, 21, 2), ylim=(2e-4, 0.05), xlabel="remeshing",
             ylabel="relative change of the force")
    axes.set_title("A new mesh (points) and two sizes of cells (lines)", loc="left")
    axes.legend(loc="lower right", ncols=3, fontsize=9)
    plots.save(figure, "forces.png")


remeshed, kept, fine = (Case(f"runs/{name}") for name in ("remeshed", "kept", "fine"))
cost = dict(seconds=remeshed.seconds, cells=remeshed.cells)

results.at_least("remeshings", remeshings(remeshed), 20, **cost)
results.add("remeshings_without_abs", remeshings(kept), 0, 0.5)
results.add("body_change_abs", max(map(state_change, TIMES)), 0, 1e-10, **cost)
changes, sizes = {}, {}
for name, table in FORCES.items():
    changes[name] = force_changes(table)
    sizes[name] = spread(remeshed, fine, table)
    results.add(f"{name}_abs", changes[name].mean(), 0, sizes[name], **cost)
    print(f"    {name}: changes by {changes[name].mean():.2g}, at most "
          f"{changes[name].max():.2g}; between two mesh sizes {sizes[name]:.2g}")
axes = CELL + "semiAxes"
results.add("shape_after_20_abs",
            np.abs(last(remeshed, axes) / last(kept, axes) - 1).max(), 0,
            np.abs(last(remeshed, axes) / last(fine, axes) - 1).max(), **cost)
if not quick:
    draw(changes, sizes)
results.write()
