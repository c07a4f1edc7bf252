# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast a free sphere moves on the axis of a tube in Poiseuille flow.

    velocity(0.5)       # of a sphere half as wide as the tube, over the flow's
                        # velocity on the axis far away

The disturbance of the flow is a sum of exact Stokes flows: those of multipoles
in the sphere's centre (Happel & Brenner 1983, section 4-23; without the one of
a force) and those that are regular in the tube (Haberman & Sayre 1958). Their
coefficients and the velocity follow from no slip on the sphere and the wall, and
from no disturbance at the ends, by least squares at many points. Lengths: the
tube's radius. Digits that do not change with `multipoles`, `waves` and `length`
are right; `python3 sphere_in_tube.py` shows it.
"""

import numpy as np
from scipy.special import eval_legendre, i0e, i1e


def multipole(n, power, z, rho, radius):
    """(u_z, u_rho) of the stream function r^power G_n(cos theta)."""
    r = np.hypot(z, rho)
    x, s = z / r, rho / r
    f = (r / radius) ** power
    gegenbauer = (eval_legendre(n - 2, x) - eval_legendre(n, x)) / (2 * n - 1)
    along = -f * eval_legendre(n - 1, x) / r**2
    across = power * f * gegenbauer / (r**2 * np.maximum(s, 1e-300))
    return along * x - across * s, along * s + across * x


def wave(k, z, rho):
    """Both regular flows with cos(kz), of size one on the wall."""
    decay = np.exp(k * (rho - 1))
    zero, one = i0e(k * rho) * decay / i0e(k), i1e(k * rho) * decay / i0e(k)
    cos, sin = np.cos(k * z), np.sin(k * z)
    return [(zero * cos, one * sin),
            ((k * rho * one + 2 * zero) * cos / (k + 2), k * rho * zero * sin / (k + 2))]


def velocity(radius, multipoles=8, waves=48, length=4.0):
    theta = np.linspace(0, np.pi / 2, 8 * multipoles)
    wall = np.linspace(0, length, 6 * waves)
    end = np.linspace(0, 1, 4 * multipoles)
    z = np.concatenate([radius * np.cos(theta), wall, length + 0 * end])
    rho = np.concatenate([radius * np.sin(theta), 1 + 0 * wall, end])
    on_sphere = np.arange(len(z)) < len(theta)

    flows = [(1 + 0 * z, 0 * z), (rho**2, 0 * z)]
    for n in range(2, 2 * multipoles + 1, 2):
        flows.append(multipole(n, 1 - n, z, rho, radius))
        if n > 2:                               # n = 2 is that of a force
            flows.append(multipole(n, 3 - n, z, rho, radius))
    for m in range(1, waves + 1):
        flows += wave(m * np.pi / (1.5 * length), z, rho)
    flows.append((-1.0 * on_sphere, 0 * z))     # the velocity's part

    matrix = np.array([np.concatenate(flow) for flow in flows]).T
    given = np.concatenate([-(1 - rho**2) * on_sphere, 0 * z])
    size = np.linalg.norm(matrix, axis=0)
    found = np.linalg.lstsq(matrix / size, given, rcond=1e-14)[0] / size
    return found[-1]


if __name__ == "__main__":
    for radius in (0.1, 0.3, 0.5, 0.7):
        print(radius, *(f"{velocity(radius, *more):.7f}" for more in
                        ((4, 24, 3.0), (8, 48, 4.0), (12, 72, 5.0))),
              "  1 - 2/3 radius^2:", f"{1 - 2 / 3 * radius**2:.7f}")
