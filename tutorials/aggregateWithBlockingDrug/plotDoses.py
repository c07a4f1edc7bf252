# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Probability of an aggregate against the dose, with what so few runs can tell;
and the bonds at the end of each."""

import glob
import math
import re

import numpy as np

from fsbi import adhesion, plots
from fsbi.history import History

INTERVAL, SAMPLES = 30, 75      # us; of the mean
STOPPED = 0.1                   # of the speed at the start


def outcome(folder):
    """Is there an aggregate at the end, and how many bonds formed?"""
    history = History(f"{folder}/postProcessing/history.h5")
    time, speed = adhesion.relative_speed(history, "tumourCell", "leukocyte", INTERVAL)
    mean = adhesion.moving_mean(speed, SAMPLES)
    start = adhesion.aggregate_time(time, mean, STOPPED * speed[0])
    return not math.isnan(start), history["effects/bonds/LFA1-ICAM1"]["formed"].sum()


found = {}
for folder in sorted(glob.glob("runs/dose*_seed*")):
    dose, seed = re.fullmatch(r"runs/dose(\S+)_seed(\d+)", folder).groups()
    found.setdefault(float(dose), []).append(outcome(folder))

doses = sorted(found)
stuck = [sum(s for s, _ in found[d]) for d in doses]
total = [len(found[d]) for d in doses]
bands = np.array([adhesion.wilson(s, n) for s, n in zip(stuck, total)])

figure, (likely, many) = plots.plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True)
likely.fill_between(doses, bands[:, 0], bands[:, 1], color=plots.COLOURS[0], alpha=0.2,
                    lw=0, label="95 % confidence (Wilson)")
likely.plot(doses, np.divide(stuck, total), color=plots.COLOURS[0], marker="o",
            mfc="white", label=f"part of {max(total)} runs")
likely.set(ylabel="probability of an aggregate", ylim=(-0.05, 1.05))
likely.set_title("A drug blocks LFA-1 of the leukocyte", loc="left")
likely.legend()
for d in doses:
    many.plot([d] * len(found[d]), [n for _, n in found[d]], color=plots.COLOURS[1],
              marker="s", mfc="white", ls="")
many.set(xlabel="part of LFA-1 that is blocked", ylabel="bonds formed",
         ylim=(0, None))
plots.save(figure, "doses.png")
for d, s, n, (low, high) in zip(doses, stuck, total, bands):
    print(f"    {100 * d:.0f} % blocked: {s} of {n} runs end in an aggregate, "
          f"probability {low:.2f} to {high:.2f}")
