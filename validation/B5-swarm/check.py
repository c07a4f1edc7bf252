# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does every body reach its own target, with the one field and the currents
that the coils may have? Writes results.csv."""

import glob
import os
import re

import numpy as np

from fsbi.case import Case
from fsbi.results import Results

TOLERANCE, LIMIT, FIELD = 0.5, 1, 1e-3              # um, A, T
FACTOR = 0.8**1.5 * 4e-7 * np.pi * 100 / 0.05       # of the Helmholtz pairs, T/A
results = Results("B5")

for folder in sorted(glob.glob("runs/*")):
    run, name = Case(folder), os.path.basename(folder)
    control = run.history["effects/magnetics/controller"]
    with open(folder + "/constant/effects") as file:
        targets = dict(re.findall(r"(\w+)\s*\{\s*target\s*\(([^)]*)\)", file.read()))
    cost = dict(seconds=run.seconds, cells=run.cells)
    for body, target in targets.items():
        # bound: the controller's own tolerance
        left = np.subtract([float(x) for x in target.split()], run.position(body)[-1])
        results.add(f"distance_{body}_{name}_abs", np.linalg.norm(left[:2]), 0, TOLERANCE,
                    **cost)
    there = np.max([control[f"distance.{b}"] for b in targets], axis=0) <= TOLERANCE
    # bound: they stay there for a row of the history and more
    results.at_least(f"rest_at_targets_{name}", there.mean(), 0.01)
    I = np.array([control["I." + i] for i in "xyz"]).T
    on = control["mode"] > 0
    # bound: the currents' own limit
    results.add(f"largest_current_{name}_abs", np.abs(I).max(), 0, LIMIT)
    # the currents' own field is the one that bodies are in, the same for all
    for body in targets:
        magnet = run.history[f"effects/magnetics/{body}"]
        B = np.array([magnet["B" + i] for i in "xyz"]).T
        # bound: B and I come from one formula; ten times its constants' digits
        results.add(f"field_at_{body}_{name}_abs",
                    np.abs(B - FACTOR * I).max() / FIELD, 0, 1e-5)
    # bound: no current is none
    results.add(f"field_when_off_{name}_abs", np.abs(I[~on]).max(initial=0), 0, 0)
results.write()
