# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gaps and steps of the collisions, and where the pressed sphere rests; write
results.csv and draw."""

import glob
import re
import sys

import numpy as np
from scipy.optimize import brentq

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results
from surfaces import Sphere, gap_behind_triangles, time_to_contact, time_to_wall

STRENGTH, RANGE, MINIMUM = 1e-3, 1, 0.2     # constant/effects
RADIUS, FORCE = 4, 0.2                      # of the pressed sphere
APPROACH = 0.2                              # maxApproach of system/controlDict
EDGES = {"step1000": 1.2, "edge0.6": 0.6, "edge0.3": 0.3}
quick = sys.argv[1:2] == ["true"]
results = Results("S13")


def rest():
    """Gap of a sphere at which the integral of the pressure over it is the
    force: its zones have the area 2 pi a dd."""
    def excess(h):
        bracket = (1 / h**2 - 1 / RANGE**2) / 2 - (RANGE - h) / RANGE**3
        return 2 * np.pi * RADIUS * STRENGTH * bracket - FORCE
    return MINIMUM + brentq(excess, 1e-3 * RANGE, RANGE)


def spheres(run):
    """Both, with their radii and places as drawn."""
    with open(f"{run.folder}/constant/bodies") as file:
        text = file.read()
    radii = re.findall(r"radius ([0-9.]+);", text)
    starts = re.findall(r"position +\((.*)\);", text)
    return [Sphere(run, name, float(radius), np.array(start.split(), float))
            for name, radius, start in zip("ab", radii, starts)]


def true_gaps(a, b):
    """Of the true spheres and the wall, over all times, each with its bound."""
    between = np.linalg.norm(a.position - b.position, axis=1) - a.radius - b.radius
    # either sphere's triangles would do: the better of the two
    yield between, max(gap_behind_triangles(MINIMUM, a, b),
                       gap_behind_triangles(MINIMUM, b, a))
    for sphere in (a, b):
        yield sphere.position[:, 1] - sphere.radius, gap_behind_triangles(MINIMUM, sphere)


def nearest_to_bound(a, b):
    """Of the pairs the one that comes nearest to its bound."""
    return min(((gap.min(), bound) for gap, bound in true_gaps(a, b)),
               key=lambda pair: pair[0] - pair[1])


def largest_part(run, a, b):
    """Of the gap of any triangle that a step could have closed at the speed of
    its beginning."""
    steps = np.diff(run.time())
    parts = [step / min(time_to_contact(i, a, b), time_to_contact(i, b, a),
                        time_to_wall(i, a), time_to_wall(i, b))
             for i, step in enumerate(steps)]
    return max(parts)


def collisions():
    for folder in sorted(glob.glob("runs/collision*"), key=lambda p: int(p[14:])):
        run = Case(folder)
        a, b = spheres(run)
        gap, bound = nearest_to_bound(a, b)
        part = largest_part(run, a, b)
        cost = dict(seconds=run.seconds, cells=run.cells)
        # bound: minimumGap less what triangles leave out of spheres, see
        # surfaces.gap_behind_triangles
        results.at_least(f"true_gap_{folder[5:]}", gap, bound, **cost)
        # bound: maxApproach; coordinates are read in single precision
        results.add(f"part_of_gap_{folder[5:]}_abs", part, 0, APPROACH * (1 + 1e-3), **cost)
        print(f"    {folder}: gap {gap:.4f} of the spheres, at least {bound:.4f}; "
              f"part {part:.4f}, {len(run.time())} steps")


def mesh_error(edge, gap):
    """bound: of the gap at rest, for equilateral triangles on the sphere.

    Their area is that of flat ones that enclose the sphere's volume: with slopes
    of r/R from their middles, of mean square edge^2/12 R^2, it is edge^2/24 R^2 too
    large. The law is taken at the middles of parts of edges h, by which an integral
    of p over a plane is off by h^2/48 of that of its Laplacian, which is the slope
    at the border of the zone within the range: -3 b/range^4 times r/R. Half as much
    again for higher terms and unequal edges.
    """
    d = gap - MINIMUM
    h = edge / np.ceil(edge / (0.25 * np.sqrt(2 * RADIUS * RANGE)))
    border = 2 * np.pi * 2 * (RANGE - d) * 3 * STRENGTH / RANGE**4
    force = FORCE * edge**2 / (24 * RADIUS**2) + border * h**2 / 48
    stiffness = 2 * np.pi * RADIUS * STRENGTH * (1 / d**3 - 1 / RANGE**3)
    return 1.5 * force / stiffness


def height(name):
    run = Case(f"runs/{name}")
    return run, run.position("a")[-1, 1] - RADIUS


def pressed():
    exact = rest()
    steps = sorted(glob.glob("runs/step*"), key=lambda p: float(p[9:]))
    base, gap = height("step1000")
    for folder in steps:
        run, other = height(folder[5:])
        if folder != "runs/step1000":
            # bound: at rest no step moves it: a hundredth of what the mesh costs
            results.add(f"rest_{folder[5:]}", other, gap, 1e-3, seconds=run.seconds,
                        cells=run.cells)
    if quick:
        results.add("rest_gap_edge1.2", gap, exact, mesh_error(1.2, exact) / exact,
                    seconds=base.seconds, cells=base.cells)
        return
    found = [height(name) for name in EDGES]
    errors = [abs(gap - exact) / exact for _, gap in found]
    for (name, h), (run, gap) in zip(EDGES.items(), found):
        results.add(f"rest_gap_edge{h}", gap, exact, mesh_error(h, exact) / exact,
                    seconds=run.seconds, cells=run.cells)
    orders = plots.convergence("rest.png", list(EDGES.values()), {"gap": errors},
                               xlabel="edge of the triangles (µm)",
                               title="A sphere pressed on a wall: where it rests")
    # bound: second order, as above
    results.at_least("rest_order", orders["gap"][-1], 1.8)


def main():
    collisions()
    pressed()
    results.write()


if __name__ == "__main__":
    main()
