# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The capsule's deformation and inclination, and the steady ones of theory."""

import numpy as np

from fsbi import plots
from fsbi.history import History

RATE = 5e-5                 # 1/us
CA = 5e-5 * 4 / 4e-3        # viscosity times shear rate times radius over the shear modulus
# Steady shape at first order in the deformation: capsule(5, "Skalak", 20, 60) of
# validation/E3-cells/small_deformation.py
SMALL = {"D": 0.0912, "angle": 30.6}

history = History("postProcessing/history.h5")
axes = history["elasticBodies/cell/semiAxes"]
direction = history["elasticBodies/cell/longestAxis"]
time = RATE * axes["time"]
D = (axes["longest"] - axes["shortest"]) / (axes["longest"] + axes["shortest"])
angle = np.degrees(np.arctan2(direction["y"], direction["x"])) % 180

figure, (above, below) = plots.plt.subplots(2, 1, figsize=(6.4, 5.6), sharex=True)
for a, y, key, label in ((above, D, "D", "deformation (L-B)/(L+B)"),
                         (below, angle, "angle", "inclination (degrees)")):
    a.axhline(SMALL[key], color="black", lw=1.2, label="small deformations")
    a.plot(time, y, color=plots.COLOURS[0], marker="o", mfc="white",
           markevery=4, label="fsbiFoam")
    a.set_ylabel(label)
    a.legend()
below.set_xlabel("time × shear rate")
above.set_title(f"A capsule in shear, µγa/G = {CA:g}", loc="left")
plots.save(figure, "shape.png")

print(f"    deformation   {D[-1]:.4f}   (small deformations {SMALL['D']:.4f})")
print(f"    inclination   {angle[-1]:.2f}    (small deformations {SMALL['angle']})")
