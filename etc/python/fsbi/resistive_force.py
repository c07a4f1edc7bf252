# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistive-force theory of a helix: F = a u + b w, T = b u + c w along its axis,
with the drag of a straight piece of filament, along and across it.

Abbott et al. (2009), "How should microrobots swim?", Int. J. Robotics Research 28,
1434-1447 (Gaskin 2018, 4.13-4.17), R: radius of the helix, r: of the filament, n:
turns, tan(theta) = 2 pi R/pitch, mu = 1.

    a, b, c = helix(lighthill, R=1, r=0.1, pitch=2, n=5)
    advance = -b / a                # u/w, by any torque or speed of turning
"""

import numpy as np


def lighthill(R, r, pitch):
    """[4.16-4.17]"""
    log = np.log(0.36 * np.pi * R / (r * np.sin(np.arctan2(2 * np.pi * R, pitch))))
    return 2 * np.pi / log, 4 * np.pi / (log + 0.5)


def gray_hancock(R, r, pitch):
    """Gray and Hancock (1955), J. Exp. Biol. 32, 802-814; R does not enter."""
    log = np.log(2 * pitch / r)
    return 2 * np.pi / (log - 0.5), 4 * np.pi / (log + 0.5)


def helix(coefficients, R=1, r=0.1, pitch=2, n=5):
    """a, b, c [4.14-4.15]; b < 0: a right-handed helix that turns by the right hand
    swims along the thumb."""
    theta = np.arctan2(2 * np.pi * R, pitch)
    sin, cos = np.sin(theta), np.cos(theta)
    along, across = coefficients(R, r, pitch)
    a = 2 * np.pi * n * R * (along * cos**2 + across * sin**2) / sin
    b = 2 * np.pi * n * R**2 * (along - across) * cos
    c = 2 * np.pi * n * R**3 * (across * cos**2 + along * sin**2) / sin
    return a, b, c
