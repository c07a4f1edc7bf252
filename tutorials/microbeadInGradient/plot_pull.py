# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bead's velocity against Stokes' law and the force in a Maxwell pair."""

import numpy as np

from fsbi import plots
from fsbi.history import History

MU0 = 4e-7 * np.pi
RADIUS, COIL, TURNS, CURRENT, CHI = 4e-6, 1e-2, 200, 5, 1       # SI
VISCOSITY = 1e-3
WALLS = 2500e-6                     # distance of the cube's faces

# between the coils B grows linearly; a soft sphere has the moment alpha B
gradient = 48 / 49 * np.sqrt(3 / 7) * MU0 * TURNS * CURRENT / COIL**2
alpha = 4 / 3 * np.pi * RADIUS**3 * 3 * CHI / (3 + CHI) / MU0
rate = alpha * gradient**2 / (6 * np.pi * VISCOSITY * RADIUS)   # u = rate x


def shell(ratio):
    """Drag in a concentric sphere over Stokes' (Haberman and Sayre)."""
    return (1 - ratio**5) / (1 - 9/4*ratio + 5/2*ratio**3 - 9/4*ratio**5 + ratio**6)


history = History("postProcessing/history.h5")
u = history["bodies/microbead/velocity"]["x"]
x = history["bodies/microbead/position"]["x"]
t = history["bodies/microbead/position"]["time"]
confined = rate / shell(RADIUS / WALLS)

figure, (upper, lower) = plots.plt.subplots(2, 1, figsize=(6.4, 6.4))
line = np.array([0, x.max() * 1.05])
upper.plot(line, rate * line, color="black", lw=1.2, label="Stokes: α g² x/(6πµa)")
upper.plot(x, u * 1e6, ls="none", marker="o", color=plots.COLOURS[0], mfc="white",
           label="fsbiFoam")
upper.set(xlabel="place x (µm)", ylabel="velocity (µm/s)")
upper.set_title("A paramagnetic bead between the coils of a Maxwell pair", loc="left")
upper.legend()
lower.axhline(0, color="black", lw=1)
lower.plot(t * 1e-6, 100 * (u * 1e6 / (rate * x) - 1), color=plots.COLOURS[0],
           label="against Stokes")
lower.plot(t * 1e-6, 100 * (u * 1e6 / (confined * x) - 1), color=plots.COLOURS[1], ls="--",
           label="with the drag of a spherical wall")
lower.set(xlabel="time (s)", ylabel="difference (%)", ylim=(-2, 2))
lower.legend()
figure.tight_layout()
plots.save(figure, "pull.png")
print(f"    gradient         {gradient:.3f} T/m, 1/rate {1 / rate:.2f} s")
print(f"    velocity         {100 * (u[-1] * 1e6 / (rate * x[-1]) - 1):+.2f} % of Stokes', "
      f"{100 * (u[-1] * 1e6 / (confined * x[-1]) - 1):+.2f} % with walls, at the end")
