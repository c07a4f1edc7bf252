# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paths of bodies under the controller's own law, without a fluid between them: to
find way points.

    ways, time = plan(starts, points, frequencies, advances, stepOuts)
    plan([(-15, 0), (18, -21)], [[(9, 18), (15, 0)], [(38, 32)]], ...)
"""

import numpy as np

PIECES = 5              # of a period, in the path


def speeds(frequencies, advances, stepOuts):
    """Body by frequency."""
    f, s = np.asarray(frequencies)[None], np.asarray(stepOuts)[:, None]
    slipping = f - np.sqrt(np.maximum(f**2 - s**2, 0))
    return np.asarray(advances)[:, None] * np.where(f > s, slipping, f)


def chosen(times, frequencies, last, worthwhile=0.3):
    turns = np.linalg.norm(times, axis=1) * frequencies
    return last if last >= 0 and turns[last] > worthwhile else int(np.argmax(turns))


def plan(starts, points, frequencies, advances, stepOuts, period=2.5e5, tolerance=0.5,
         longest=1e8):
    """Paths (time, body, x y) and the time when all are there, nan: never."""
    V = speeds(frequencies, advances, stepOuts)
    x, ways, leg, mode, time = np.array(starts, float), [], 0, -1, 0
    while time < longest:
        ways.append(x.copy())
        left = np.array([p[min(leg, len(p) - 1)] for p in points]) - x
        if np.linalg.norm(left, axis=1).max() <= tolerance:
            leg += 1
            if leg == max(map(len, points)):
                return np.array(ways), time
            continue
        times = np.linalg.pinv(V) @ left
        mode = chosen(times, frequencies, mode)
        lasts = np.linalg.norm(times[mode])
        step = times[mode] / lasts * min(lasts, period) / PIECES
        for _ in range(PIECES):
            x = x + V[:, mode, None] * step
            ways.append(x.copy())
        time += period
    return np.array(ways), np.nan
