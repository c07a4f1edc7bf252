# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs for a mean over chance: which meshes, how many seeds of each.

P_l is a run's number on level l, from coarse to fine; the same seed on all levels. The
mean on the finest level of a mix is taken from a coarse one, corrected:

    E[P_L] = E[P_0] + sum of E[P_l - P_(l-1)]

The mean square error is bias^2 + sum of V_l/N_l, V_l being the variance of the l-th
part, C_l its seconds (both runs of a difference). What is wanted, e, costs least with

    N_l = sqrt(V_l/C_l) sum_k sqrt(V_k C_k) / (e^2 - bias^2)

A single level is a mix of one part. With paths that do not correlate, the variance of a
difference is the sum of both, and one level is cheapest.

References
    Giles, M.B. (2008). Multilevel Monte Carlo path simulation. Oper. Res. 56, 607-617.
    Fisher, R.A. (1921). Metron 1, 3-32: the interval of a correlation.
"""

import collections
import itertools

import numpy as np

FORMAL = 2.0                # order, where runs do not tell
ORDERS = (0.5, 4.5)         # an observed one outside of these is scatter
SURE = 1.96                 # standard errors

# levels: numbers of them, seeds: of each part, cost: seconds of all
Mix = collections.namedtuple("Mix", "levels seeds cost bias error")


class Levels:
    """What a pilot says. values: (levels, seeds), seconds of a run on each level, sizes
    (smaller is finer); reference: the exact mean, if known."""

    def __init__(self, values, seconds, sizes, reference=None, order=None):
        values = np.asarray(values, float)
        self.count, self.seeds = values.shape
        self.seconds, self.sizes = np.asarray(seconds, float), np.asarray(sizes, float)
        self.means = values.mean(axis=1)
        self.covariance = np.atleast_2d(np.cov(values))
        self.reference, self.order, self.given = reference, order or FORMAL, order
        self._find_bias()

    # Moments

    def variance(self, level, below=None):
        """Of a run on a level, or of its difference from one on a level below."""
        c = self.covariance
        if below is None:
            return c[level, level]
        return max(c[level, level] + c[below, below] - 2 * c[level, below], 0.0)

    def correlation(self, level, below):
        both = self.covariance[level, level] * self.covariance[below, below]
        return self.covariance[level, below] / np.sqrt(both) if both > 0 else np.nan

    def correlated(self, level, below):
        """More than chance gives: Fisher's lower bound is above zero."""
        r = min(self.correlation(level, below), 1 - 1e-12)
        return self.seeds > 3 and np.arctanh(r) > SURE / np.sqrt(self.seeds - 3)

    def deviation(self, level, below=None):
        """Standard error of the pilot's mean of it."""
        return np.sqrt(self.variance(level, below) / self.seeds)

    # Bias

    def _find_bias(self):
        """Limit minus mean of every level, and the standard error of that."""
        if self.reference is not None:
            self.bias = self.reference - self.means
            self.unsure = np.array([self.deviation(i) for i in range(self.count)])
            return
        last = self.count - 1
        if not self.given:
            self.order = self._observed() or FORMAL
        beyond = 1 / ((self.sizes[-2] / self.sizes[-1]) ** self.order - 1)
        step = self.means[-1] - self.means[-2]
        self.bias = self.means[-1] - self.means + beyond * step
        # of the same seeds: by the covariance of what is added up
        weights = np.zeros((self.count, self.count))
        for i in range(self.count):
            weights[i, last] += 1 + beyond
            weights[i, last - 1] -= beyond
            weights[i, i] -= 1
        variance = np.einsum("ij,jk,ik->i", weights, self.covariance, weights)
        self.unsure = np.sqrt(np.maximum(variance, 0) / self.seeds)

    def counted(self, level):
        """The bias that a choice counts with: none where chance leaves it unseen."""
        seen = abs(self.bias[level]) > SURE * self.unsure[level]
        return self.bias[level] if seen else 0.0

    def _observed(self):
        """The order by the last three means, if chance leaves that to be seen."""
        if self.count < 3:
            return None
        steps = np.diff(self.means)[-2:]
        errors = [self.deviation(i, i - 1) for i in (self.count - 2, self.count - 1)]
        if (np.abs(steps) < SURE * np.array(errors)).any() or steps[0] * steps[1] <= 0:
            return None
        return _order(self.sizes[-3:], steps[0] / steps[1])

    # Mixes

    def mix(self, levels, wanted):
        """Seeds of every part for a root mean square error; None: the bias is more."""
        bias = self.counted(levels[-1])
        left = wanted**2 - bias**2
        if left <= 0:
            return None
        below = [None, *levels[:-1]]
        variance = np.array([self.variance(i, k) for i, k in zip(levels, below)])
        cost = np.array([self.seconds[i] + (0 if k is None else self.seconds[k])
                         for i, k in zip(levels, below)])
        ideal = np.sqrt(variance / cost) * np.sqrt(variance * cost).sum() / left
        seeds = np.maximum(np.ceil(ideal * (1 - 1e-12)), 1)
        error = np.sqrt(bias**2 + (variance / seeds).sum())
        return Mix(tuple(levels), seeds.astype(int), float(seeds @ cost), bias, error)

    def mixes(self, wanted):
        """All that reach it: cheapest first; several levels only where all of their
        neighbours correlate."""
        found = []
        for number in range(1, self.count + 1):
            for levels in itertools.combinations(range(self.count), number):
                if all(self.correlated(b, a) for a, b in zip(levels, levels[1:])):
                    found.append(self.mix(levels, wanted))
        return sorted((m for m in found if m), key=lambda m: (m.cost, len(m.levels)))

    def single(self, wanted):
        """The cheapest of one level; None: no bias is small enough."""
        return next((m for m in self.mixes(wanted) if len(m.levels) == 1), None)

    def least(self):
        """The smallest error in reach, that of endless seeds."""
        return min(abs(self.counted(i)) for i in range(self.count))


def _order(sizes, ratio):
    """p with (h0^p - h1^p)/(h1^p - h2^p) = ratio; None outside of ORDERS."""
    def excess(p):
        a, b, c = sizes**p
        return (a - b) / (b - c) - ratio

    low, high = ORDERS
    if excess(low) > 0 or excess(high) < 0:
        return None
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)
    return 0.5 * (low + high)
