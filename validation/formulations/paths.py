# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Deformations F over the load steps, and their closed-form stresses.

    paths.py stretched          # constant/<region>/exactSolution
    paths.py turned 1 steps     # number of steps; turned by 1 degree in each
"""

import sys

import numpy as np

E, NU = 1, 0.3
MU = E / 2 / (1 + NU)
LAMBDA = E * NU / (1 + NU) / (1 - 2 * NU)


def stretch(L):
    """Uniaxial stress: lateral stretch^2 = 1 - nu (L^2 - 1)."""
    side = np.sqrt(1 - NU * (L**2 - 1))
    return np.diag([L, side, side])


def turn(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def stretched():
    return [stretch(L) for L in np.linspace(1, 1.5, 11)]


def compressed():
    return [stretch(L) for L in np.linspace(1, 0.7, 7)]


def sheared():
    return [np.eye(3) + k * np.outer([1, 0, 0], [0, 1, 0])
            for k in np.linspace(0, 1, 11)]


def turned(step=10):
    """Stretched by 1.2, then turned by 90 degrees about z."""
    first = [stretch(L) for L in np.linspace(1, 1.2, 5)]
    angles = np.arange(step, 90.001, step)
    return first + [turn(a) @ first[-1] for a in angles]


def second_stress(F):
    """Second Piola-Kirchhoff stress of Saint Venant and Kirchhoff."""
    strain = (F.T @ F - np.eye(3)) / 2
    return LAMBDA * np.trace(strain) * np.eye(3) + 2 * MU * strain


def stress(F):
    """First Piola-Kirchhoff stress."""
    return F @ second_stress(F)


def cauchy(F):
    return stress(F) @ F.T / np.linalg.det(F)


def slow_stress(F, before):
    """What slowProcess takes for P: the stress F'' (S' + S(F'')) on the mesh,
    whose deformation is that before the step, brought back to the undeformed
    body."""
    step = F @ np.linalg.inv(before)
    return _from_mesh(step @ (second_stress(before) + second_stress(step)), before)


def slow_stress_total(F, before):
    """The same of slowProcessTotalStrain: F'' S(F)."""
    return _from_mesh(F @ np.linalg.inv(before) @ second_stress(F), before)


def _from_mesh(P, before):
    return P @ np.linalg.inv(before).T * np.linalg.det(before)


def path(name, *step):
    return globals()[name](*map(float, step))


def main(name, *options):
    states = path(name, *(o for o in options if o != "steps"))
    if "steps" in options:
        print(len(states) - 1)
        return
    print("type homogeneous; deformation table\n(")
    for time, F in enumerate(states):
        print(f"    ({time} ({' '.join(f'{x:.17g}' for x in F.flat)}))")
    print(");")


if __name__ == "__main__":
    main(*sys.argv[1:])
