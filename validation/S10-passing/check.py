# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare path and shape at 9.32 ms for meshes and steps; write results.csv."""

import sys

from fsbi.case import Case
from fsbi.results import Results

START = -12         # um, where the tumour cell comes from
CENTRE = 0.775      # um, the leukocyte's at the start
quick = sys.argv[1:2] == ["true"]
# bound: the issue asks for convergence with mesh and step without a number. Second
# order: (edge/radius)^2 of the leukocyte, and shear rate times step (first order,
# that of the first step; the others are of second)
MESH = 0.09 if quick else 0.05        # edges of 1.2 and of 0.9 um, radius 4 um
STEP = 5e-5 * 466
results = Results("S10")


def figures(run):
    """What is compared at the end."""
    x, y = run.position("tumourCell")[-1, :2]
    axes = run.history["elasticBodies/leukocyte/semiAxes"]
    centre = run.history["elasticBodies/leukocyte/centre"]
    yield "path_of_tumourCell", x - START
    yield "height_of_tumourCell", y
    yield "leukocyte_downstream", centre["x"][-1] - CENTRE
    for name in ("longest", "middle", "shortest"):
        yield f"{name}_semiaxis", axes[name][-1]


def compare(name, with_name, label, bound):
    run, other = Case(f"runs/{name}"), Case(f"runs/{with_name}")
    for (quantity, value), (_, exact) in zip(figures(run), figures(other)):
        results.add(f"{quantity}_{label}", value, exact, bound,
                    seconds=run.seconds, cells=run.cells)
    print(f"    {name} against {with_name}: {run.seconds:.0f} s and {other.seconds:.0f} s, "
          f"{run.cells} and {other.cells} cells")


def main():
    compare("mesh1", "mesh2", "by_mesh", MESH)
    if not quick:
        compare("mesh1", "shortSteps", "by_step", STEP)
    results.write()


if __name__ == "__main__":
    main()
