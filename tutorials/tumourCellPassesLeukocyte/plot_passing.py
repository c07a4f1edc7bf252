# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tumour cell's path, and what it does to the leukocyte."""

from fsbi import plots
from fsbi.history import History

history = History("postProcessing/history.h5")
path = history["bodies/tumourCell/position"]
leukocyte = "elasticBodies/leukocyte/"
centre = history[leukocyte + "centre"]
axes = history[leukocyte + "semiAxes"]
force = history[leukocyte + "fluidForce"]
time = path["time"] * 1e-3

figure, (way, shape, load) = plots.plt.subplots(3, 1, figsize=(6.4, 8.2))
way.plot(path["x"], path["y"], color=plots.COLOURS[0], marker="o", mfc="white",
         markevery=10)
way.set(xlabel="x (µm)", ylabel="height (µm)")
way.set_title("Centre of the tumour cell", loc="left")
for i, name in enumerate(("longest", "middle", "shortest")):
    shape.plot(time, axes[name], color=plots.COLOURS[i], label=f"{name} semi-axis")
shape.plot(time, centre["x"] - centre["x"][0], color=plots.COLOURS[3], ls="--",
           label="centre, downstream")
shape.set(ylabel="µm")
shape.set_title("Leukocyte", loc="left")
for i, name in enumerate("xy"):
    load.plot(time, 1e3 * force[name], color=plots.COLOURS[i], label=f"fluid, {name}")
load.set(xlabel="time (ms)", ylabel="force (pN)")
load.set_title("Force on the leukocyte; adhesion holds against it", loc="left")
shape.legend(fontsize=9)
load.legend()
plots.save(figure, "passing.png")

at = abs(path["time"] - 9320).argmin()
print(f"    at {path['time'][at]:.0f} µs   tumour cell at x {path['x'][at]:.2f}, "
      f"y {path['y'][at]:.2f} µm")
print(f"    at the end   tumour cell at x {path['x'][-1]:.2f}, y {path['y'][-1]:.2f} µm;"
      f" leukocyte's longest semi-axis {axes['longest'][-1]:.2f} µm")
