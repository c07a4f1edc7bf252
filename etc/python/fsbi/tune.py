# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a measured function of a few numbers is lowest, in few measurements.

A surface of multiquadrics through the points measured so far (Gaskin 2018,
3.103-3.107),

    y(x) = mean + sum_i w_i sqrt(1 + |x - x_i|^2/s^2),

s: mean distance of the points, tells where to measure next: where it is
lowest near the best point, now and then far from all points. The
neighbourhood shrinks when a measurement was no improvement. (scipy's
RBFInterpolator adds a polynomial to these equations; it comes as low in as many
measurements.)

No such surface follows a valley with a sharp bottom, as the largest of several
residuals has, to its end: the last part is Nelder and Mead's, with a simplex
along the valley that the best points show.
"""

import numpy as np
from scipy.optimize import minimize
from scipy.spatial.distance import cdist


def latin(random, dimensions, number):
    """One point in every one of `number` slices of every direction."""
    slices = [random.permutation(number) for _ in range(dimensions)]
    return (np.array(slices).T + random.random((number, dimensions))) / number


class Surface:
    def __init__(self, points, values):
        self.points = points
        self.mean = values.mean()
        between = cdist(points, points)
        self.scale = between.sum() / (len(points) * (len(points) - 1))
        matrix = np.sqrt(1 + (between / self.scale) ** 2)
        self.weights = np.linalg.lstsq(matrix, values - self.mean, rcond=1e-12)[0]

    def __call__(self, x):
        distance = cdist(np.atleast_2d(x), self.points) / self.scale
        return self.mean + np.sqrt(1 + distance**2) @ self.weights


class Search:
    """points: in the unit cube; values: inf or nan where nothing came of it."""

    near = 6        # points a number that the surface goes through
    explore = 12    # every so many measurements one far from all others
    simplex = 0.06  # size of the last part's

    def __init__(self, dimensions, solves, seed=1):
        self.random = np.random.default_rng(seed)
        self.dimensions = dimensions
        self.solves = solves
        self.radius = 0.25
        self.waiting = list(latin(self.random, dimensions, 4 * dimensions + 2))
        self.points = []
        self.values = []

    @property
    def best(self):
        return int(np.argmin(self.values))

    def finished(self):
        return len(self.points) >= self.solves

    def valley(self):
        """A simplex at the best point: long where the best ones lie, short across."""
        best = np.array(self.points)[np.argsort(self.values)]
        off = best[: 2 * self.dimensions + 1] - best[0]
        _, axes = np.linalg.eigh(off.T @ off)
        size = self.simplex * np.where(np.arange(self.dimensions) < self.dimensions - 1, 0.2, 1)
        return np.vstack([best[0], best[0] + (axes * size).T])

    def next(self):
        if self.waiting:
            return self.waiting.pop(0)
        if len(self.points) % self.explore == 0:
            anywhere = self.random.random((2000, self.dimensions))
            return anywhere[cdist(anywhere, self.points).min(axis=1).argmax()]
        centre = self.points[self.best]
        points = np.array(self.points)
        order = np.argsort(np.linalg.norm(points - centre, axis=1))
        order = order[: self.near * self.dimensions]
        values = np.array(self.values)[order]
        surface = Surface(points[order], values)
        size = self.radius * self.random.random((4000, 1)) ** 0.5
        around = centre + size * self.random.uniform(-1, 1, (4000, self.dimensions))
        around = np.clip(around, 0, 1)
        new = cdist(around, points).min(axis=1) > 0.2 * self.radius
        around = around[new] if new.any() else around
        return around[surface(around).argmin()]

    def add(self, point, value):
        """value: the lower the better; failures count like the worst so far."""
        known = [v for v in self.values if np.isfinite(v)]
        value = value if np.isfinite(value) else max(known, default=0.0)
        local = len(self.points) >= 4 * self.dimensions + 2
        better = not self.values or value < min(self.values)
        explored = len(self.points) % self.explore == 0
        self.points.append(np.asarray(point, float))
        self.values.append(float(value))
        if local and not explored:
            self.radius *= 1.6 if better else 0.8
            self.radius = min(self.radius, 0.25)


def lowest(measure, dimensions, solves, seed=1):
    """Points measured, values, index of the best one; `solves` at most."""
    search = Search(dimensions, min(solves, 12 * dimensions), seed)
    while not search.finished():
        point = search.next()
        search.add(point, measure(point))

    def further(point):
        point = np.clip(point, 0, 1)
        search.add(point, measure(point))
        return search.values[-1]

    if len(search.points) < solves:
        minimize(further, search.points[search.best], method="Nelder-Mead", options=dict(
            maxfev=solves - len(search.points), initial_simplex=search.valley(),
            xatol=1e-4, fatol=0))
    return search.points, search.values, search.best
