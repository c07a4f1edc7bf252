# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals and sensitivities against published, asymptotic and exact ones.

Newcombe, R.G. (1998). Two-sided confidence intervals for the single proportion:
comparison of seven methods. Stat. Med. 17, 857-872, table I, method 3.
Ishigami, T. & Homma, T. (1990): sin(x) + 7 sin2(y) + 0.1 z4 sin(x), -pi to pi.
"""

import math

import numpy as np
import pytest

from fsbi.ensemble import sampling, statistics


@pytest.mark.parametrize("happened, trials, low, high", [
    (81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611),
    (1, 29, 0.0061, 0.1718)])
def test_wilsons_interval_is_the_published_one(happened, trials, low, high):
    # bound: half of the last digit printed
    assert statistics.proportion(happened, trials) == pytest.approx((low, high), abs=5e-5)


def test_ten_of_ten_have_an_interval_of_n_over_n_plus_z2_to_one():
    z = 2.5758293035489004              # of 99 %
    assert statistics.proportion(10, 10, 0.99) == pytest.approx((10 / (10 + z * z), 1), rel=1e-12)


@pytest.mark.parametrize("trials", [3, 20, 77])
def test_none_and_all_have_an_end_at_zero_and_one(trials):
    assert statistics.proportion(0, trials)[0] == 0
    assert statistics.proportion(trials, trials)[1] == 1


@pytest.mark.parametrize("confidence, z", [(0.95, 1.959964), (0.8, 1.281552)])
def test_bootstrap_of_large_samples_has_the_normal_interval(confidence, z):
    # bound: an end is off by sqrt(p (1 - p)/2000)/pdf(z), p its tail, at random: 0.060 and
    # 0.038 standard errors; half of the width by 0.7 of it, of 20 samples by a 4.5th of
    # that; four times this, and 1/(2 n) for the n where n - 1 is the normal one's
    random, n, widths = np.random.default_rng(7), 400, []
    for _ in range(20):
        values = random.normal(3, 2, n)
        low, high = statistics.mean(values, confidence)
        widths.append((high - low) / 2 / (values.std(ddof=1) / math.sqrt(n)))
    assert np.mean(widths) == pytest.approx(z, abs=0.045)


def test_it_leans_to_the_tail_of_a_skew_sample():
    # of exponential values the upper end is farther from the mean, by z (2a) to first
    # order, a = skewness/(6 sqrt(n)) = 1/(3 sqrt(30)), z 2 a/(1 - z a) = 0.27 (Efron 1987)
    values = -np.log1p(-(np.arange(30) + 0.5) / 30)
    low, high = statistics.mean(values)
    assert high - values.mean() > 1.1 * (values.mean() - low)


def test_same_values_have_the_same_interval():
    values = np.random.default_rng(3).random(12)
    assert statistics.mean(values) == statistics.mean(values.copy())


@pytest.mark.parametrize("values, wanted", [
    ([2.5] * 9, (2.5, 2.5)), ([1, 2], (math.nan, math.nan))])
def test_interval_of_equal_and_of_few_values(values, wanted):
    assert statistics.mean(values) == pytest.approx(wanted, nan_ok=True)


# Sensitivities

SAMPLES = 1024


def ishigami(x):
    return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


def exact():
    """Variance, first-order and total indices."""
    one = 0.5 * (1 + 0.1 * math.pi**4 / 5) ** 2
    two = 49 / 8
    both = 0.01 * math.pi**8 * 8 / 225
    total = one + two + both
    return total, np.array([one, two, 0]) / total, np.array([one + both, two, both]) / total


def blocks(points):
    f = ishigami(math.pi * (2 * points - 1))
    return f.reshape(-1, 5)


@pytest.fixture(scope="module")
def scatter():
    """Standard deviations of both estimates from independent samples, by many."""
    points = np.random.default_rng(11).random((2, 100000, 3))
    f = blocks(sampling.saltelli(*points))
    a, b, ab = f[:, :1], f[:, 1:2], f[:, 2:]
    return np.array([((b - f[:, :2].mean()) * (ab - a)).std(axis=0),
                     (0.5 * (ab - a) ** 2).std(axis=0)]) / exact()[0] / math.sqrt(SAMPLES)


@pytest.fixture(scope="module")
def found():
    return blocks(sampling.points("Sobol", 3, SAMPLES))


@pytest.mark.parametrize("which", [0, 1], ids=["first-order", "total"])
def test_indices_of_ishigamis_function_are_the_exact_ones(found, scatter, which):
    # bound: four standard deviations of independent samples; Sobol's scatter less
    errors = statistics.sensitivities(found)[which] - exact()[1 + which]
    assert (np.abs(errors) < 4 * scatter[which]).all()
    # and these can tell the indices from each other: at most 0.22
    assert 4 * scatter[which].max() < 0.22


def test_their_intervals_are_as_wide_as_the_scatter(found, scatter):
    # bound: the variance it is divided by scatters, too, by 1.5/sqrt(2048) of itself, 0.03;
    # bootstrap of heavy tails; so half to twice
    found = statistics.indices(found)
    half = np.array([found.firstHigh - found.firstLow, found.totalHigh - found.totalLow]) / 2
    ratio = half / (1.96 * scatter)
    assert (ratio > 0.5).all() and (ratio < 2).all()


def test_nothing_varies_nothing_is_sensitive():
    assert np.isnan(statistics.indices(np.ones((8, 5))).total).all()
