# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A stretched body that is turned: states, and the stress of each formulation.

    stretched.py            # constant/<region>/exactSolution

Time 1: stretched by 1.05 along x with free sides. Then 10 degrees about z a
step. Stresses over Young's modulus.
"""

import numpy as np

NU = 0.133
STRETCH, STEP, STEPS = 1.05, 10, 4
MU = 0.5 / (1 + NU)
LAMBDA = NU / (1 + NU) / (1 - 2 * NU)


def turn(degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def states():
    """F at times 0, 1, ..."""
    side = np.sqrt(1 - NU * (STRETCH**2 - 1))
    stretched = np.diag([STRETCH, side, side])
    return [np.eye(3)] + [turn(STEP * k) @ stretched for k in range(STEPS + 1)]


def second_stress(F):
    """Second Piola-Kirchhoff stress of Saint Venant and Kirchhoff."""
    strain = (F.T @ F - np.eye(3)) / 2
    return LAMBDA * np.trace(strain) * np.eye(3) + 2 * MU * strain


def cauchy(formulation, F, before):
    """On the body at F, where the step began at `before`."""
    step = F @ np.linalg.inv(before)
    if formulation == "slowProcess":
        return (step @ (second_stress(before) + second_stress(step)) @ step.T
                / np.linalg.det(step))
    if formulation == "slowProcessTotalStrain":
        return step @ second_stress(F) @ step.T / np.linalg.det(step)
    return F @ second_stress(F) @ F.T / np.linalg.det(F)


def stresses(formulation):
    """At times 1, 2, ..."""
    return np.array([cauchy(formulation, F, before)
                     for before, F in zip(states(), states()[1:])])


if __name__ == "__main__":
    print("type homogeneous; deformation table\n(")
    for time, F in enumerate(states()):
        print(f"    ({time} ({' '.join(f'{x:.17g}' for x in F.flat)}))")
    print(");")
