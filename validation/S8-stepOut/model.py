# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A rigid magnet in a turning field by its mobility alone: far from walls that
is constant in body axes, and six numbers follow from an ordinary differential
equation."""

import csv

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation


def resistance(folder):
    """The matrix that fsbiResistance wrote, made symmetric as it is without
    discretisation errors."""
    with open(folder + "/postProcessing/resistance.csv") as file:
        rows = list(csv.reader(file))
    R = np.array([[float(x) for x in row[2:8]] for row in rows[1:]])
    return 0.5 * (R + R.T)


def turned(mobility, moment, torque, speed, lag, times):
    """Axis of the body (its z) and moment's direction at some times, in a field
    in the x-y plane that begins `lag` before the x axis; torque: m B."""
    def rates(t, q):
        R = Rotation.from_quat(q)
        field = [np.cos(speed * t + lag), np.sin(speed * t + lag), 0]
        load = torque * np.cross(R.apply(moment), field)
        w = R.apply(mobility[3:, 3:] @ R.inv().apply(load))
        return 0.5 * np.append(q[3] * w + np.cross(w, q[:3]), -w @ q[:3])

    way = solve_ivp(rates, (0, times[-1]), [0, 0, 0, 1], t_eval=times, rtol=1e-9,
                    atol=1e-11)
    R = Rotation.from_quat(way.y.T)
    return R.apply([0, 0, 1]), R.apply(moment)
