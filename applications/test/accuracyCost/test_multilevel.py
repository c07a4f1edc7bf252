# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels and seeds for a mean over chance, against an Ornstein-Uhlenbeck process by Euler
steps, dX = -X dt + s dW to T = 1, whose means, variances and covariances of two levels
that share W are sums known exactly; and against a minimiser."""

import numpy as np
import pytest
from fsbi.accuracy_cost.multilevel import Levels
from scipy.optimize import minimize

START, S = 1.0, 0.5
STEPS = np.array([4, 8, 16, 32])        # of the levels; a run's cost is their number
EXACT = START * np.exp(-1)


def weights(steps, finest):
    """What each of the finest increments of W counts in X(T)."""
    h, part = 1 / steps, finest // steps
    return S * np.repeat((1 - h) ** np.arange(steps - 1, -1, -1), part)


FINEST = STEPS[-1]
W = np.array([weights(n, FINEST) for n in STEPS])
MEANS = START * (1 - 1 / STEPS) ** STEPS
COVARIANCE = W @ W.T / FINEST


def paths(seeds, random, together=True):
    """X(T) of all levels, of the same increments or each of its own."""
    shape = (FINEST, seeds) if together else (len(STEPS), FINEST, seeds)
    noise = random.standard_normal(shape) / np.sqrt(FINEST)
    found = W @ noise if together else np.einsum("lk,lks->ls", W, noise)
    return found + MEANS[:, None]


def exact_levels():
    """With the moments that a pilot would only estimate."""
    levels = Levels(paths(8, np.random.default_rng(1)), STEPS, 1 / STEPS, EXACT)
    levels.means, levels.covariance = MEANS, COVARIANCE
    levels.bias, levels.unsure, levels.seeds = EXACT - MEANS, np.zeros(len(STEPS)), 1000
    return levels


def pilot(seeds, together=True, seed=1, reference=None):
    values = paths(seeds, np.random.default_rng(seed), together)
    return Levels(values, STEPS.astype(float), 1 / STEPS, reference)


def test_moments():
    """bound: 4 standard errors of a variance of 4000 seeds, sqrt(2/4000) of it."""
    levels = pilot(4000)
    for i in range(len(STEPS)):
        assert levels.variance(i) == pytest.approx(COVARIANCE[i, i], rel=0.09)
    for i in range(1, len(STEPS)):
        c = COVARIANCE[i - 1:i + 1, i - 1:i + 1]
        assert levels.variance(i, i - 1) == pytest.approx(np.array([1, -1]) @ c @ [1, -1], rel=0.09)
        assert levels.correlation(i, i - 1) == pytest.approx(
            c[0, 1] / np.sqrt(c[0, 0] * c[1, 1]), rel=0.01)


def test_bias():
    """bound: 4 of its own standard errors, and these below a third of the bias of the
    coarsest; Euler's order is 1, and its next term here is a tenth on 8 to 32 steps."""
    levels = pilot(20000)
    assert levels.order == pytest.approx(1, abs=0.3)
    assert (np.abs(levels.bias - (EXACT - MEANS)) < 4 * levels.unsure
            + 0.1 * np.abs(EXACT - MEANS)).all()
    assert levels.unsure[0] < abs(EXACT - MEANS[0]) / 3


def test_standard_errors():
    """bound: of 400 pilots' biases the scatter is known to 1/sqrt(800); 4 of that."""
    found = [Levels(paths(50, np.random.default_rng(i)), STEPS, 1 / STEPS, order=1)
             for i in range(400)]
    scatter = np.std([f.bias for f in found], axis=0)
    told = np.sqrt(np.mean([f.unsure**2 for f in found], axis=0))
    assert told == pytest.approx(scatter, rel=0.15)


