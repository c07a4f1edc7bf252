# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes in through the inlet of a bifurcation and does not go out, over what comes
in; the way of a cell in an array of posts by where sides of the computation are; which
rows of posts beads go along; write results.csv."""

import os
import re

import numpy as np
from scipy.optimize import brentq

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


def critical_diameters(gap, shift):
    """Of beads in an array of posts whose rows the flow crosses by this part of a row from
    post to post: by the part of a parabola's flow beside a post that goes on into the next
    gap (Inglis et al., Lab Chip 6 (2006) 655), and by experiments (Davis, thesis,
    Princeton 2008: 1.4 gap shift^0.48)."""
    # of the flow the part within a distance of the post: 3 y^2 - 2 y^3, y over the gap
    y = brentq(lambda y: 3 * y**2 - 2 * y**3 - shift, 0, 0.5)
    return 2 * y * gap, 1.4 * gap * shift**0.48


def displacement(results):
    """Rows of posts that a bead climbs while it passes two posts after the first."""
    theory, experiments = critical_diameters(10, 0.1)
    for run in cases("runs/*_bead"):
        name = os.path.basename(run.folder)
        radius = {"large_bead": 2.5, "small_bead": 1.5}[name]
        path = run.position("bead")
        touching = run.history["effects/contact/nearest"]["distance"].min()
        # contact keeps surfaces apart, which is as if beads were larger by it
        diameter = 2 * (radius + touching)
        print(f"    {name}: diameter {diameter:.2f} um with contact, critical {theory:.2f} "
              f"(theory), {experiments:.2f} (experiments)")
        # bound: a row is a row; a bead between theory and experiments has no reference
        rows = 0 if diameter > experiments else 1 if diameter < theory else np.nan
        results.add(f"{name}_rows_climbed_abs", np.floor(path[-1, 1] / 20), rows, 0.5,
                    variant="pillarArray", seconds=run.processor_seconds,
                    cells=run.cells)


def main():
    results = Results("C3")
    displacement(results)
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
