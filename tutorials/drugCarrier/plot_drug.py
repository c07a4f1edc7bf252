# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the drug is: in the bead, the fluid, the cell, on the wall, carried off."""

import numpy as np

from fsbi import plots
from fsbi.history import History

STORE = 1000        # thousands of molecules

history = History("postProcessing/history.h5")
balance = history["species/drug/balance"]
surfaces = {name: history[f"species/drug/surfaces/{name}"]
            for name in ("bead", "cell", "bottomWall")}
ms = balance["time"] * 1e-3
parts = {
    "in the bead": surfaces["bead"]["held"],
    "in the fluid": balance["fluid"],
    "taken up by the cell": -surfaces["cell"]["released"],
    "bound to the wall": -surfaces["bottomWall"]["released"],
    "carried off by the flow": -balance["entered"],
}

figure, axes = plots.plt.subplots(figsize=(6.4, 4.4))
for i, (name, amount) in enumerate(parts.items()):
    axes.plot(ms, amount / STORE, label=name, color=plots.COLOURS[i % len(plots.COLOURS)])
axes.set(xlabel="time (ms)", ylabel="part of the drug", ylim=(0, 1))
axes.set_title("Where the drug is", loc="left")
axes.legend()
plots.save(figure, "drug.png")

for name, amount in parts.items():
    print(f"    {name:24} {amount[-1] / STORE:.4f}")
total = sum(amount[-1] for amount in parts.values())
print(f"    all of it                {total / STORE:.12f}")
print(f"    largest error of the balance {np.abs(balance['error']).max():.1e}")
