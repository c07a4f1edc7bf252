# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bead's height over time beside a fall without thermal motion and Boltzmann's
distribution, and its way along the wall."""

import numpy as np

from fsbi import plots
from fsbi.history import History

KT = 1.380649e-8 * 310                              # pg um2/us2
RADIUS, EXCESS, GRAVITY = 1, 0.5, 9.81e-6           # um, pg/um3, um/us2
STRENGTH, RANGE = 2e-6, 0.5                         # of the repulsion
weight = 4 / 3 * np.pi * RADIUS**3 * EXCESS * GRAVITY

place = History("postProcessing/history.h5")["bodies/bead/position"]
t, x, y, gap = (place[c] for c in ("time", "x", "y", "z"))
gap = gap - RADIUS


def force(d):
    """Repulsion over the zones of the sphere, less its weight."""
    push = 2 * np.pi * RADIUS * STRENGTH * (
        (1 / d**2 - 1 / RANGE**2) / 2 - (RANGE - d) / RANGE**3)
    return np.where(d < RANGE, push, 0) - weight


def mobility(d):
    """Along the normal, within 0.3 % (Bevan and Prieve 2000)."""
    s = d / RADIUS
    return (6 * s**2 + 2 * s) / (6 * s**2 + 9 * s + 2) / (6 * np.pi * RADIUS)


def fall(start):
    """Without thermal motion."""
    d, step = [start], (t[1] - t[0]) / 100
    for _ in range(100 * (len(t) - 1)):
        d.append(d[-1] + step * mobility(d[-1]) * force(d[-1]))
    return np.array(d[::100])


d = np.linspace(0.03, 6, 4000)
work = np.concatenate([[0], np.cumsum(0.5 * (force(d)[1:] + force(d)[:-1]) * np.diff(d))])
boltzmann = np.exp((work - work.max()) / KT)
boltzmann /= np.sum(boltzmann) * (d[1] - d[0])
mean = np.sum(d * boltzmann) * (d[1] - d[0])

figure, axes = plots.plt.subplots(1, 3, figsize=(11, 3.6), width_ratios=(2, 0.7, 1.2))
axes[0].plot(t * 1e-6, gap, color=plots.COLOURS[0], label="fsbiFoam")
axes[0].plot(t * 1e-6, fall(gap[0]), color="black", lw=1, label="without thermal motion")
axes[0].set(xlabel="time (s)", ylabel="gap to the wall (µm)", ylim=(0, 5.5))
axes[0].set_title("A bead settles", loc="left")
axes[0].legend()
axes[1].plot(boltzmann, d, color="black", lw=1)
axes[1].set(xlabel="Boltzmann (1/µm)", ylim=(0, 5.5), yticklabels=[])
axes[2].plot(x, y, color=plots.COLOURS[0])
axes[2].set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal")
axes[2].set_title("seen from above", loc="left")
figure.tight_layout()
plots.save(figure, "settling.png")
settled = gap[len(gap) // 2:]
print(f"    mean gap in the second half {np.mean(settled):.3f} µm, Boltzmann's {mean:.3f} µm")
