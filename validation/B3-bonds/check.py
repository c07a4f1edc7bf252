# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speeds relative to those without bonds; write results.csv and draw the state
diagram."""

import glob
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

FREE_SHEAR = 1e-4       # 1/us, of the run without bonds
# Of the speed without bonds. "No adhesion" is that of Chang, Tees & Hammer (2000),
# Proc. Natl Acad. Sci. 97, 11262; their firm cells stand for a second, these runs
# last 30 ms (60 at the lowest shear rate), in which a bond drawn taut lets a cell go
# a radius in twenty
FIRM, FREE = 0.05, 0.95
STATES = ("firm", "rolling", "no adhesion")
quick = sys.argv[1:2] == ["true"]
results = Results("B3")


def speed(run, shear, free):
    """Mean over the last part, in which bonds have had time to form; Stokes
    flow, so that the speed without bonds grows as the shear rate."""
    time, x = run.time(), run.position("leukocyte")[:, 0]
    first = np.searchsorted(time, (0.75 if quick else 0.5) * time[-1])
    return (x[-1] - x[first]) / (time[-1] - time[first]) / (free * shear / FREE_SHEAR)


def state(ratio):
    return 0 if ratio < FIRM else 1 if ratio < FREE else 2


def draw(found):
    figure, axes = plots.plt.subplots()
    for i, name in enumerate(STATES):
        points = np.array([p for p in found if state(p[2]) == i]).reshape(-1, 3)
        axes.scatter(1e6 * points[:, 1], 1e6 * points[:, 0], s=140, marker="so^"[i],
                     color=plots.COLOURS[i], label=name)
    for off, shear, ratio in found:
        axes.annotate(f"{ratio:.2f}", (1e6 * shear, 1e6 * off), (9, 7),
                      textcoords="offset points", fontsize=9)
    axes.set(xscale="log", yscale="log", xlabel="shear rate (1/s)",
             ylabel="dissociation rate at rest (1/s)")
    axes.set_title("Speed, relative to that without bonds", loc="left")
    shears = sorted({1e6 * shear for _, shear, _ in found})
    axes.set_xticks(shears, [f"{shear:g}" for shear in shears])
    axes.minorticks_off()
    axes.margins(0.15)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=3)
    plots.save(figure, "states.png")


def main():
    free = Case("runs/free").velocity("leukocyte")[-1, 0]
    found = []
    runs = {}
    for folder in glob.glob("runs/k*"):
        off, shear = map(float, re.fullmatch(r"runs/k(\S+)_g(\S+)", folder).groups())
        runs[off, shear] = Case(folder)
    for (off, shear), run in sorted(runs.items()):
        ratio = speed(run, shear, free)
        found.append((off, shear, ratio))
        bonds = run.history["effects/bonds/selectin"]["number"]
        print(f"    off {1e6 * off:g} 1/s, shear {1e6 * shear:g} 1/s: {ratio:.3f}, "
              f"{STATES[state(ratio)]}, {bonds[-1]:.0f} bonds, {run.seconds:.0f} s")
    low, high = min(found), max(found, key=lambda p: (p[0], -p[1]))
    if quick:
        # bound: what "firm" means
        results.add("firm_abs", low[2], 0, FIRM, runs[low[:2]].seconds, runs[low[:2]].cells)
        # bound: one bond at a time: in its mean life of 33 us it is drawn out by 11 nm, and
        # pulls by 0.5 pN, where the drag of a cell that stands is 26
        results.add("free", high[2], 1, 0.02, runs[high[:2]].seconds, runs[high[:2]].cells)
    else:
        draw(found)
        for shear in sorted({p[1] for p in found}):
            column = [p[2] for p in sorted(found) if p[1] == shear]
            # bound: what "no adhesion" means
            results.at_least(f"free_g{1e6 * shear:g}", column[-1], FREE)
            # bound: order, not size: bonds that live longer hold longer, but for the
            # noise of one seed
            results.add(f"slower_if_longer_bound_g{1e6 * shear:g}_abs",
                        sum(np.diff(column) < -0.02), 0, 0)
        # bound: what "firm" means
        results.add("firm_abs", low[2], 0, FIRM)
        # bound: all three
        results.at_least("states_seen", len({state(p[2]) for p in found}), 3)
    results.write()


if __name__ == "__main__":
    main()
