# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What study.py and check.py compare."""

CELL, BEAD = "elasticBodies/cell/", "bodies/bead/"
FORCES = {
    "tether_of_cell": CELL + "tether",
    "force_on_bead": BEAD + "force/fluid",
    "torque_on_bead": BEAD + "torque/fluid",
}
AXES = CELL + "semiAxes"


def rows(run, table):
    """Of all steps, without the time."""
    return run.history[table].array[:, 1:]
