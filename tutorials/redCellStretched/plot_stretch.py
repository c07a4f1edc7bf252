# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The red cell's diameters by the force, beside measured ones."""

from fsbi import plots
from fsbi.case import reference
from fsbi.history import History

history = History("postProcessing/history.h5")
force = 1000 * history["effects/opticalTweezers/right/force"]["x"]              # pN
length = history["elasticBodies/redCell/extents"]
volume = history["elasticBodies/redCell/volume"]["now"]
area = history["elasticBodies/redCell/cortex"]["area"]
measured = reference("measured.csv")

figure, axis = plots.plt.subplots(figsize=(6.4, 4.6))
for name, values, colour in (("axial", length["x"], 0), ("transverse", length["y"], 1)):
    mean, low, high = ([row[name + end] for row in measured] for end in ("", "Low", "High"))
    bars = [[m - a for m, a in zip(mean, low)], [b - m for m, b in zip(mean, high)]]
    axis.errorbar([row["force"] for row in measured], mean, yerr=bars, color="black",
                  fmt="o", mfc="white", lw=1, capsize=3,
                  label="measured (Mills et al. 2004)" if colour == 0 else None)
    axis.plot([0, *force], [7.82, *values], color=plots.COLOURS[colour], label=f"{name}, fsbiFoam")
axis.set(xlabel="force (pN)", ylabel="diameter (µm)", ylim=(0, None))
axis.set_title("A red blood cell pulled by two beads", loc="left")
axis.legend()
plots.save(figure, "stretch.png")

print(f"    at {force[-1]:.0f} pN: axial {length['x'][-1]:.2f} µm, transverse"
      f" {length['y'][-1]:.2f} µm")
print(f"    change of volume   {volume[-1] / volume[0] - 1:.1e}")
print(f"    change of area     {area[-1] / area[0] - 1:.2%}")
