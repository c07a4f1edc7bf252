# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the function object exactError found: distances from an exact solution.

    from fsbi import errors

    run = errors.read("case")           # the latest time's
    run["cells"], run["h"], run["D_l2"], run["sigma_max"]
    study = errors.Study("runs/hexahedra*")         # one mesh a folder
    study.h, study.error("D"), study.order("D")

On the command line, `python3 -m fsbi.errors CASE` prints them.
"""

import csv
import glob
import os
import sys

import numpy as np

from . import convergence
from .case import cases

NAMES = {"D": "displacement", "sigma": "stress of cells",
         "pointSigma": "stress at points"}


def read(case=".", name="errors"):
    files = glob.glob(os.path.join(case, "postProcessing", name, "*", "errors.csv"))
    if not files:
        raise FileNotFoundError(f"{case} has no postProcessing/{name}/*/errors.csv")
    latest = max(files, key=lambda f: float(f.split(os.sep)[-2]))
    with open(latest, newline="") as file:
        row = next(csv.DictReader(file))
    return {k: float(v) for k, v in row.items()}


class Study:
    """The finished runs among folders that match, from coarse to fine."""

    def __init__(self, pattern):
        runs = [(read(run.folder), run) for run in cases(pattern)]
        runs.sort(key=lambda item: -item[0]["h"])
        self.runs = [run for _, run in runs]
        self._errors = [found for found, _ in runs]
        self.h = np.array([found["h"] for found in self._errors])

    def error(self, field, norm="l2"):
        return np.array([found[f"{field}_{norm}"] for found in self._errors])

    def order(self, field):
        """Of the finest pair, in the l2 norm."""
        return convergence.orders(self.h, self.error(field))[-1]

    def cost(self, i=-1):
        """Of one run, by default the finest, for results.csv."""
        return dict(seconds=self.runs[i].seconds, cells=self.runs[i].cells)


def show(case="."):
    found = read(case)
    for field, name in NAMES.items():
        if f"{field}_l2" in found:
            print(f"    error of the {name:17s} {found[f'{field}_l2']:.1e}"
                  f"  (largest {found[f'{field}_max']:.1e})")


if __name__ == "__main__":
    show(*sys.argv[1:2])
