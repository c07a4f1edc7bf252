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

STRENGTH, RANGE, MINIMUM = 1e-3, 1, 0.2     # constant/effects
RADIUS, FORCE = 4, 0.2                      # of the pressed sphere
APPROACH = 0.2                              # maxApproach, of gaps of triangles, which
FACETS = 1.1                                # lie askew to the line of centres by 0.17 rad
                                            # and turn: a tenth of the speed
EDGES = {"step1000": 1.2, "edge0.6": 0.6, "edge0.3": 0.3}
quick = sys.argv[1] == "true"
results = Results("S13")


def rest():
    """Gap of a sphere at which the integral of the pressure over it is the
    force: its zones have the area 2 pi a dd."""
    def excess(h):
        bracket = (1 / h**2 - 1 / RANGE**2) / 2 - (RANGE - h) / RANGE**3
        return 2 * np.pi * RADIUS * STRENGTH * bracket - FORCE
    return MINIMUM + brentq(excess, 1e-3 * RANGE, RANGE)


def radii(run):
    with open(f"{run.folder}/constant/bodies") as file:
        return [float(r) for r in re.findall(r"radius ([0-9.]+);", file.read())]


def pairs(run):
    """Gap and closing speed of the true spheres and the wall, per pair: rows
    of all times."""
    (xa, xb), (va, vb) = ([f(name) for name in "ab"] for f in (run.position, run.velocity))
    ra, rb = radii(run)
    between = xb - xa
    distance = np.linalg.norm(between, axis=1)
    closing = -np.sum((vb - va) * between, axis=1) / distance
    yield distance - ra - rb, closing
    for x, v, r in ((xa, va, ra), (xb, vb, rb)):
        yield x[:, 1] - r, -v[:, 1]


def collision(run):
    """Smallest recorded gap; largest part of it that a step could have closed
    at the speed of its beginning, of the pair that is nearest then."""
    gap = run.history["effects/repulsion/gap"]
    smallest, step = gap["smallest"], np.diff(gap["time"])
    gaps, closing = (np.array(rows) for rows in zip(*pairs(run)))
    nearest = np.argmin(gaps, axis=0), np.arange(gaps.shape[1])
    known = smallest[:-1] < MINIMUM + RANGE
    part = step * closing[nearest][:-1] / smallest[:-1]
    return smallest.min(), gaps.min(), part[known].max()


def collisions():
    runs = sorted(glob.glob("runs/collision*"), key=lambda p: int(p[14:]))
    closest, parts = [], []
    for run in map(Case, runs):
        recorded, true, part = collision(run)
        closest.append(recorded)
        parts.append(part)
        results.at_least(f"gap_{run.folder[5:]}", recorded, MINIMUM,
                         seconds=run.seconds, cells=run.cells)
        results.add(f"part_of_gap_{run.folder[5:]}_abs", part, 0, APPROACH * FACETS,
                    seconds=run.seconds, cells=run.cells)
        print(f"    {run.folder}: gap {recorded:.4f} (of the spheres without facets "
              f"{true:.4f}), part {part:.3f}, {len(run.time())} steps")
    return closest, parts


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
            results.add(f"rest_{folder[5:]}", other, gap, 1e-3, seconds=run.seconds,
                        cells=run.cells)
    if quick:
        results.add("rest_gap_edge1.2", gap, exact, 0.06, seconds=base.seconds,
                    cells=base.cells)
        return
    found = [height(name) for name in EDGES]
    errors = [abs(gap - exact) / exact for _, gap in found]
    for (name, h), (run, gap) in zip(EDGES.items(), found):
        bound = 0.06 * (h / 1.2) ** 2
        results.add(f"rest_gap_edge{h}", gap, exact, bound, seconds=run.seconds,
                    cells=run.cells)
    orders = plots.convergence("rest.png", list(EDGES.values()), {"gap": errors},
                               xlabel="edge of the triangles (µm)",
                               title="A sphere pressed on a wall: where it rests")
    results.at_least("rest_order", orders["gap"][-1], 1.8)


collisions()
pressed()
results.write()
