# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of every step of a run, from postProcessing/steps.

    for step in steps.tried("case"):
        step.time, step.length, step.accepted, step.reason
    parts, rows = steps.seconds("case")     # time, then seconds so far by part
"""

import os
from dataclasses import dataclass

import numpy as np


@dataclass
class Step:
    time: float
    length: float
    accepted: bool
    iterations: int         # Krylov
    corrections: int        # Newton
    residual: float
    gap: float              # nan: there is none
    reason: str             # who asked for this length, or why it was rejected


def _starts(case):
    folder = os.path.join(case, "postProcessing", "steps")
    names = os.listdir(folder) if os.path.isdir(folder) else []
    return sorted((float(n), os.path.join(folder, n)) for n in names)


def _parts(case, file):
    """Headers and rows of the runs that a history consists of, in their order;
    a run that began later replaces what an earlier one did from there on."""
    starts = _starts(case)
    for i, (_, folder) in enumerate(starts):
        path = os.path.join(folder, file)
        if not os.path.isfile(path):
            continue
        end = starts[i + 1][0] if i + 1 < len(starts) else np.inf
        with open(path) as text:
            lines = text.read().split("\n")[:-1]        # the last one may be torn
        rows = [line for line in lines[1:] if float(line.split(" ", 1)[0]) <= end * (1 + 1e-9)]
        yield lines[0].split()[1:], rows


def tried(case):
    found = []
    for _, rows in _parts(case, "steps.dat"):
        for row in rows:
            time, length, outcome, its, corrections, residual, gap, reason = row.split(" ", 7)
            found.append(Step(float(time), float(length), outcome == "accepted", int(its),
                              int(corrections), float(residual),
                              float(gap) if gap != "-" else np.nan, reason))
    return found


def seconds(case):
    """Names of the parts, `total` last, and rows of time and seconds by part, of
    all runs together."""
    names, rows = [], []
    before = {}
    for header, lines in _parts(case, "seconds.dat"):
        now = before
        names += [n for n in header[1:] if n not in names]
        for line in lines:
            values = [float(v) for v in line.split()]
            now = {n: v + before.get(n, 0) for n, v in zip(header[1:], values[1:])}
            rows.append((values[0], {**before, **now}))
        before = {**before, **now}
    names.sort(key=lambda n: n == "total")
    return names, np.array([[t] + [v.get(n, 0) for n in names] for t, v in rows])
