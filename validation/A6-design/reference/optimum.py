# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The best helix by boundary integrals (validation/S7-helix/reference), with no part of
fsbiFoam: speed and torque per angular velocity on a grid of pitches and radii, which
splines of their logarithms join; the pitch of the highest speed along the radii at
which the torque is at its limit.

    python3 optimum.py          makes grid.csv (3 min)

mu = 1, filament 0.2, 3 turns; the axis is held, as a field holds it.
"""

import csv
import importlib.util
import os

import numpy as np
from scipy.interpolate import RectBivariateSpline
from scipy.optimize import brentq, minimize_scalar

HERE = os.path.dirname(os.path.abspath(__file__))
PITCHES = np.geomspace(3, 12, 8)
RADII = np.geomspace(0.65, 1.3, 6)
LEVELS = (3, 4, 6)
SPIN, LIMIT = 6.2832e-5, 6e-3


def integrals():
    root = os.environ.get("FSBI_DIR") or os.path.join(HERE, "../../..")
    path = os.path.join(root, "validation/S7-helix/reference/boundary_integral.py")
    spec = importlib.util.spec_from_file_location("boundary_integral", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def point(pitch, radius, levels=LEVELS):
    """(u/w, T/w) extrapolated, that of the axis held and free to drift."""
    by = integrals()
    rows = []
    for around in levels:
        R, _ = by.resistance(by.Filament(pitch, 3, radius, 0.2), around)
        free = np.linalg.solve(R[:2, :2], -R[:2, 2])
        rows.append([free[1], R[2, 2] + R[2, :2] @ free])
    h = 1 / np.array(levels, float)
    return [by.limit(h[-3:], column[-3:]) for column in np.array(rows).T]


class Laws:
    """Of the committed grid."""

    def __init__(self):
        with open(os.path.join(HERE, "grid.csv")) as file:
            rows = np.array([[float(r[k]) for k in ("pitch", "radius", "advance", "torque")]
                             for r in csv.DictReader(t for t in file if t[0] != "#")])
        self.pitches, self.radii = np.unique(rows[:, 0]), np.unique(rows[:, 1])
        shape = len(self.pitches), len(self.radii)
        self.splines = [RectBivariateSpline(np.log(self.pitches), np.log(self.radii),
                                            np.log(rows[:, k]).reshape(shape)) for k in (2, 3)]

    def advance(self, pitch, radius):
        return float(np.exp(self.splines[0](np.log(pitch), np.log(radius))[0, 0]))

    def torque(self, pitch, radius):
        return float(np.exp(self.splines[1](np.log(pitch), np.log(radius))[0, 0]))

    def radius(self, pitch):
        """With the torque at its limit."""
        return brentq(lambda r: self.torque(pitch, r) * SPIN - LIMIT,
                      self.radii[0], self.radii[-1])

    def speed(self, pitch):
        return SPIN * self.advance(pitch, self.radius(pitch))

    def best(self):
        """Pitch, radius, speed."""
        found = minimize_scalar(lambda x: -self.speed(np.exp(x)), method="bounded",
                                bounds=np.log([self.pitches[0], self.pitches[-1]]),
                                options=dict(xatol=1e-5))
        pitch = float(np.exp(found.x))
        return pitch, self.radius(pitch), self.speed(pitch)

    def as_good(self, loss):
        """Pitches between which the speed is this part below the best one at most."""
        pitch, _, speed = self.best()

        def above(p):
            return self.speed(p) - (1 - loss) * speed
        return (brentq(above, self.pitches[0], pitch), brentq(above, pitch, self.pitches[-1]))


if __name__ == "__main__":
    with open(os.path.join(HERE, "grid.csv"), "w") as made:
        made.write("# optimum.py: mu 1, filament 0.2, 3 turns; u/w and T/w\n")
        made.write("pitch,radius,advance,torque\n")
        for p in PITCHES:
            for r in RADII:
                made.write(",".join(f"{v:.8g}" for v in (p, r, *point(p, r))) + "\n")
                made.flush()
