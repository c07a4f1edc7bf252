# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An elastic sphere that a fluid twists, both with inertia, all growing like exp(s t).

Angular displacement within, by the distance r from the centre, and angular velocity of
the fluid around:

    phi = PHI P(kappa r)/P(kappa a),                         kappa^2 = rho s^2/G
    g = swirl P(k r) + (spin - swirl P(k a)) Q(k r)/Q(k a),  k^2 = rho s/mu

P(x) = 3 (x cosh x - sinh x)/x^3 is within(x) here, Q(x) = (1 + x) exp(-x)/x^3 around(x).
At the surface the velocity, spin = s PHI, and the traction, G phi' = mu g', are the same.
Run: print swirl and spin at the time 0.
"""

import numpy as np

RADIUS, GROWTH, END = 4, 1 / 16, 128
VISCOSITY, DENSITY, SHEAR_MODULUS = 1, 1, 1 / 36
# angle of the surface at the end: everything is linear in it
PHI = 1e-3
K = np.sqrt(DENSITY * GROWTH / VISCOSITY)
KAPPA = np.sqrt(DENSITY / SHEAR_MODULUS) * GROWTH


def within(x):
    return 3 * (x * np.cosh(x) - np.sinh(x)) / x**3


def d_within(x):
    return 3 * np.sinh(x) / x**2 - 3 * within(x) / x


def around(x):
    return (1 + x) * np.exp(-x) / x**3


def d_around(x):
    return -np.exp(-x) / x**2 - 3 * around(x) / x


def angle(r):
    """At the end."""
    return PHI * within(KAPPA * r) / within(KAPPA * RADIUS)


def flow():
    """swirl and spin at the end."""
    spin = GROWTH * PHI
    x, y = K * RADIUS, KAPPA * RADIUS
    traction = SHEAR_MODULUS * PHI * KAPPA * d_within(y) / within(y)
    of_spin, of_swirl = d_around(x) / around(x), d_within(x) - within(x) * d_around(x) / around(x)
    return (traction / VISCOSITY / K - spin * of_spin) / of_swirl, spin


if __name__ == "__main__":
    print("swirl %.17g; spin %.17g;" % tuple(np.array(flow()) * np.exp(-GROWTH * END)))
