# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell's deformation and inclination against the exact values."""

import os

import numpy as np

from fsbi import plots
from fsbi.case import reference
from fsbi.history import History

RATE = 5e-5         # 1/us
CA = 0.1            # viscosity times shear rate over the shear modulus

# Steady shape, incompressible
exact = next(row for row in reference(os.path.join(
    os.environ["FSBI_DIR"], "validation/B2-elasticSphere/reference/steady.csv"))
    if row["Ca"] == CA)

history = History("postProcessing/history.h5")
axes = history["elasticBodies/cell/semiAxes"]
direction = history["elasticBodies/cell/longestAxis"]
time = RATE * axes["time"]
D = (axes["longest"] - axes["shortest"]) / (axes["longest"] + axes["shortest"])
angle = np.degrees(np.arctan2(direction["y"], direction["x"])) % 180

figure, (above, below) = plots.plt.subplots(2, 1, figsize=(6.4, 5.6), sharex=True)
for a, y, key, label in ((above, D, "D_exact", "deformation (L-B)/(L+B)"),
                         (below, angle, "theta_deg", "inclination (degrees)")):
    a.axhline(exact[key], color="black", lw=1.2, label="exact, steady")
    a.plot(time, y, color=plots.COLOURS[0], marker="o", mfc="white",
           markevery=4, label="fsbiFoam")
    a.set_ylabel(label)
    a.legend()
below.set_xlabel("time × shear rate")
above.set_title("A soft cell in shear, µγ/G = 0.1", loc="left")
plots.save(figure, "shape.png")

print(f"    deformation   {D[-1]:.4f}   (exact {exact['D_exact']:.4f})")
print(f"    inclination   {angle[-1]:.2f}    (exact {exact['theta_deg']:.2f})")
