# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Probability of an aggregate against the dose, with what so few runs can tell, and
the bonds formed in each run; beside both what the number of receptors says.

While cells pass that bonds do not hold, M receptors find a ligand (counted, mean of
the runs in `passing`). A drug leaves each of them free with probability 1 - d, so that
about a Poisson number of mean M (1 - d) could bind, and the first bond, which is
ideal, never lets go: P = 1 - exp(-M (1 - d)). Nothing is fitted. Aggregates are
fewer: a cell that one late bond holds still swings when the run ends."""

import csv
import math

import numpy as np

from fsbi import adhesion, plots


def rows(study):
    with open(f"runs/{study}/ensemble/table.csv", newline="") as file:
        return [row for row in csv.DictReader(file) if not row["failed"]]


found = {}
for row in rows("doses"):
    found.setdefault(float(row["blocked"]), []).append(
        (row["aggregate"] == "1", float(row["formed"])))
passing = [float(row["formed"]) for row in rows("passing")]
reached = np.mean(passing)
print(f"    {reached:.1f} receptors find a ligand while the cells pass unheld "
      f"({len(passing)} runs, {min(passing):.0f} to {max(passing):.0f})")

doses = sorted(found)
stuck = [sum(s for s, _ in found[d]) for d in doses]
bound = [sum(n > 0 for _, n in found[d]) for d in doses]
total = [len(found[d]) for d in doses]
free = 1 - np.array(doses)
fine = np.geomspace(0.5*min(free), 1, 400)      # part that is free

figure, (likely, many) = plots.plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True)
likely.plot(fine, 1 - np.exp(-reached * fine), color=plots.COLOURS[2], lw=1,
            label=f"one or more of {reached:.0f} receptors free")
for side, count, what in ((0.97, bound, "a bond formed"), (1.03, stuck, "an aggregate at the end")):
    part = np.divide(count, total)
    bands = np.array([adhesion.wilson(c, n) for c, n in zip(count, total)])
    likely.errorbar(side * free, part, np.abs(bands.T - part), capsize=3, ls="",
                    color=plots.COLOURS[side > 1], marker="so"[side > 1], mfc="white",
                    lw=1, label=f"{what}, of {max(total)} runs")
likely.set(ylabel="probability (bars: 95 %, Wilson)", ylim=(-0.05, 1.05))
likely.set_title("A drug blocks a part of the leukocyte's LFA-1", loc="left")
likely.legend(loc="lower right")
for d in doses:
    many.plot([1 - d] * len(found[d]), [n for _, n in found[d]], color=plots.COLOURS[0],
              marker="s", mfc="white", ls="")
many.plot(fine, reached * fine, color=plots.COLOURS[2], lw=1,
          label="if bonds did not hold the cells")
many.set(xlabel="part of LFA-1 that is free", ylabel="bonds formed",
         xscale="log", xlim=(0.7 * min(free), 1.2), yscale="symlog", ylim=(-0.2, 2 * max(passing)))
many.set_yscale("symlog", linthresh=1)
many.legend(loc="upper left")
plots.save(figure, "doses.png")
for d, s, b, n in zip(doses, stuck, bound, total):
    low, high = adhesion.wilson(b, n)
    print(f"    {100 * d:.0f} % blocked: a bond in {b} of {n} runs ({low:.2f} to {high:.2f}; "
          f"by the number of receptors {1 - math.exp(-reached * (1 - d)):.2f}), "
          f"an aggregate in {s}")
