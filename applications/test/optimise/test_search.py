# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Optima that are known, in few measurements."""

import signal
import sys
import time

import numpy as np
import pytest

from fsbi.optimise import search


def found(function, dimensions, points, tolerance):
    """Where, and the rows (value, *rooms) of all points."""
    asked, rows = [], []

    def measure(u):
        asked.append(np.array(u))
        rows.append(function(u))
        return rows[-1]

    first = search.first_points(dimensions, points)
    for u in first:
        measure(u)
    start = search.best(rows)
    search.descend(measure, first[start], search.Scaled(rows), points - len(first), tolerance)
    assert len(rows) <= points
    assert all(((u >= 0) & (u <= 1)).all() for u in asked)
    return asked[search.best(rows)], rows


def test_minimum_inside():
    at, rows = found(lambda u: [(u[0] - 0.3) ** 2 + 2 * (u[1] - 0.7) ** 2 - 0.5 * u[0] * u[1]],
                     2, 60, 0.002)
    exact = np.linalg.solve([[2, -0.5], [-0.5, 4]], [0.6, 2.8])
    # bound: what planes of the last radius leave, ten of them
    assert np.abs(at - exact).max() < 0.02


def test_minimum_at_a_constraint_is_met_and_near():
    """Along the gradient (2 (x - 0.3), 4 (y - 0.7)) = -l (1, 1): l = 2/15."""
    at, _ = found(lambda u: [(u[0] - 0.3) ** 2 + 2 * (u[1] - 0.7) ** 2, 0.8 - u[0] - u[1]],
                  2, 60, 0.002)
    assert at.sum() <= 0.8
    # bound: ten of the last radius
    assert np.abs(at - [0.3 - 2 / 15, 0.7 - 1 / 15]).max() < 0.02


def test_minimum_in_a_corner_of_three():
    at, _ = found(lambda u: [u[0] - u[1] + 0.1 * u[2]], 3, 60, 0.002)
    assert np.abs(at - [0, 1, 0]).max() < 0.01      # bound: five of the last radius


def test_what_fails_is_left():
    at, rows = found(lambda u: [np.nan if u[0] > 0.5 else (u[0] - 0.45) ** 2 + u[1] ** 2],
                     2, 60, 0.002)
    assert np.abs(at - [0.45, 0]).max() < 0.02      # bound: ten of the last radius


def test_scale_of_values_does_not_matter():
    def hill(scale):
        return lambda u: [scale * ((u[0] - 0.6) ** 2 + u[0]), scale * (u[0] - 0.25)]
    small, large = (found(hill(s), 1, 30, 0.002)[0] for s in (1e-9, 1e9))
    assert small == pytest.approx(large, abs=1e-6)
    assert small == pytest.approx(0.25, abs=0.01)   # bound: five of the last radius


def test_best_meets_constraints_first():
    assert search.best([[1, -1], [5, 0.1], [3, 0.2], [np.nan, np.nan]]) == 2
    assert search.best([[1, -1], [2, -0.5]]) == 1
    assert search.best([[np.nan]]) is None


def test_ctrl_c_at_any_moment_is_an_exception_and_nothing_else(capfd):
    def interrupt(*_):
        raise KeyboardInterrupt

    scaled = search.Scaled([(1, 1), (2, -1)])
    random = np.random.default_rng(1)
    # most while a search begins, when a lock of its thread could stay locked
    moments = [*random.uniform(1e-5, 3e-4, 2000), *random.uniform(1e-4, 4e-3, 100)]
    threads = len(sys._current_frames())
    before, ended = signal.signal(signal.SIGALRM, interrupt), 0
    try:
        for moment in moments:
            try:
                signal.setitimer(signal.ITIMER_REAL, moment)
                search.descend(lambda u: (((u - 0.3) ** 2).sum(), 0.8 - u.sum()),
                               np.array([0.5, 0.5, 0.1]), scaled, 200, 1e-7)
                time.sleep(0.1)         # it was done before
            except KeyboardInterrupt:
                ended += 1
    finally:
        signal.signal(signal.SIGALRM, before)
    assert ended == len(moments)
    time.sleep(0.1)
    assert len(sys._current_frames()) == threads    # no search waits for an answer
    # Fortran would tell of a call that did not come back, if it came back itself
    assert capfd.readouterr() == ("", "")
