# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far the bead goes from where its tether held it, held by magnets and by
nothing, and the currents."""

import csv

import numpy as np

from fsbi import plots
from fsbi.history import History

RADIUS = 4
bead = "elasticBodies/microbead/"
tethered, magnets, free = (History(folder + "/postProcessing/history.h5")
                           for folder in ("tethered", ".", "free"))
held = tethered[bead + "centre"].array


def away(history):
    """Times and distances from the tethered bead."""
    centre = history[bead + "centre"].array
    n = min(len(centre), len(held))
    return centre[:n, 0] * 1e-3, np.linalg.norm(centre[:n, 1:] - held[:n, 1:], axis=1)


with open("postProcessing/fieldDesign.csv") as file:
    rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
coils = [name for name in rows[0] if name.endswith(".I")]
time = [row["time"] * 1e-3 for row in rows]

figure, (drift, force, current) = plots.plt.subplots(3, 1, figsize=(6.4, 8), sharex=True)
for i, (history, label) in enumerate(((magnets, "magnets"), (free, "nothing"))):
    drift.semilogy(*away(history), color=plots.COLOURS[i],
                   label=f"held by {label}, from the tethered one")
drift.axhline(0.01 * RADIUS, color="0.5", ls=":", label="1 % of the radius")
drift.set(ylabel="distance (µm)")
drift.set_title("A microbead beside a wall, held by coils", loc="left")
magnet = magnets["effects/magnetics/microbead"]
tether = tethered[bead + "tether"]
for i, name in enumerate("xy"):
    force.plot(tether["time"] * 1e-3, 1e3 * tether[name], color=plots.COLOURS[i],
               label=f"tether, {name}")
    force.plot(magnet["time"] * 1e-3, 1e3 * magnet["f" + name], color=plots.COLOURS[i],
               ls="none", marker="o", mfc="white", markevery=4, label=f"magnets, {name}")
force.set(ylabel="force (pN)")
for i, name in enumerate(coils):
    current.plot(time, [row[name] for row in rows], color=plots.COLOURS[i % 5],
                 ls="-" if i < 5 else "--", label=name.removesuffix(".I"))
current.set(xlabel="time (ms)", ylabel="current (A)")
drift.legend()
force.legend(ncols=2)
current.legend(ncols=3, loc="center right")
plots.save(figure, "magnets.png")
print(f"    with magnets     {away(magnets)[1].max():.2e} µm from the tethered bead, at most")
print(f"    with nothing     {away(free)[1].max():.2f} µm")
print(f"    largest current  {max(abs(row[c]) for row in rows for c in coils):.2f} A, load missing "
      f"{max(row['residual'] for row in rows):.1e} of the largest")
