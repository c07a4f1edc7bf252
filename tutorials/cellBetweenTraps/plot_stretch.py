# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force on the beads over the cell's elongation, and the modulus that it tells."""

import numpy as np

from fsbi import plots
from fsbi.history import History

RADIUS, BEAD = 4, 1.5       # um
# of a bead of this size, E radius displacement/force in small deformations, by finite
# elements (applications/test/opticalTweezers/pulled_sphere.py)
COMPLIANCE = 0.96235

history = History("postProcessing/history.h5")
left, right = (history[f"effects/opticalTweezers/{name}/holds"] for name in ("left", "right"))
pulls = [1000 * history[f"effects/opticalTweezers/{name}/force"]["x"]                # pN
         for name in ("left", "right")]
force = (pulls[1] - pulls[0]) / 2
drag = pulls[0] + pulls[1]
distance = right["x"] - left["x"]
# the beads hold the middles of caps of the sphere
elongation = distance - 2 * (RADIUS - BEAD**2 / (4 * RADIUS))
small = elongation < 0.1 * RADIUS
slope = np.polyfit(elongation[small], force[small], 1)[0]                           # pN/um
modulus = slope * 2 * COMPLIANCE / RADIUS                                           # Pa

figure, axis = plots.plt.subplots(figsize=(6.4, 4.0))
axis.plot(elongation, force, color=plots.COLOURS[0], marker="o", mfc="white", label="fsbiFoam")
line = np.array([0, elongation[-1]])
axis.plot(line, 100 * RADIUS / (2 * COMPLIANCE) * line, color="black", lw=1.2,
          label="small deformations, 100 Pa (finite elements)")
axis.set(xlabel="elongation (µm)", ylabel="force (pN)")
axis.set_title("A cell between two optical traps", loc="left")
axis.legend()
plots.save(figure, "stretch.png")

print(f"    elongation                {elongation[-1]:.3f} µm by {force[-1]:.1f} pN")
print(f"    drag on the cell          {drag[-1]:.1f} pN")
print(f"    modulus from the slope    {modulus:.1f} Pa   (the cell's: 100)")
