# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of the bodies to their targets, what is left of them and the currents
over time; says how far each body is from its target at the end."""

import re

import numpy as np

from fsbi import plots
from fsbi.history import History

RADIUS = 5              # um
with open("constant/effects") as file:
    text = file.read()
targets = {name: [float(x) for x in place.split()] for name, place in
           re.findall(r"(\w+) +\{ target \(([^)]*)\)", text)}
tolerance, limit = (float(re.search(rf"^ *{word} +([\d.e-]+);", text, re.M)[1])
                    for word in ("tolerance", "maxCurrent"))
history = History("postProcessing/history.h5")
control = history["effects/magnetics/controller"]
seconds = 1e-6 * control["time"]

figure = plots.plt.figure(figsize=(9.6, 6.6))
grid = figure.add_gridspec(3, 2, width_ratios=(1, 1.15))
for i, (name, target) in enumerate(targets.items()):
    path = figure.add_subplot(grid[i, 0])
    place = history[f"bodies/{name}/position"]
    path.plot(place["x"], place["y"], color=plots.COLOURS[i])
    path.plot(place["x"][0], place["y"][0], "o", color=plots.COLOURS[i], mfc="white")
    circle = plots.plt.Circle(target[:2], tolerance, color="black", fill=False, lw=1.2)
    path.add_patch(circle)
    path.set(aspect="equal", adjustable="datalim", ylabel="y (µm)")
    path.set_title(f"{name}: path to its target", loc="left")
path.set(xlabel="x (µm)")

left = figure.add_subplot(grid[0, 1])
for i, name in enumerate(targets):
    left.plot(seconds, control[f"distance.{name}"], color=plots.COLOURS[i], label=name)
left.axhline(tolerance, color="black", lw=1.2, ls="--", label="tolerance")
left.set(ylabel="distance (µm)", ylim=(0, None))
left.legend(fontsize=8, ncol=2)
flow = figure.add_subplot(grid[1, 1], sharex=left)
for i, name in enumerate("xyz"):
    flow.plot(seconds, control[f"I.{name}"], color=plots.COLOURS[i + 3], lw=1, label=name)
flow.axhline(limit, color="black", lw=1.2, ls="--")
flow.axhline(-limit, color="black", lw=1.2, ls="--", label="limit")
flow.set(ylabel="current (A)")
flow.legend(fontsize=8, ncol=4, loc="center", bbox_to_anchor=(0.5, 0.86))
mode = figure.add_subplot(grid[2, 1], sharex=left)
mode.step(seconds, control["mode"], where="pre", color=plots.INK, lw=1.2)
mode.set(xlabel="time (s)", ylabel="mode (0: no field)", yticks=range(4))
plots.save(figure, "swarm.png")

there = np.all([control[f"distance.{name}"] <= tolerance for name in targets], axis=0)
for name in targets:
    print(f"    {name}: {control[f'distance.{name}'][-1]:.2f} µm from its target,"
          f" {control[f'distance.{name}'][0]:.2f} at the start")
largest = max(np.abs(control[f"I.{name}"]).max() for name in "xyz")
print(f"    all within {tolerance} µm "
      + (f"after {seconds[there][0]:.2f} s" if there[-1] else "NOT reached")
      + f"; currents up to {largest:.2f} A of {limit} A")
if not there[-1]:
    raise SystemExit("a body has not reached its target")
