# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact Stokes flow around a sphere on the axis of a round tube.

    velocity(0.5)       # of a free sphere half as wide as the tube, over that of
                        # the flow on the axis far away
    drag_moving(0.5)    # on a sphere that moves in a fluid at rest, over Stokes'
                        # 6 pi mu a U (Haberman & Sayre's K1)
    drag_held(0.5)      # on a sphere held in Poiseuille flow, over 6 pi mu a times
                        # the velocity on the axis (K2)

Both ends are open as far as K1 is concerned: no fluid is moved on the whole.

The disturbance of the flow is a sum of exact Stokes flows: those of multipoles
in the sphere's centre (Happel & Brenner 1983, section 4-23) and those that are
regular in the tube (Haberman & Sayre 1958). Their coefficients follow from no
slip on the sphere and the wall, and from no disturbance at the ends, by least
squares at many points. Lengths: the tube's radius. Digits that do not change with
`multipoles`, `waves` and `length` are right; `python3 -m fsbi.tube` shows it.
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


class Points:
    """Where boundary conditions hold: a quarter of the plane of the axis."""

    def __init__(self, radius, multipoles, waves, length):
        theta = np.linspace(0, np.pi / 2, 8 * multipoles)
        wall = np.linspace(0, length, 6 * waves)
        end = np.linspace(0, 1, 4 * multipoles)
        self.z = np.concatenate([radius * np.cos(theta), wall, length + 0 * end])
        self.rho = np.concatenate([radius * np.sin(theta), 1 + 0 * wall, end])
        self.on_sphere = np.arange(len(self.z)) < len(theta)


def regular_flows(p, waves, length):
    flows = [(1 + 0 * p.z, 0 * p.z), (p.rho**2, 0 * p.z)]
    for m in range(1, waves + 1):
        flows += wave(m * np.pi / (1.5 * length), p.z, p.rho)
    return flows


def coefficients(flows, along):
    """Of the flows that together have this velocity along the axis, none across."""
    matrix = np.array([np.concatenate(flow) for flow in flows]).T
    given = np.concatenate([along, 0 * along])
    size = np.linalg.norm(matrix, axis=0)
    return np.linalg.lstsq(matrix / size, given, rcond=1e-14)[0] / size


def multipoles_of(p, radius, number, with_force):
    flows = [multipole(2, 1, p.z, p.rho, radius)] if with_force else []
    for n in range(2, 2 * number + 1, 2):
        flows.append(multipole(n, 1 - n, p.z, p.rho, radius))
        if n > 2:                               # n = 2 is that of a force
            flows.append(multipole(n, 3 - n, p.z, p.rho, radius))
    return flows


def velocity(radius, multipoles=8, waves=48, length=4.0):
    p = Points(radius, multipoles, waves, length)
    flows = multipoles_of(p, radius, multipoles, False) + regular_flows(p, waves, length)
    flows.append((-1.0 * p.on_sphere, 0 * p.z))     # the velocity's part
    return coefficients(flows, -(1 - p.rho**2) * p.on_sphere)[-1]


def drag(on_sphere, radius, multipoles, waves, length):
    """Over 6 pi mu a, where the sphere disturbs the flow by this velocity."""
    p = Points(radius, multipoles, waves, length)
    flows = multipoles_of(p, radius, multipoles, True) + regular_flows(p, waves, length)
    force = coefficients(flows, on_sphere(p.rho) * p.on_sphere)[0]
    return -force / (1.5 * radius**2)       # a sphere alone: u_r = 1.5 U a cos / r


def drag_moving(radius, multipoles=8, waves=48, length=4.0):
    return drag(lambda rho: 1 + 0 * rho, radius, multipoles, waves, length)


def drag_held(radius, multipoles=8, waves=48, length=4.0):
    return drag(lambda rho: 1 - rho**2, radius, multipoles, waves, length)


if __name__ == "__main__":
    for function in (velocity, drag_moving, drag_held):
        print(function.__name__)
        for a in (0.1, 0.2, 0.3, 0.5, 0.7, 0.8):
            print(f"    {a}", *(f"{function(a, *more):.7f}" for more in
                                ((4, 24, 3.0), (8, 48, 4.0), (12, 72, 5.0))))
