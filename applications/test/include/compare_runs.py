#!/usr/bin/env python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the histories of two runs, and the fields of one time folder.

    compare_runs.py case case [--tolerance 1e-10] [--fields TIME]
        [--only path ...] [--but end] [--upTo TIME]

The difference is relative to the largest number of a table; of forces, and of
torques, to the largest of all bodies, as on free bodies they nearly cancel.
Times, which would be the largest, must be equal, and seconds of wall clock are
left out. Exit code 1, with the worst table, if it is larger.
"""

import argparse
import os
import sys

import numpy as np

from fsbi.history import History


def rows(table, last):
    """Its numbers up to a time, without times."""
    kept = [i for i, c in enumerate(table.columns) if c not in ("time", "seconds")]
    return table.array[table["time"] <= last if last < np.inf else slice(None)][:, kept]


def kind(path):
    """What is measured by one scale: a table, or all forces or torques."""
    for load in ("/force/", "/torque/"):
        if load in path:
            return load
    return path


def difference(a, b, scale):
    if a.shape != b.shape:
        sys.exit(f"{a.shape} and {b.shape} rows and columns")
    worst = np.max(np.abs(a - b)) / max(scale, 1e-300)
    return worst if np.isfinite(worst) else np.inf


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cases", nargs=2)
    parser.add_argument("--tolerance", type=float, default=1e-10)
    parser.add_argument("--fields", help="these must be equal to the last bit")
    parser.add_argument("--only", nargs="+", default=["bodies/"])
    parser.add_argument("--but", help="leave out tables whose name ends so")
    parser.add_argument("--upTo", type=float, default=np.inf, help="the last time compared")
    options = parser.parse_args()

    def numbers(table):
        return rows(table, options.upTo)

    first, second = [
        History(os.path.join(case, "postProcessing", "history.h5"))
        for case in options.cases
    ]
    compared, others = [
        [p for p in history.paths() if p.startswith(tuple(options.only))
         and not (options.but and p.endswith(options.but))]
        for history in (first, second)
    ]
    if compared != others:
        sys.exit("the histories have other tables")
    # a body that is never in the domain has no rows in either
    compared = [p for p in compared if len(first[p]) or len(second[p])]
    if not compared:
        sys.exit("no rows")
    scales = {}
    for p in compared:
        size = np.max(np.abs(numbers(first[p])), initial=0)
        scales[kind(p)] = max(size, scales.get(kind(p), 0))
    worst = max(
        (difference(numbers(first[p]), numbers(second[p]), scales[kind(p)]), p)
        for p in compared
    )
    print(f"largest difference {worst[0]:.2e} in {worst[1]}")
    if worst[0] > options.tolerance:
        sys.exit(f"difference {worst[0]:.2e} in {worst[1]}")

    times, others = [t[t <= options.upTo] for t in
                     (history["cost"]["time"] for history in (first, second))]
    if not np.array_equal(times, others):
        sys.exit("the steps are others")
    if np.any(np.diff(times) <= 0):
        sys.exit("rows are there twice")

    for name in ("fluid/U", "fluid/p", "fluid/polyMesh/points"):
        if options.fields:
            bytes_ = []
            for case in options.cases:
                with open(os.path.join(case, options.fields, name), "rb") as f:
                    bytes_.append(f.read())
            if bytes_[0] != bytes_[1]:
                sys.exit(f"{name} differs")


main()
