# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does the history hold what happened, when it happened?

    check_history.py instants|state|series|steps|notes
"""

import subprocess
import sys

import numpy as np

from fsbi import steps
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


def tried():
    rows = steps.tried("case")
    accepted = [r for r in rows if r.accepted]
    same("times", [r.time for r in accepted], [500, 1000, 1500])
    same("lengths", [r.length for r in accepted], history["cost"]["step"])
    same("iterations", [r.iterations for r in accepted], history["cost"]["iterations"])
    same("corrections", [r.corrections for r in accepted], history["cost"]["corrections"])
    assert {r.reason for r in accepted} == {"deltaT"}, accepted
    # half a step fails as well: its solver may not iterate
    failed = [r for r in rows if not r.accepted]
    assert len(failed) == int(sys.argv[2]), failed
    assert all("residual" in r.reason for r in failed), failed
    parts, seconds = steps.seconds("case")
    assert parts[-2:] == ["repulsion", "total"], parts
    same("times", seconds[:, 0], [500, 1000, 1500])
    assert (np.diff(seconds, axis=0) >= 0).all(), seconds
    assert (seconds[:, 1:-1].sum(axis=1) <= seconds[:, -1]).all(), seconds


def notes():
    with open("case/log.dry") as log:
        told = log.read().split("Defaults taken\n")[1].split("\n\n")[0]
    about = history.runs["0"]
    assert about["effects"] == ["repulsion"], about
    assert about["bodies"] == ["rigid bead", "elastic cell"], about
    assert [d.strip() for d in about["defaults"]] == [d.strip() for d in told.splitlines()], about
    same("cells", int(about["cells"][0]), history["cost"]["cells"][0])
    assert about["libraries"][0].startswith("OpenFOAM v"), about


{"instants": instants, "state": state, "series": series, "steps": tried,
 "notes": notes}[sys.argv[1]]()