@pytest.mark.parametrize("chosen", [(3,), (0, 3), (0, 1, 2, 3), (1, 2)])
def test_seeds_are_those_of_a_minimiser(chosen):
    """bound: 1e-4 of the cost, for counts that need not be whole: of rounding up at most
    one run a part more."""
    levels = exact_levels()
    bias = abs(levels.bias[chosen[-1]])
    wanted = 1.05 * bias
    below = [None, *chosen[:-1]]
    variance = []
    for i, k in zip(chosen, below):
        w = W[i] - (0 if k is None else W[k])
        variance.append(w @ w / FINEST)
    cost = np.array([STEPS[i] + (0 if k is None else STEPS[k]) for i, k in zip(chosen, below)])
    variance, left = np.array(variance), wanted**2 - bias**2
    # of logarithms of counts, scaled so that numbers are about one
    guess = np.log(len(chosen) * variance / left)
    unit = np.exp(guess) @ cost
    best = minimize(lambda x: np.exp(x) @ cost / unit, guess, method="SLSQP", options=dict(
        ftol=1e-14, maxiter=500), constraints=dict(
            type="ineq", fun=lambda x: 1 - (variance / np.exp(x)).sum() / left))
    assert best.success
    mix = levels.mix(chosen, wanted)
    least = best.fun * unit
    assert least * (1 - 1e-4) <= mix.cost <= least * (1 + 1e-4) + cost.sum()
    assert mix.error <= wanted


def test_cheapest_of_all_mixes():
    """By the closed form of every subset, 15 of them, written down here anew."""
    levels = exact_levels()
    wanted = 1.2 * abs(levels.bias[-1])
    costs = {}
    for bits in range(1, 2 ** len(STEPS)):
        chosen = [i for i in range(len(STEPS)) if bits >> i & 1]
        left = wanted**2 - (EXACT - MEANS[chosen[-1]]) ** 2
        if left <= 0:
            continue
        total, last = 0.0, np.zeros(FINEST)
        for j, i in enumerate(chosen):
            w, last = W[i] - last, W[i]
            total += np.sqrt(w @ w / FINEST * (STEPS[i] + (STEPS[chosen[j - 1]] if j else 0)))
        costs[tuple(chosen)] = total**2 / left
    best = levels.mixes(wanted)[0]
    assert best.levels == min(costs, key=costs.get)
    assert len(best.levels) > 1
    # bound: rounded up by a run of every part at most
    assert costs[best.levels] <= best.cost <= costs[best.levels] + 2 * STEPS.sum()
    assert levels.single(wanted).cost > 2 * best.cost


def test_what_is_recommended_has_the_error():
    """bound: the root mean square of 400 repetitions is known to 1/sqrt(800); 4 of that."""
    levels = exact_levels()
    wanted = 1.2 * abs(levels.bias[-1])
    mix = levels.mixes(wanted)[0]
    random = np.random.default_rng(5)
    errors = []
    for _ in range(400):
        found, below = 0.0, None
        for i, n in zip(mix.levels, mix.seeds):
            x = paths(n, random)
            found += np.mean(x[i] - (x[below] if below is not None else 0))
            below = i
        errors.append(found - EXACT)
    assert np.sqrt(np.mean(np.square(errors))) == pytest.approx(mix.error, rel=0.15)
    assert mix.error <= wanted


def test_paths_that_do_not_correlate_want_one_level():
    """Of 40 pilots with 8 seeds whose levels have nothing in common; bound: Fisher's
    one-sided 2.5 % of three neighbours and three others, 6 of 40 at most by chance twice
    over; and then they must not be the cheapest."""
    several = 0
    for seed in range(40):
        levels = pilot(8, together=False, seed=seed, reference=EXACT)
        levels.bias, levels.unsure = EXACT - MEANS, np.zeros(len(STEPS))
        best = levels.mixes(1.2 * abs(levels.bias[-1]))[0]
        several += len(best.levels) > 1
    assert several <= 6


def test_chance_is_rarely_taken_for_a_correlation():
    """Of 400 pilots with 8 seeds that have nothing in common. bound: Fisher's 2.5 % are 10
    of them, with 4 of their own deviations, 3.1, and as many for his approximation: 25."""
    found = [pilot(8, together=False, seed=s).correlated(1, 0) for s in range(400)]
    assert 0 < sum(found) <= 25


def test_paths_that_correlate_want_several():
    levels = pilot(8, reference=EXACT)
    levels.bias, levels.unsure = EXACT - MEANS, np.zeros(len(STEPS))
    assert len(levels.mixes(1.2 * abs(levels.bias[-1]))[0].levels) > 1


def test_out_of_reach():
    levels = exact_levels()
    assert not levels.mixes(0.9 * abs(levels.bias[-1]))
    assert levels.least() == pytest.approx(abs(EXACT - MEANS[-1]))


def test_a_bias_that_chance_hides_counts_as_none():
    levels = pilot(8, together=False)
    assert (np.abs(levels.bias) < 1.96 * levels.unsure).all()
    best = levels.mixes(0.05)[0]
    assert best.levels == (0,) and best.bias == 0
