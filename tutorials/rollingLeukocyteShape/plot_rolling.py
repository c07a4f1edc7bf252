# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways of points of the membrane and their velocity; the fluid's load."""

import numpy as np

from fsbi import plots
from fsbi.history import History
from fsbi.leukocyte import Leukocyte

history = History("postProcessing/history.h5")
cell = Leukocyte(radius=4, Ax=1, Ay=0.1, By=0.4)
body = "bodies/leukocyte/"
position = history[body + "position"]
seconds = position["time"] * 1e-6

figure, (paths, speeds) = plots.plt.subplots(
    2, 1, figsize=(7.2, 6.4), gridspec_kw=dict(height_ratios=(1.3, 1)))
outline = cell.image(cell.circle(np.linspace(0, 2 * np.pi, 200)))
for i in (0, len(seconds) // 2, -1):
    x, y = position["x"][i], position["y"][i]
    paths.fill(outline[:, 0] + x, outline[:, 1] + y, color="#eeeeee",
               ec="#999999", lw=1)
starts = (90, 180, 270)
for i, start in enumerate(starts):
    way = cell.path(history, "leukocyte", np.radians(start))
    style = dict(color=plots.COLOURS[i], marker=plots.MARKERS[i], markevery=4, mfc="white")
    paths.plot(way[:, 0], way[:, 1], label=("top", "rear", "bottom")[i], **style)
    speeds.plot((seconds[1:] + seconds[:-1]) / 2, np.diff(way[:, 0]) / np.diff(seconds), **style)
paths.axhline(0, color="black", lw=2)
paths.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal", ylim=(-0.5, 10))
paths.set_title("Ways of points of the membrane that start at the …", loc="left")
paths.legend(ncols=3, loc="upper left")

speeds.axhline(0, color="#999999", lw=0.8)
speeds.axhline(120, color="black", ls="--", lw=1.2, label="V")
speeds.set(xlabel="time (s)", ylabel="velocity along x (µm/s)")
speeds.set_title("Their velocity, and that of the cell", loc="left")
speeds.legend(loc="upper left")
plots.save(figure, "rolling.png")

way = cell.path(history, "leukocyte", np.radians(starts[0]))
part = np.mean(np.diff(way[:, 0]) < 0)
print(f"    a point of the membrane moves backward for {part:.3f} of the time,"
      f" exactly {cell.part_backward(1.2e-4, 3e-5):.3f}")
force = history[body + "force/fluid"].array[-1, 1:]
torque = history[body + "torque/fluid"].array[-1, 1:]
# pg um/us2 is 1e-9 N, pg um2/us2 is 1e-15 N m
print(f"    force along x {1e3 * force[0]:.2f} pN, off the wall {1e3 * force[1]:.1f} pN,"
      f" torque about z {1e3 * torque[2]:.1f} pN um")
