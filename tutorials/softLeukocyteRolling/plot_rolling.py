# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed of the leukocyte, its bonds and its shape."""

import numpy as np

from fsbi import plots
from fsbi.history import History

history = History("postProcessing/history.h5")
centre = history["elasticBodies/leukocyte/centre"]
axes = history["elasticBodies/leukocyte/semiAxes"]
bonds = history["effects/bonds/selectin"]
time = 1e-3 * centre["time"]
speed = 1e3 * np.gradient(centre["x"], centre["time"])

figure, (motion, number, shape) = plots.plt.subplots(3, 1, figsize=(6.4, 8.2), sharex=True)
motion.plot(time, speed, color=plots.COLOURS[0])
motion.set(ylabel="speed (mm/s)", ylim=(0, None))
motion.set_title("A leukocyte is caught", loc="left")
number.step(time, bonds["number"], color=plots.COLOURS[1], label="bonds")
number.plot(time, 1e3 * bonds["tension"], color=plots.COLOURS[2],
            label="sum of their tensions (pN)")
number.legend()
for i, name in enumerate(("longest", "middle", "shortest")):
    shape.plot(time, axes[name], color=plots.COLOURS[i], label=f"{name} semi-axis")
shape.set(xlabel="time (ms)", ylabel="µm")
shape.legend(loc="center right", fontsize=9)
plots.save(figure, "rolling.png")

free = speed[bonds["number"] == 0]
print(f"    without bonds {1e3 * np.median(free):.0f} µm/s, in the last 10 ms "
      f"{1e3 * np.mean(speed[time > time[-1] - 10]):.0f} µm/s with "
      f"{bonds['number'][-1]:.0f} bonds")
