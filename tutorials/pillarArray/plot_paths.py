# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a large and a small bead go in an array of posts."""

import numpy as np

from fsbi import plots
from fsbi.history import History

PITCH, POST = 20, 5         # um
RUNS = {"large": (".", 2.5), "small": ("small", 1.5)}

paths = {name: History(f"{folder}/postProcessing/history.h5")["bodies/bead/position"]
         for name, (folder, _) in RUNS.items()}
figure, axes = plots.plt.subplots(figsize=(7.6, 5.0))
right, top = (max(path[i].max() for path in paths.values()) for i in "xy")
for i in range(int(right / PITCH) + 2):
    for j in range(int(top / PITCH) + 2):
        axes.add_patch(plots.plt.Circle((PITCH * i, PITCH * j), POST, color="0.75"))
for colour, (name, path) in zip(plots.COLOURS, paths.items()):
    radius = RUNS[name][1]
    axes.plot(path["x"], path["y"], color=colour, label=f"radius {radius} µm")
    for n in range(0, len(path), 10):
        axes.add_patch(plots.plt.Circle((path["x"][n], path["y"][n]), radius, color=colour,
                                        fill=False, lw=0.8))
    rows = np.floor(path["y"][-1] / PITCH)
    print(f"    {name}: {path['x'][-1] / PITCH:.1f} posts further, "
          f"{'in the same row' if rows == 0 else 'a row higher'}")
axes.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal", xlim=(-6, right + 6),
         ylim=(-6, top + 8))
axes.set_title("Two beads in an array of posts", loc="left")
axes.legend(loc="lower right")
plots.save(figure, "paths.png")
