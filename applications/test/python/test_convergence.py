# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Orders and limits of series whose order and limit are known."""

import math
import os

import numpy as np
import pytest

from fsbi import convergence
from fsbi.case import reference

SIZES = np.array([2, 1.4, 1, 0.75])
ORDERS = pytest.mark.parametrize("p", [0.5, 1, 2, 3, 4])
# bound: errors of h^p are a few roundings; their logarithms, over that of 4/3, too
ROUNDING = 1e-12


@ORDERS
def test_orders_of_a_power_of_the_size(p):
    assert convergence.orders(SIZES, 0.03 * SIZES**p) == pytest.approx(p, abs=ROUNDING)


@ORDERS
def test_overall_order_of_a_power_of_the_size(p):
    assert convergence.overall_order(SIZES, 0.03 * SIZES**p) == pytest.approx(p, abs=ROUNDING)


@ORDERS
def test_order_of_three_values_without_their_limit(p):
    # bound: digits that are lost where the values differ by the limit's 1e-2, and the
    # root finder's 1e-12
    assert convergence.order_of_three(SIZES, 7 - 0.3 * SIZES**p) == pytest.approx(p, abs=1e-10)


@pytest.mark.parametrize("values", [[1, 2, 1.5], [1, 1.5, 2.6], [1, 1, 1.5]])
def test_no_order_of_values_that_turn_or_run_away(values):
    with np.errstate(divide="ignore"):
        assert np.isnan(convergence.order_of_three([1, 0.5, 0.25], np.array(values, float)))


@ORDERS
def test_richardson_of_a_power_of_the_size(p):
    assert convergence.richardson(SIZES, 7 - 0.3 * SIZES**p, p) == pytest.approx(7, abs=ROUNDING)


def test_richardson_of_arrays():
    limit = np.array([[1.0, 2], [3, 4]])
    values = [limit + limit**2 * h**2 for h in SIZES]
    assert convergence.richardson(SIZES, values) == pytest.approx(limit, abs=ROUNDING)


def trapezoidal(n):
    """Integral of exp from 0 to 1: off by (e - 1) (h^2/12 - h^4/720 + ...)"""
    return np.trapz(np.exp(np.linspace(0, 1, n + 1)), dx=1 / n)


def test_trapezoidal_rule():
    n = np.array([4, 8, 12, 16])
    h, values = 1 / n, np.array([trapezoidal(i) for i in n])
    errors = values - (math.e - 1)
    # bound: the next term changes the order by h^2/60 (twice the ratio of the two
    # terms); coarsest pair
    assert convergence.orders(h, errors) == pytest.approx(2, abs=h[0]**2 / 30)
    assert convergence.overall_order(h, errors) == pytest.approx(2, abs=h[0]**2 / 30)
    # bound: the ratio of the differences changes by the part (h0^2 - h2^2)/60, which is
    # a change of the order times the logarithm of how their sizes differ; and a tenth
    # for terms beyond
    shift = (h[1]**2 - h[3]**2) / 60 / np.log((h[1] + h[2]) / (h[2] + h[3]))
    assert convergence.order_of_three(h, values) == pytest.approx(2, abs=1.1 * shift)
    # bound: extrapolated, (e - 1) h^4/720 is left, times the square of the ratio
    left = (math.e - 1) * h[-1]**4 / 720 * (h[-2] / h[-1])**2
    off = convergence.richardson(h, values) - (math.e - 1)
    assert off == pytest.approx(left, rel=h[-2]**2)
    assert convergence.estimate(h, values).uncertainty > abs(off)


def test_limits_of_another_program():
    """Those of validation/S7-helix, extrapolated by its own functions."""
    folder = os.path.join(os.environ["FSBI_DIR"], "validation/S7-helix/reference")
    limits = reference(f"{folder}/helix.csv")[0]
    rows = [r for r in reference(f"{folder}/convergence.csv") if r["pitch"] == limits["pitch"]]
    h = np.array([1 / row["around"] for row in rows])
    for name in ("yy", "a", "b", "c"):
        f = np.array([row[name] for row in rows])
        p = convergence.order_of_three(h, f)
        found = convergence.richardson(h, f, p)
        # bound: it tries orders in steps of 0.001, which leaves half a step's part of
        # what is added to the finest value; three values and the limit have 8 digits,
        # that is, are off by up to 5e-8 of themselves each
        part = 0.0005 * np.log(h[-2] / h[-1]) / (1 - (h[-1] / h[-2])**p)
        assert found == pytest.approx(limits[name], abs=part * abs(found - f[-1])
                                      + 4 * 5e-8 * abs(found))


@pytest.mark.parametrize("p", [1, 2, 3])
def test_estimate_finds_order_and_limit(p):
    found = convergence.estimate(SIZES, 7 - 0.3 * SIZES**p)
    # bound: orders are tried in steps of 0.005; the limit is off by as much of the
    # finest value's distance, 0.3 log(0.75) 0.005
    assert found.order == pytest.approx(p, abs=0.01)
    assert found.limit == pytest.approx(7, abs=1e-3)
    assert found.kind == "asymptotic"


def test_estimate_of_equal_values_is_settled():
    same = convergence.estimate(SIZES, 0 * SIZES + 5)
    assert same.kind == "settled" and same.limit == 5


def test_estimate_of_two_values_has_no_order():
    two = convergence.estimate([2, 1], [1.4, 1.1])
    assert two.kind == "monotone" and np.isnan(two.order)
    assert two.limit == pytest.approx(1, abs=ROUNDING) and two.uncertainty > 0.2


def test_estimate_of_values_that_turn_is_as_uncertain_as_they_are_wide():
    turning = convergence.estimate(SIZES, [1.2, 0.9, 1.05, 1.01])
    assert turning.kind == "scattered" and np.isnan(turning.order)
    assert turning.limit == 1.01 and turning.uncertainty > 0.15


def test_estimate_of_values_that_run_away_is_not_asymptotic():
    apart = convergence.estimate([4, 2, 1], [1, 2, 4])
    assert apart.kind == "monotone" and apart.uncertainty > 2


@pytest.mark.parametrize("sizes", [[1], [1, 1], [2, 1, 2]])
def test_estimate_needs_different_sizes(sizes):
    with pytest.raises(ValueError, match="two or more different sizes"):
        convergence.estimate(sizes, np.arange(len(sizes)))


@pytest.mark.parametrize("noise", [0, 1e-3, 1e-2])
def test_limits_lie_within_the_uncertainty_at_9_of_10(noise):
    random = np.random.default_rng(3)
    hits, trials = 0, 300
    for _ in range(trials):
        p = random.choice([1, 2])
        v = 1 + 0.05 * SIZES**p * (1 + random.uniform(-0.2, 0.2) * SIZES)
        found = convergence.estimate(SIZES, v + noise * random.standard_normal(4))
        hits += abs(found.limit - 1) <= found.uncertainty
    assert hits / trials >= 0.9
