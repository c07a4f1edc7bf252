# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell's path, velocity and rotation against theory."""

import numpy as np

from fsbi import plots
from fsbi.history import History

RATE = 50           # 1/s
HEIGHT = 60         # um

history = History("postProcessing/history.h5")
position = history["bodies/tumourCell/position"]
velocity = history["bodies/tumourCell/velocity"]
spin = history["bodies/tumourCell/angularVelocity"]
seconds = position["time"] * 1e-6
path = position["x"] - position["x"][0]

figure, axes = plots.plt.subplots(3, 1, figsize=(6.4, 7.4))
path_axes, velocity_axes, spin_axes = axes


def draw(axes, x, y, theory, ylabel, title):
    axes.axhline(theory, color="black", lw=1.2, label="unbounded Stokes flow")
    axes.axhspan(0.99 * theory, 1.01 * theory, color="#eeeeee", zorder=0,
                 label="± 1 %")
    axes.plot(x, y, color=plots.COLOURS[0], marker="o", mfc="white",
              markevery=6, label="fsbiFoam")
    axes.set(xlabel="time (s)", ylabel=ylabel,
             ylim=(0.98 * theory, 1.02 * theory))
    axes.set_title(title, loc="left")


drift = np.hypot(position["y"] - 60, position["z"] - HEIGHT)
path_axes.plot(path, 5e-4 * path, color="black", ls="--", lw=1.2,
               label="5e-4 of the path")
path_axes.plot(path, drift, color=plots.COLOURS[0], marker="o", mfc="white",
               markevery=6, label="fsbiFoam")
path_axes.set(xlabel="distance travelled (µm)", ylabel="drift (µm)")
path_axes.set_title("Drift across the streamlines: none in theory", loc="left")
draw(velocity_axes, seconds, velocity["x"] * 1e3, RATE * HEIGHT * 1e-3,
     "velocity (mm/s)", "Velocity: γ h")
draw(spin_axes, seconds, spin["y"] * 1e6, RATE / 2, "rotation (rad/s)",
     "Angular velocity: γ/2")
for a in (path_axes, velocity_axes):
    a.legend(ncols=3, loc="upper left" if a is path_axes else "lower left")
plots.save(figure, "motion.png")

last = len(seconds) // 4
print(f"    drift / path     {drift[-1] / path[-1]:.1e}")
print(f"    velocity / (γ h) {np.mean(velocity['x'][last:]) * 1e6 / RATE / HEIGHT:.5f}")
print(f"    rotation / (γ/2) {np.mean(spin['y'][last:]) * 2e6 / RATE:.5f}")
