# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes in through the inlet of a bifurcation and does not go out, over what comes
in; write results.csv."""

import os

import numpy as np

from fsbi.case import Case, cases
from fsbi.results import Results

# bound: of what the tolerance leaves in the equations of n cells, the sum is at most
# the root of n times its norm; of flows solved to round-off: asked for
BOUND = {"1e-12": lambda cells: 1e-10, "1e-6": lambda cells: 1e-6 * cells**0.5}


def main():
    results = Results("C3")
    for run in cases("runs/*"):
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
