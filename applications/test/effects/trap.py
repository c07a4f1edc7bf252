# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A body in an optical trap: x' = -x/tau, tau = drag/k."""

import sys

import numpy as np

from fsbi.history import History


def displacement(step):
    history = History(f"trap{step}/postProcessing/history.h5")
    return history["bodies/tumourCell/position"]["x"] - 60


ends = {step: displacement(step)[-1] for step in (50, 100, 200)}
order = np.log2((ends[200] - ends[100]) / (ends[100] - ends[50]))
last = ends[50] + (ends[50] - ends[100]) / 3
tau = 1000 / np.log(4 / last)
drag = 0.15 * tau / (6 * np.pi * 8)
# the walls, 7.5 radii away, add a good tenth; coarse triangles take some away
print(f"order {order:.2f}, drag {drag:.3f} of Stokes's, long steps: "
      f"{displacement(100000)}")
if not 1.7 < order < 2.3:
    sys.exit(f"order {order:.2f}")
if not 1.0 < drag < 1.4:
    sys.exit(f"drag {drag:.3f} of Stokes's")
if np.max(np.abs(displacement(100000)[3:])) > 0.1 or np.abs(displacement(100000)[-1]) > 1e-3:
    sys.exit("steps of 100 time constants do not end in the trap")
