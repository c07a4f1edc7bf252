# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a measured function is lowest while others are above zero, in the unit cube.

A Latin hypercube shows where to begin, and how large the values are; from its best
point COBYLA of scipy goes on: it needs no derivatives, keeps constraints apart from
the function, and fits planes through points that are far from each other at first,
so that a little noise (other meshes, chance) does not lead it astray.

References
    Powell, M.J.D. (1994). A direct search optimization method that models the objective
    and constraint functions by linear interpolation. In: Advances in Optimization and
    Numerical Analysis, Kluwer, 51-67.
"""

import _thread
import queue

import numpy as np
from scipy.optimize import minimize

from fsbi.tune import latin

FIRST_STEP = 0.15       # about the distance of the first points of two parameters
SEED = 1                # of the first points: the same study has the same ones


def first_points(dimensions, points):
    number = min(4 * dimensions + 2, points - dimensions - 2)
    return latin(np.random.default_rng(SEED), dimensions, number)


class Scaled:
    """Values and rooms of what is measured, of the order of one; what failed counts
    as the worst that there was."""

    def __init__(self, rows):
        """rows: (value, *rooms) of the first points, nan if they failed."""
        good = np.array([row for row in rows if np.isfinite(row).all()])
        spread = good.std(axis=0)
        self.scale = np.where(spread > 0, spread, np.maximum(np.abs(good).max(axis=0), 1e-300))
        self.worst = np.array([good[:, 0].max(), *good[:, 1:].min(axis=0)]) / self.scale
        self.worst[1:] = np.minimum(self.worst[1:], -1)

    def __call__(self, row):
        return np.array(row) / self.scale if np.isfinite(row).all() else self.worst


def best(rows):
    """Index of the lowest value among those with all constraints met, else of the one
    that misses them least; None if all failed."""
    rows = np.array(rows, float)
    good = np.isfinite(rows).all(axis=1)
    if not good.any():
        return None
    missed = -np.minimum(rows[:, 1:], 0).sum(axis=1)
    return min(np.flatnonzero(good), key=lambda i: (missed[i], rows[i, 0]))


def descend(measure, start, scaled, points, tolerance):
    """measure(u) gives (value, *rooms); `points` of them at most."""
    asked, answered = queue.SimpleQueue(), queue.SimpleQueue()
    # a thread of its own: signals only reach the main one, and Ctrl-C must not jump out
    # of a function that Fortran has called, which may end the whole program. By _thread:
    # threading's start() holds a lock that Ctrl-C may leave locked, and then waits for
    # the thread at the program's end, for ever
    try:
        _thread.start_new_thread(_cobyla, (asked, answered, start, scaled, points, tolerance))
        while (x := asked.get()) is not None:
            answered.put(scaled(measure(np.clip(x, 0, 1))))
    finally:
        answered.put(None)


def _cobyla(asked, answered, start, scaled, points, tolerance):
    """Asks for values at points, None when there are no more; an answer of None ends it."""
    known, going_on = {}, True

    def at(x):
        nonlocal going_on
        key = x.tobytes()
        if key not in known and going_on:
            asked.put(x.copy())
            answer = answered.get()
            going_on = answer is not None
            known[key] = answer if going_on else scaled.worst
        return known.get(key, scaled.worst)

    dimensions, rooms = len(start), len(scaled.scale) - 1
    constraints = [dict(type="ineq", fun=lambda x, i=i: at(x)[i + 1]) for i in range(rooms)]
    for i in range(dimensions):
        constraints += [dict(type="ineq", fun=lambda x, i=i: x[i]),
                        dict(type="ineq", fun=lambda x, i=i: 1 - x[i])]
    try:
        minimize(lambda x: at(x)[0], start, method="COBYLA", constraints=constraints,
                 options=dict(rhobeg=FIRST_STEP, tol=tolerance, maxiter=points, catol=0))
    finally:
        asked.put(None)
