# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare steps on the old mesh and on a new one; write results.csv and draw."""

import csv
import glob
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results
from quantities import AXES, FORCES, rows

STEP = 1000                             # us
TIMES = range(STEP, 20 * STEP, STEP)    # saved states with a step to follow
quick = sys.argv[1:2] == ["true"]
results = Results("remeshing")


def last(run, table):
    return run.history[table].array[-1, 1:]


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


def force_changes(remeshed, table):
    """Relative to the force of the same step on the old mesh."""
    kept = np.array([last(Case(f"runs/kept.{time}"), table) for time in TIMES])
    anew = rows(remeshed, table)[1:]
    return np.linalg.norm(anew - kept, axis=1) / np.linalg.norm(kept, axis=1)


def errors():
    """Of this size of cells, by the study: the first of its errors."""
    with open("study.csv", newline="") as file:
        return {row[0]: float(row[1]) for row in list(csv.reader(file))[1:]}


def draw(changes, sizes):
    figure, axes = plots.plt.subplots()
    for i, (name, change) in enumerate(changes.items()):
        axes.semilogy(range(2, 21), change, color=plots.COLOURS[i],
                      marker=plots.MARKERS[i], ls="none", label=name.replace("_", " "))
        axes.axhline(sizes[name], color=plots.COLOURS[i], ls="--", lw=1)
    axes.set(xticks=range(2, 21, 2), ylim=(2e-4, 0.05), xlabel="remeshing",
             ylabel="relative change of the force")
    axes.set_title("A new mesh (points) and the error of its size (lines)", loc="left")
    axes.legend(loc="lower right", ncols=3, fontsize=9)
    plots.save(figure, "forces.png")


def main():
    remeshed, kept = (Case(f"runs/{name}") for name in ("remeshed", "kept"))
    cost = dict(seconds=remeshed.seconds, cells=remeshed.cells)

    # bound: what the scene asks for: a new mesh in each of 20 steps, and none
    results.at_least("remeshings", remeshings(remeshed), 20, **cost)
    results.add("remeshings_without_abs", remeshings(kept), 0, 0.5)
    # bound: copied, not computed: round-off, of sums of two numbers
    results.add("body_change_abs", max(map(state_change, TIMES)), 0, 1e-15, **cost)
    # bound: study.csv, by the command `study`, committed before: the error e that
    # forces have on this size of cells. The errors of two meshes differ by 2 e at
    # most if neither is worse than e; on average by no more than e, or a new mesh
    # would cost more than its cells' size does
    study = errors()
    changes = {}
    for name, table in FORCES.items():
        changes[name] = force_changes(remeshed, table)
        results.add(f"{name}_abs", changes[name].mean(), 0, study[name], **cost)
        results.add(f"{name}_largest_abs", changes[name].max(), 0, 2 * study[name], **cost)
        print(f"    {name}: changes by {changes[name].mean():.2g}, at most "
              f"{changes[name].max():.2g}; error of this size {study[name]:.2g}")
    # bound: as for forces: twice the error of the shape
    axes = last(kept, AXES)
    results.add("shape_after_20_abs",
                np.linalg.norm(last(remeshed, AXES) - axes) / np.linalg.norm(axes), 0,
                2 * study["shape_after_20"], **cost)
    if not quick:
        draw(changes, study)
    results.write()


if __name__ == "__main__":
    main()
