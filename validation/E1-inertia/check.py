# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere at Reynolds numbers 1 to 100 against finite elements (sphere_drag.py);
write results.csv."""

import csv
import math
import re
import sys

from fsbi.case import Case
from fsbi.convergence import order_of_three
from fsbi.results import Results

BODY, RADIUS = "tumourCell", 8
quick = sys.argv[1:2] == ["true"]
EDGES = (0.3, 0.2) if quick else (0.3, 0.2, 0.133)
results = Results("E1")


def reference():
    """Coefficients of drag by Reynolds number."""
    with open("sphere_drag.csv", newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {int(row["Re"]): float(row["drag"]) for row in rows}


def drag(name, reynolds):
    """F/(rho U^2/2 pi a^2) of every step, and the run."""
    run = Case(f"runs/{name}")
    speed = reynolds / (2 * RADIUS)
    return abs(run.force(BODY)[:, 0]) / (speed**2 / 2 * math.pi * RADIUS**2), run


def steady():
    exact = reference()
    for reynolds in (1, 20, 100):
        values = [drag(f"Re{reynolds}_{edge}", reynolds)[0][-1] for edge in EDGES]
        run = drag(f"Re{reynolds}_{EDGES[-1]}", reynolds)[1]
        # bound: with edges two thirds as long, what is left of an error of the order p is
        # the change over 1.5^p - 1, which is less than the change from 1.71 on
        results.add("drag", values[-1], exact[reynolds], abs(values[-2] / values[-1] - 1),
                    variant=f"Re{reynolds}", seconds=run.seconds, cells=run.cells)
        if not quick:
            # bound: second order, of meshes that are not similar
            results.at_least("order", order_of_three(EDGES, values), 1.5,
                             variant=f"Re{reynolds}")


def moving():
    held, still = drag("heldBegun", 20)
    moved, run = drag("moving", 20)
    late = run.time() > run.time()[-1] / 2
    # bound: both are off by the error of that mesh, which may differ with the mesh; and the
    # walls, which the sphere comes nearer to by 8 of 20 radii, feel it by less
    error = abs(drag("Re20_0.3", 20)[0][-1] / reference()[20] - 1)
    results.add("moving_over_held_abs", abs(moved / held - 1)[late].max(), 0, 2 * error,
                seconds=run.seconds, cells=still.cells)
    log = open("runs/continued/log.fsbiFoam", errors="replace").read()
    log += open("runs/continued/log.firstHalf", errors="replace").read()
    results.add("new_meshes_abs", float(len(re.findall("^Remeshing", log, re.M)) > 0), 1, 0)
    again, _ = drag("continued", 20)
    results.add("continued_difference_abs", abs(again - moved).max(), 0, 0)
    parallel, _ = drag("parallel", 20)
    # bound: other processes, other coordinates of new meshes and other sums, validation/processes
    results.add("parallel_difference_abs", abs(parallel / moved - 1).max(), 0, 2e-3, procs=2)


steady()
moving()
results.write()
