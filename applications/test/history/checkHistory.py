# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the history hold what happened, when it happened?

    checkHistory.py instants|state|series
"""

import subprocess
import sys

import numpy as np

from fsbi.history import History

history = History("case/postProcessing/history.h5")


def same(what, found, expected, tolerance=1e-12):
    off = np.max(np.abs(np.asarray(found) - expected)) / np.max(np.abs(expected))
    if not off <= tolerance:
        sys.exit(f"{what}: {found} instead of {expected}")


def instants():
    assert len(history.paths()) > 15, history.paths()
    for path in history.paths():
        same(path, history[path]["time"], [500, 1000, 1500])
    same("steps", history["cost"]["step"], [500, 500, 500])


def saved(entry):
    """A vector of the bead's saved state."""
    text = subprocess.run(
        ["foamDictionary", "-entry", f"bodies/bead/now/{entry}", "-value",
         "case/1500/uniform/fsbiState"], capture_output=True, text=True, check=True).stdout
    return np.array(text.strip().strip("()").split(), float)


def state():
    """To the digits that foamDictionary prints."""
    for table, entry in (("position", "centre"), ("velocity", "velocity"),
                         ("angularVelocity", "angularVelocity"), ("force/fluid", "force"),
                         ("torque/fluid", "torque")):
        same(table, history["bodies/bead/" + table].array[-1, 1:], saved(entry), 1e-5)


def series():
    rows = np.loadtxt("case/postProcessing/bodies/0/bead.dat")
    tables = ["position", "orientation", "velocity", "angularVelocity", "force/fluid",
              "torque/fluid"]
    columns = [history["bodies/bead/" + table].array[:, 1:] for table in tables]
    times = history["bodies/bead/position"]["time"]
    same("bead.dat", rows, np.column_stack([times, *columns]), 1e-9)


{"instants": instants, "state": state, "series": series}[sys.argv[1]]()
