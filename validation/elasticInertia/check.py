# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacements of the twisted sphere against the exact ones of twist.py; write
results.csv."""

import sys

import numpy as np

from fsbi import convergence, fields
from fsbi.case import Case
from fsbi.results import Results

import twist

AXIS = np.array((1, 2, 3)) / np.sqrt(14)
STEPS = 4, 2, 1
quick = sys.argv[1:2] == ["true"]
results = Results("elasticInertia")


def displacements(name):
    """Of the body's cells at the end, and the exact ones."""
    folder = f"runs/{name}/{twist.END}/cell"
    x = fields.internal(f"{folder}/C")
    turn = twist.angle(np.linalg.norm(x, axis=1))
    return fields.internal(f"{folder}/D"), np.cross(AXIS, x) * turn[:, None]


def amplitude(name):
    """Part of the exact displacement that the found one has."""
    found, exact = displacements(name)
    return np.sum(found * exact) / np.sum(exact**2)


def error(name):
    found, exact = displacements(name)
    return np.sqrt(np.sum((found - exact)**2) / np.sum(exact**2))


def in_time(name, scheme):
    order = convergence.order_of_three(STEPS, [amplitude(f"{name}{s}") for s in STEPS])
    # bound: BDF2 of the fluid and the surface, with a growth of 1/16 a unit of time, shows an
    # order of 1.85 with these steps (S18)
    results.at_least("order_in_time", order, 1.8, variant=scheme)


def main():
    in_time("step", "Newmark")
    run = Case("runs/step1")
    # bound: 6 % of the steady torque of rigid spheres with edges of 0.4 radii on tetrahedra
    # (second order, 1.5 % at 0.2: the project's limit), of which this one is a share
    results.add("displacement_abs", error("step1"), 0, 0.06, variant="0.4",
                seconds=run.seconds, cells=run.cells)
    if not quick:
        in_time("houbolt", "Fornberg2")
    results.write()


if __name__ == "__main__":
    main()
