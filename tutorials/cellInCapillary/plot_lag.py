# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells' velocity over that of the flow on the axis, against exact Stokes
flow around a sphere in a tube."""

import numpy as np

from fsbi import plots
from fsbi.history import History
from fsbi.tube import velocity

FLOW = 1e-3         # um/us on the axis
TUBE = 8            # um

cases = {"narrow": 2.4, ".": 4.0, "wide": 5.6}
widths = np.array(list(cases.values())) / TUBE
found = np.array([
    History(f"{case}/postProcessing/history.h5")["bodies/leukocyte/velocity"]["x"][-1] / FLOW
    for case in cases])
exact = np.array([velocity(width) for width in widths])

figure, axes = plots.plt.subplots()
curve = np.linspace(0.02, 0.8, 40)
axes.plot(curve, [velocity(width) for width in curve], color="black", lw=1.2,
          label="exact: sphere in a tube")
axes.plot(curve, 1 - 2 / 3 * curve**2, color="black", lw=1.2, ls="--",
          label="far walls: 1 − 2/3 (a/R)²")
axes.plot(widths, found, color=plots.COLOURS[0], ls="", marker="o", mfc="white",
          label="fsbiFoam")
axes.set(xlabel="radius of the cell over that of the capillary",
         ylabel="velocity over the flow's on the axis")
axes.set_title("A cell lags behind the flow", loc="left")
axes.legend()
plots.save(figure, "lag.png")

print("    radius   velocity / flow   exact     error")
for width, u, e in zip(widths, found, exact):
    print(f"    {width * TUBE:6.1f}   {u:15.4f}   {e:.4f}   {abs(u - e) / e:.2%}")
