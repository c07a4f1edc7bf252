# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Aggregates, pauses and proportions of motions that are known."""

import numpy as np
import pytest

from fsbi import adhesion

# steps of all lengths: free until 3000, then held
TIME = np.concatenate((np.linspace(0, 3000, 31), np.linspace(3001, 9000, 2000)))
SPEED = np.where(TIME <= 3000, 1.0, 0.0)


@pytest.fixture
def samples():
    """Times at equal intervals, and the mean speed until then."""
    at, even = adhesion.uniform(TIME, SPEED, 30)
    return at, adhesion.moving_mean(even, 75)


def test_samples_are_at_equal_intervals(samples):
    assert np.allclose(np.diff(samples[0]), 30) and samples[0][-1] == 9000


def test_aggregate_is_found_when_the_mean_has_forgotten_the_free_motion(samples):
    # bound: 75 samples, of which fewer than 3.75 (and one on the edge) are still free
    assert adhesion.aggregate_time(*samples, 0.05) == pytest.approx(3000 + 72 * 30, abs=30)


def test_no_aggregate_if_it_comes_loose_at_the_end(samples):
    at, mean = samples
    assert np.isnan(adhesion.aggregate_time(at, mean + (at > 8900), 0.05))


def test_no_aggregate_if_the_speed_is_not_known(samples):
    at, mean = samples
    assert np.isnan(adhesion.aggregate_time(at, mean * np.nan, 0.05))


def test_moving_mean_is_that_of_the_last_samples():
    assert np.allclose(adhesion.moving_mean([1.0, 2, 3, 4], 2), [1, 1.5, 2.5, 3.5])


@pytest.fixture
def stop_and_go():
    """Moves for 300 at the speed 2, stands for 100, and so on, ten times."""
    time = np.linspace(0, 4000, 4001)
    x = 600 * (time // 400) + 2 * np.minimum(time % 400, 300)
    return adhesion.rolling(time, x, free=2, window=20)


def test_mean_velocity_of_a_stop_and_go(stop_and_go):
    assert stop_and_go.mean == pytest.approx(1.5, abs=1e-9)


def test_pauses_of_a_stop_and_go(stop_and_go):
    # bound: a pause loses the window of 20 and what is left of it when the speed,
    # averaged over that, counts as one; the last one is cut off by the end
    assert stop_and_go.pause_fraction == pytest.approx(0.25, abs=0.05)
    assert len(stop_and_go.pauses) == 10
    assert all(75 <= b - a <= 105 for a, b in stop_and_go.pauses[:-1])


def test_no_pause_in_a_steady_motion():
    time = np.linspace(0, 4000, 4001)
    assert adhesion.rolling(time, 2 * time, 2, 20).pauses == []


# Newcombe (1998), Stat. Med. 17, 857, table I
@pytest.mark.parametrize("happened, trials, low, high", [
    (81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0000, 0.1611)])
def test_wilsons_interval(happened, trials, low, high):
    # bound: digits of the table
    assert adhesion.wilson(happened, trials) == pytest.approx((low, high), abs=6e-5)
