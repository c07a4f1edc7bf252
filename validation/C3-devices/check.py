# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes in through the inlet of a bifurcation and does not go out, over what comes
in; the way of a cell in an array of posts by where sides of the computation are; write
results.csv."""

import os
import re

import numpy as np

from fsbi.case import Case, cases
from fsbi.results import Results

# bound: of what the tolerance leaves in the equations of n cells, the sum is at most
# the root of n times its norm; of flows solved to round-off: asked for
BOUND = {"1e-12": lambda cells: 1e-10, "1e-6": lambda cells: 1e-6 * cells**0.5}


def gaps(run):
    with open(os.path.join(run.folder, "log.fsbiFoam")) as log:
        return np.array(re.findall(r"^Time = .* gap (\S+)", log.read(), re.M), float)


def across_sides(results):
    """Places, gaps and velocities of the cell that passes a side against those of one that
    does not, over its way and its velocity."""
    across, within = (Case(f"runs/{name}") for name in ("across", "within"))
    x, y = (run.position("cell") for run in (across, within))
    if not x[0, 0] < -10 < x[-1, 0]:
        raise SystemExit("the cell does not pass the side")
    # bound: the same scene on other meshes, each good for 2 % of the drag (C2-suspensions)
    results.add("places_apart_abs", np.linalg.norm(x - y, axis=1).max()
                / np.linalg.norm(y[-1] - y[0]), 0, 0.02, variant="post_array",
                seconds=across.processor_seconds, cells=across.cells)
    # bound: as far as places, on which they depend
    results.add("gaps_apart_abs", np.abs(gaps(across) - gaps(within)).max()
                / np.linalg.norm(y[-1] - y[0]), 0, 0.02, variant="post_array")
    v, w = (run.history["bodies/cell/velocity"].array[:, 1:] for run in (across, within))
    results.add("velocities_apart_abs", np.linalg.norm(v - w, axis=1).max()
                / np.linalg.norm(w, axis=1).max(), 0, 0.02, variant="post_array")


def main():
    results = Results("C3")
    across_sides(results)
    for run in cases("runs/1e*"):
        tolerance = os.path.basename(run.folder)
        case = Case(run.folder)
        inflow, left = 0, 0
        for patch in ("inlet", "lower", "upper"):
            table = case.history[f"flow/{patch}"]
            inflow = inflow + table["in"]
            left = left + table["in"] - table["out"]
        results.add("mass_lost_abs", np.max(np.abs(left / inflow)), 0,
                    BOUND[tolerance](case.cells), variant=f"tolerance_{tolerance}",
                    seconds=case.processor_seconds, cells=case.cells)
    results.write()


if __name__ == "__main__":
    main()
