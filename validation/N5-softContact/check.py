# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights at which elastic spheres rest, against finite elements; write results.csv."""

import sys

import numpy as np

from fsbi.case import Case
from fsbi.results import Results
from sphere_on_wall import Barrier, Sphere, rest

CELL = Sphere(radius=4, E=0.01, nu=0.45)
GAP, RANGE, PRESSURE = 0.1, 0.1, 0.03
LOAD = 3.17e-5 * 4 / 3 * np.pi * CELL.radius**3
quick = sys.argv[1:2] == ["true"]
results = Results("N5")


def bound(edge, height):
    """Triangles stand off the sphere by up to their sagitta, edge^2/(6 radii)"""
    return edge**2 / (6 * CELL.radius) / height


def centre(run, body, axis):
    return run.history[f"elasticBodies/{body}/centre"][axis]


def wall(edge):
    run = Case(f"runs/wall{edge:g}")
    cost = dict(seconds=run.seconds, cells=run.cells)
    height, _, _ = rest(CELL, Barrier(GAP, RANGE, PRESSURE), LOAD)
    results.add("height_on_wall", centre(run, "cell", "y")[-1], reference=height,
                bound=bound(edge, height), variant=f"edge{edge:g}", **cost)
    # bound: loads of bodies at rest are balanced
    push = run.history["effects/contact/nearest"]["force"][-1]
    results.add("force_over_load", push, reference=LOAD, bound=1e-3,
                variant=f"edge{edge:g}", **cost)


def pair(edge):
    """Half of the gap, and of the range, up to the plane between them"""
    run = Case(f"runs/pair{edge:g}")
    height, _, _ = rest(CELL, Barrier(GAP / 2, RANGE / 2, PRESSURE), LOAD)
    apart = centre(run, "cell", "x")[-1] - centre(run, "a", "x")[-1]
    results.add("half_of_distance", apart / 2, reference=height,
                bound=bound(edge, height), variant=f"edge{edge:g}",
                seconds=run.seconds, cells=run.cells)


def main():
    wall(1.4)
    wall(1)
    if not quick:
        pair(1)
    results.write()
    sys.exit(results.check())


if __name__ == "__main__":
    main()
