# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell's velocity against the exact law u = U (1 - exp(-t/tau))."""

import numpy as np

from fsbi import plots
from fsbi.history import History

SPEED = 1.4e-4              # um/us
TAU = 2 * 8**2 / 9          # 2 rho a^2 / (9 mu), us

velocity = History("postProcessing/history.h5")["bodies/tumourCell/velocity"]
t = np.append(0, velocity["time"])
u = np.append(0, velocity["x"])
exact = SPEED * (1 - np.exp(-t / TAU))
error = (u - exact) / SPEED

figure, (upper, lower) = plots.plt.subplots(
    2, 1, figsize=(6.4, 5.6), sharex=True, height_ratios=[2.4, 1])
upper.plot(t, exact * 1e6, color="black", lw=1.2, label="U (1 − exp(−t/τ)), τ = 14.2 µs")
upper.plot(t, u * 1e6, ls="none", marker="o", color=plots.COLOURS[0], mfc="white",
           markevery=5, label="fsbiFoam")
upper.axhline(SPEED * 1e6, color="#888888", lw=1, ls=":")
upper.annotate("U", (0, SPEED * 1e6), (0, -12), textcoords="offset points")
upper.set(ylabel="velocity (µm/s)")
upper.set_title("A tumour cell set in motion by a uniform flow", loc="left")
upper.legend(loc="lower right")
lower.axhline(0, color="black", lw=1)
lower.plot(t, error * 100, color=plots.COLOURS[0])
lower.set(xlabel="time (µs)", ylabel="error (% of U)", ylim=(-1, 1))
plots.save(figure, "start.png")
print(f"    largest error    {np.abs(error).max():.2e} of U")
