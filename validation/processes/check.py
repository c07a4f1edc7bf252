# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the histories of every scene with the run on one process; write
results.csv. A difference is relative to the largest number of its table, of
forces and torques to the largest of all bodies."""

import math
import os
import sys

import numpy as np

from fsbi.case import Case
from fsbi.results import Results

RUNS = {"np2": "np 2", "np4": "np 4", "2to2": "restart", "2to1": "2 to 1", "2to4": "2 to 4"}
BOUND = 1e-5        # what is left of forces that nearly cancel has few digits
results = Results("processes")


def tables(history):
    """Numbers by path; without times and seconds of wall clock."""
    return {
        path: history[path].array[:, [
            i for i, c in enumerate(history[path].columns)
            if c not in ("time", "seconds")]]
        for path in history.paths()
        if path != "cost"
    }


def scale_of(path):
    """What is measured by one scale: a table, or all forces or torques."""
    for load in ("/force/", "/torque/"):
        if load in path:
            return load
    return path


def difference(one, other):
    first, second = tables(one.history), tables(other.history)
    if first.keys() != second.keys() or not first:
        return math.nan
    scales = {}
    for path, table in first.items():
        size = np.max(np.abs(table), initial=0)
        scales[scale_of(path)] = max(size, scales.get(scale_of(path), 0))
    worst = 0
    for path, table in first.items():
        if table.shape != second[path].shape:
            return math.nan
        largest = np.max(np.abs(table - second[path]), initial=0)
        # a table of nothing but round-off has no scale
        if scales[scale_of(path)] > 0:
            change = largest / scales[scale_of(path)]
            if not change <= worst:
                worst = change
                print(f"  {path}: {change:.1e}")
    return worst


def folder(scene, run):
    return f"runs/{scene}.{run.removeprefix('np')}"


for scene in sys.argv[1:]:
    if not os.path.isdir(f"runs/{scene}"):
        print(f"{scene}: not run")
        continue
    for run in RUNS:
        print(scene, run)
        try:
            one, other = Case(folder(scene, "np1")), Case(folder(scene, run))
            worst, cost = difference(one, other), dict(cells=one.cells, seconds=other.seconds)
        except (OSError, KeyError, IndexError) as fault:
            print(f"{scene} {run}: {fault}")
            worst, cost = math.nan, {}
        results.add(f"{scene}_{run}_abs", worst, 0, BOUND, procs=int(run[-1]), **cost)
results.write()
