# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere at Reynolds numbers 1 to 100 against finite elements (sphere_drag.py), and
lift on a sphere in a square channel (lift_in_channel.py); write results.csv."""

import math
import sys

import numpy as np

from fsbi.case import Case, reference
from fsbi.convergence import order_of_three
from fsbi.results import Results

BODY, RADIUS = "tumourCell", 8
quick = sys.argv[1:2] == ["true"]
EDGES = {1: (0.3, 0.2, 0.133), 20: (0.3, 0.2, 0.133), 100: (0.2, 0.14, 0.1)}
HEIGHTS = (0.08, 0.16, 0.24, 0.32)      # over the channel's width
LIFT = 0.8**2 * 12.5**4 / 50**2         # density Um^2 d^4/H^2
results = Results("E1")


def drag_reference(reynolds):
    row, = (row for row in reference("sphere_drag.csv") if row["Re"] == reynolds)
    return row["drag"]


def drag(name, reynolds):
    """F/(rho U^2/2 pi a^2) of every step, and the run."""
    run = Case(f"runs/{name}")
    speed = reynolds / (2 * RADIUS)
    return abs(run.force(BODY)[:, 0]) / (speed**2 / 2 * math.pi * RADIUS**2), run


def steady(reynolds, edges):
    exact = drag_reference(reynolds)
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
    error = abs(drag("Re20_0.3", 20)[0][-1] / drag_reference(20) - 1)
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


def followed():
    """New meshes of a domain that goes along are those of one at rest in the flow."""
    held, still = drag("joinedHeld", 20)
    gone, run = drag("joinedFollowed", 20)
    log = open("runs/joinedFollowed/log.fsbiFoam", errors="replace").read()
    results.at_least("new_meshes", log.count("\nRemeshing"), 1)
    # bound: tolerance of solutions, and other coordinates of new meshes, as below
    results.add("followed_over_held_abs", abs(gone / held - 1).max(), 0, 2e-3,
                seconds=run.seconds, cells=still.cells)


def left(coarse, fine, edges):
    """Error that a value has left: see steady()."""
    return abs(fine - coarse) / ((edges[-2] / edges[-1])**1.7 - 1)


def lift(name):
    """Coefficient, and the run."""
    run = Case(f"runs/{name}")
    return run.force("cell")[-1, 1] / LIFT, run


def lift_references():
    """Coefficients by height on the last two meshes of finite elements."""
    rows = [row for row in reference("lift_in_channel.csv") if row["Re"] > 0]
    return {height: [row["lift"] for row in rows if row["height"] == height][-2:]
            for height in HEIGHTS}


def focus(lifts):
    """Height at which the cubic through all lifts vanishes between the outer two."""
    roots = np.roots(np.polyfit(HEIGHTS, lifts, 3))
    between = [root.real for root in roots
               if abs(root.imag) < 1e-9 and HEIGHTS[-2] < root.real < HEIGHTS[-1]]
    return between[0] if between else math.nan


def lifts(edges, heights):
    references, found = lift_references(), []
    for height in heights:
        coarse, fine = (lift(f"lift{height}_{edge}")[0] for edge in edges[-2:])
        run = lift(f"lift{height}_{edges[-1]}")[1]
        before, exact = references[height]
        # bound: what the run has left, as the drag, and the reference's own error, its change
        # with edges 1.4 times as long: what second order has left, it should be of third
        results.add("lift_abs", fine, exact, left(coarse, fine, edges) + abs(exact - before),
                    variant=f"y{height}", seconds=run.seconds, cells=run.cells)
        found.append((coarse, fine))
    if len(heights) == len(HEIGHTS):
        coarse, fine = (focus(values) for values in zip(*found))
        before, exact = (focus(values) for values in zip(*references.values()))
        # bound: the same
        results.add("focusing_abs", fine, exact,
                    left(coarse, fine, edges) + abs(exact - before))


def lift_without_inertia(edges):
    """Stokes flow may be run backwards: no lift. What there is, is the mesh's error."""
    values = [lift(f"stokes0.24_{edge}")[0] for edge in edges]
    run = lift(f"stokes0.24_{edges[-1]}")[1]
    # bound: what the change between meshes leaves
    results.add("lift_Stokes_abs", values[-1], 0, left(values[-2], values[-1], edges),
                seconds=run.seconds, cells=run.cells)


def inertial_lift():
    edges = (0.3, 0.2) if quick else (0.3, 0.2, 0.15)
    lifts(edges, HEIGHTS[2:3] if quick else HEIGHTS)
    lift_without_inertia(edges)


def main():
    for number in (20,) if quick else (1, 20, 100):
        steady(number, EDGES[number][:2] if quick else EDGES[number])
    moving()
    followed()
    inertial_lift()
    results.write()


if __name__ == "__main__":
    main()
