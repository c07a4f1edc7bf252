# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the bodies add to the viscosity, by their stresslets (Batchelor 1970)."""

import numpy as np

from fsbi import plots
from fsbi.history import History

RATE, VISCOSITY, VOLUME, RADIUS = 5e-5, 1.0, 20.0**3, 3.5
BEADS = [f"bead{i}" for i in range(1, 6)]

history = History("postProcessing/history.h5")
time = history["cost"]["time"] * RATE
added = {name: history[f"{kind}/{name}/stresslet"]["xz"] / (VISCOSITY * RATE * VOLUME)
         for kind, names in (("bodies", BEADS), ("elasticBodies", ["cell"])) for name in names}
phi = 4 / 3 * np.pi * RADIUS**3 / VOLUME

figure, axis = plots.plt.subplots(figsize=(6.4, 4.0))
for label, value, colour in (
        ("all six", sum(added.values()), 0),
        ("were all as the beads", 6 * np.mean([added[bead] for bead in BEADS], axis=0), 1),
        ("were all as the cell", 6 * added["cell"], 2)):
    axis.plot(time, 1 + value, color=plots.COLOURS[colour], label=label)
axis.axhline(1 + 2.5 * 6 * phi, color="black", lw=1.2, label="beads without neighbours (Einstein)")
axis.set(xlabel="strain", ylabel="viscosity over the fluid's")
axis.set_title("Beads and a soft cell in shear", loc="left")
axis.legend()
plots.save(figure, "viscosity.png")

print(f"    volume fraction           {6 * phi:.3f}")
print(f"    viscosity, last half      {1 + sum(added.values())[len(time) // 2:].mean():.3f}")
