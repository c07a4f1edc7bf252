# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Advance per turn of both runs, beside theory and Gaskin 2018."""

import os

import numpy as np

from fsbi import plots
from fsbi.case import reference
from fsbi.history import History
from fsbi.resistive_force import helix, lighthill

# of this helix, its axis held; validation/S7-helix computes it
BOUNDARY_INTEGRAL = next(
    row["axis_held"] for row in
    reference(os.environ["FSBI_DIR"] + "/validation/S7-helix/reference/helix.csv")
    if row["pitch"] == 2)
a, b, _ = helix(lighthill, R=1, r=0.1, pitch=2, n=5)
RESISTIVE_FORCE = -b / a        # Abbott et al.


def advance(folder):
    history = History(folder + "/postProcessing/history.h5")
    u = history["bodies/swimmer/velocity"]["z"]
    w = history["bodies/swimmer/angularVelocity"]["z"]
    turned = np.cumsum(w * history["cost"]["step"]) / (2 * np.pi)
    return turned, u / w


figure, axes = plots.plt.subplots()
for i, (folder, label) in enumerate(((".", "given spin"), ("byTorque", "given torque"))):
    turned, ratio = advance(folder)
    axes.plot(turned, ratio, "os"[i], mfc="white", color=plots.COLOURS[i], label=label)
    print(f"    {label}: u/(omega R) = {ratio.mean():.5f}, "
          f"{100 * (ratio.mean() / BOUNDARY_INTEGRAL - 1):+.1f} % of the boundary integral's")
axes.axhline(BOUNDARY_INTEGRAL, color="0.3", label="boundary integral")
axes.axhline(RESISTIVE_FORCE, color="0.3", ls="--", label="resistive-force theory")
for factor, ls in ((0.86, ":"), (1.45, "-.")):
    axes.axhline(factor * RESISTIVE_FORCE, color="0.6", ls=ls,
                 label=f"Gaskin 2018: {factor} of it")
axes.set(xlabel="turns", ylabel="u/(ωR)", ylim=(0, 0.19))
axes.set_title("How far a helix swims per angle turned", loc="left")
axes.legend(fontsize=9)
plots.save(figure, "swimming.png")
