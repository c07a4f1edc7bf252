# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The red cell's shape, speed, volume and area over time."""

import numpy as np

from fsbi import plots
from fsbi.history import History

MEAN_FLOW = 1e-3        # um/us: half of that on the axis

cell = "elasticBodies/redCell"
history = History("postProcessing/history.h5")
axes = history[f"{cell}/semiAxes"]
ms = axes["time"] / 1000
speed = np.gradient(history[f"{cell}/centre"]["x"], axes["time"]) / MEAN_FLOW
volume = history[f"{cell}/volume"]["now"]
area = history[f"{cell}/cortex"]["area"]

figure, (above, below) = plots.plt.subplots(2, 1, figsize=(6.4, 5.6), sharex=True)
for name, values, colour in (("across", axes["longest"], 0), ("along", axes["shortest"], 1)):
    above.plot(ms, values, color=plots.COLOURS[colour], label=f"{name} the capillary")
above.set_ylabel("semi-axis (µm)")
above.legend()
above.set_title("A red blood cell in a capillary 10 µm wide", loc="left")
below.plot(ms, speed, color=plots.COLOURS[2])
below.set(xlabel="time (ms)", ylabel="speed over the mean flow's")
plots.save(figure, "shape.png")

print(f"    speed over the mean flow's   {speed[-1]:.3f}")
print(f"    length over width            {axes['shortest'][-1] / axes['longest'][-1]:.3f}")
print(f"    change of volume             {volume[-1] / volume[0] - 1:.2%}")
print(f"    change of area               {area[-1] / area[0] - 1:.2%}")
