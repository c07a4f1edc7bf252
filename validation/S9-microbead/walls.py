# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tether against the walls: what holds the bead leaves the fluid through its
outer boundaries. Appends to results.csv."""

import numpy as np

from fsbi.case import cases
from fsbi.convergence import orders
from fsbi.results import Results
from wall_force import wall_force

RADIUS = 4
EDGES = np.array([1.2, 0.8, 0.53])      # um, of runs/walls1 ...

results = Results("S9")
errors = []


def imbalance(run, edge):
    """|walls + tether| over the tether."""
    force = wall_force(run.folder + "/4000/fluid", rate=5e-5, mu=1,
                       walls=("bottomWall", "topWall", "sides"))
    tether = run.history["elasticBodies/microbead/tether"].array[-1, 1:]
    print(f"    edges of {edge} um, {run.folder}: walls {1e3 * force}, tether {1e3 * tether} pN")
    return np.linalg.norm(force + tether) / np.linalg.norm(tether)


def main():
    for edge, run in zip(EDGES, cases("runs/walls*")):
        errors.append(imbalance(run, edge))
        # bound: a sum over walls by second order fits, (edge/radius)^2, factor 1
        results.add(f"walls_plus_tether_edge{edge:g}_abs", errors[-1], 0, (edge / RADIUS)**2,
                    seconds=run.seconds, cells=run.cells)
    for edge, error, run in zip(EDGES, errors, cases("runs/order4.walls*")):
        # bound: asked for: errors four times smaller on equal cells
        results.add(f"walls_plus_tether_order4_over_order2_edge{edge:g}_abs",
                    imbalance(run, edge) / error, 0, 0.25, seconds=run.processor_seconds,
                    cells=run.cells)
    if len(errors) == len(EDGES):
        # bound: second order in theory; 0.2 for meshes that are not similar
        results.at_least("walls_plus_tether_order",
                         orders((EDGES[0], EDGES[-1]), (errors[0], errors[-1]))[0], 1.8)
    results.write(append=True)


if __name__ == "__main__":
    main()
