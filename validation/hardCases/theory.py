# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a viscous fluid takes from rigid bodies, between two bounds.

Of all flows without divergence that have the velocities of the bodies on their
surfaces and vanish on the walls, Stokes' has the least dissipation (Helmholtz).
So the power that bodies give to a fluid at rest, with velocities V and omega
about their centres, is

- at least that around the ball of radius a inside any single one of them,
  alone and without walls, 6 pi mu a V^2 + 8 pi mu a^3 omega^2: the rest of the
  body, the others and the walls are constraints, which only add; a side
  without traction does not take away from it;
- at most the sum of those in concentric shells around the bodies, between a
  ball of radius R that holds the body and one of radius L that touches no wall
  and no other shell: these flows, with rest between the shells, are one that
  Stokes' flow competes with (Happel & Brenner, Low Reynolds Number
  Hydrodynamics, 1983, 4-22 and 7-8 have the shells).
"""

import numpy as np


def free(mu, a):
    """Resistances to V and to omega of a ball alone."""
    return 6 * np.pi * mu * a, 8 * np.pi * mu * a**3


def in_shell(mu, R, L):
    """The same in the middle of a shell at rest."""
    k = R / L
    drag, torque = free(mu, R)
    return (drag * (1 - k**5) / (1 - 9 / 4 * k + 5 / 2 * k**3 - 9 / 4 * k**5 + k**6),
            torque / (1 - k**3))


def power(resistances, V, omega):
    """Row by row."""
    drag, torque = resistances
    return drag * (V**2).sum(axis=1) + torque * (omega**2).sum(axis=1)


def speed(mu, loads, a):
    """The largest speed of a body with a ball of radius a inside, whatever the
    loads [(a, force, torque), ...] on all bodies do: from

        max (6 pi mu a V^2 + 8 pi mu a^3 omega^2) <= sum (F V + T omega)

    by the inequality of Cauchy and Schwarz."""
    total = 0.0
    for inside, force, torque in loads:
        drag, turning = free(mu, inside)
        total = total + np.sqrt(force**2 / drag + torque**2 / turning)
    return total / np.sqrt(free(mu, a)[0])
