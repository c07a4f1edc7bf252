# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere at Reynolds numbers 1 to 100 against finite elements (sphere_drag.py);
write results.csv."""

import csv
import math
import sys

from fsbi.case import Case
from fsbi.convergence import order_of_three
from fsbi.results import Results

BODY, RADIUS = "tumourCell", 8
quick = sys.argv[1:2] == ["true"]
EDGES = {1: (0.3, 0.2, 0.133), 20: (0.3, 0.2, 0.133), 100: (0.2, 0.14, 0.1)}
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


def steady(reynolds, edges):
    exact = reference()[reynolds]
    values = [drag(f"Re{reynolds}_{edge}", reynolds)[0][-1] for edge in edges]
    run = drag(f"Re{reynolds}_{edges[-1]}", reynolds)[1]
    # bound: of an error of the order p, with edges r times as long, what is left is the
    # change over r^p - 1; p = 1.7: second order on meshes that are not similar
    change = abs(values[-2] / values[-1] - 1)
    results.add("drag", values[-1], exact, change / ((edges[-2] / edges[-1])**1.7 - 1),
                variant=f"Re{reynolds}", seconds=run.seconds, cells=run.cells)
    if len(edges) > 2:
        # bound: the same
        results.at_least("order", order_of_three(edges, values), 1.7,
                         variant=f"Re{reynolds}")


def moving():
    held, still = drag("heldBegun", 20)
    moved, run = drag("moving", 20)
    log = open("runs/moving/log.fsbiFoam", errors="replace").read()
    results.add("healed_meshes_abs", float("\nHealing" in log), 1, 0)
    # bound: both are off by the error of that mesh, which may differ with the mesh
    error = abs(drag("Re20_0.3", 20)[0][-1] / reference()[20] - 1)
    results.add("moving_over_held_abs", abs(moved / held - 1)[-1], 0, 2 * error,
                seconds=run.seconds, cells=still.cells)
    # limit: 0.072 was measured in the one step after a new mesh of edges of 0.3 radii: what
    # the gradients of the last flow do not know of the boundary layer, in one step of 0.4 a/U
    results.add("step_after_new_mesh_abs", abs(moved / held - 1).max(), 0, 0.1)
    again, _ = drag("continued", 20)
    results.add("continued_difference_abs", abs(again - moved).max(), 0, 0)
    parallel, _ = drag("parallel", 20)
    # bound: other processes, other coordinates of new meshes and other sums, validation/processes
    results.add("parallel_difference_abs", abs(parallel / moved - 1).max(), 0, 2e-3, procs=2)


def main():
    for number in (1, 20) if quick else (1, 20, 100):
        steady(number, EDGES[number][:2] if quick else EDGES[number])
    moving()
    results.write()


if __name__ == "__main__":
    main()
