# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bead's shape, volume and the force of its tether."""

import numpy as np

from fsbi import plots
from fsbi.history import History

SPHERE = 4 / 3 * np.pi * 4**3       # um3, free of stress

bead = "elasticBodies/microbead/"
history = History("postProcessing/history.h5")
axes = history[bead + "semiAxes"]
tether = history[bead + "tether"].array[:, 1:]
force = history[bead + "fluidForce"].array[:, 1:]
volume = history[bead + "volume"]["now"] / SPHERE
time = axes["time"] * 1e-3

figure, (shape, load, size) = plots.plt.subplots(3, 1, figsize=(6.4, 7.8), sharex=True)
for i, name in enumerate(("longest", "middle", "shortest")):
    shape.plot(time, axes[name], color=plots.COLOURS[i], label=name)
shape.set(ylabel="semi-axis (µm)", ylim=(2.5, 5))
shape.set_title("A tethered microbead beside a wall, 50 per second", loc="left")
for i, name in enumerate("xy"):
    load.plot(time, 1e3 * force[:, i], color=plots.COLOURS[i], label=f"fluid, {name}")
    load.plot(time, -1e3 * tether[:, i], color=plots.COLOURS[i], ls="none", marker="o",
              mfc="white", markevery=10, label=f"− tether, {name}")
load.set(ylabel="force (pN)")
size.plot(time, volume, color=plots.COLOURS[0])
size.set(ylabel="volume / free of stress", xlabel="time (ms)")
shape.legend(ncols=3)
load.legend(ncols=2)
plots.save(figure, "shape.png")

balance = np.linalg.norm(tether + force, axis=1) / np.linalg.norm(force, axis=1)
print("    semi-axes      ",
      ", ".join(f"{axes[n][-1]:.3f}" for n in ("longest", "middle", "shortest")), "µm")
print(f"    force of fluid  {1e3 * force[-1, 0]:.2f}, {1e3 * force[-1, 1]:.2f} pN (x, y)")
print(f"    tether + fluid  {balance.max():.1e} of the force, at most")
