# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds and megabytes of a run to come, from those that are done.

Three power laws, log y = a + sum of b_k log(size_k), one each for the seconds of
stepping, those of meshing and the memory; a value that is no number has a factor
of its own. Exponents start from what is usual, with a width, and are corrected
by the runs (Bayesian linear regression); runs count the more the nearer they are
to what is predicted, since no law holds over a wide range.
"""

import numpy as np

# exponent and its width, of stepping, meshing, memory
USUAL = {
    "mesh": ((-3.3, 0.5), (-3.0, 0.5), (-1.0, 1.0)),
    "timeStep": ((-0.85, 0.2), (0.0, 0.2), (0.0, 0.05)),
    "tolerance": ((-0.08, 0.04), (0.0, 0.02), (0.0, 0.01)),
}
NUMBER = ((0.0, 1.5), (0.0, 1.0), (0.0, 0.7))
WORD = ((0.0, 1.2), (0.0, 0.3), (0.0, 0.3))
NOISE, PER_DISTANCE = 0.08, 0.15
FLAT = {"tolerance": 0.15}      # how near runs are along a parameter of little effect
START = 0.5             # seconds of any run that no parameter changes
UNSURE = 0.6            # of the logarithm: more is a guess


class Predictor:
    def __init__(self, parameters):
        self.parameters = parameters
        self.features = []              # (parameter, value or None)
        self.priors = []
        for k in parameters:
            if k.numeric():
                self.features.append((k, None))
                self.priors.append(USUAL.get(k.name, NUMBER))
            else:
                others = [v for v in k.values if v != k.values[k.base]]
                self.features += [(k, v) for v in others]
                self.priors += [WORD] * len(others)
        self.done = []

    def point(self, settings):
        """Features of settings, {parameter name: value}."""
        row = []
        for k, value in self.features:
            now = settings.get(k.name, k.values[k.base])
            row.append(np.log(k.size(now)) if value is None else float(now == value))
        return np.array(row)

    def add(self, settings, stepping, meshing, megabytes):
        stepping = max(stepping - START, 0.1 * stepping)
        logs = [np.log(max(y, 1e-3)) for y in (stepping, meshing, megabytes)]
        self.done.append((self.point(settings), logs))

    def law(self, which, near):
        """Mean and covariance of (a, b), by the runs near a point."""
        prior = [(0.0, 20.0), *(p[which] for p in self.priors)]
        mean = np.array([m for m, _ in prior])
        precision = np.diag([1 / s**2 for _, s in prior])
        right = precision @ mean
        flat = np.array([FLAT.get(k.name, 1.0) for k, _ in self.features])
        for x, logs in self.done:
            row = np.concatenate(([1], x))
            noise = NOISE + PER_DISTANCE * np.linalg.norm((x - near) * flat)
            precision = precision + np.outer(row, row) / noise**2
            right = right + row * logs[which] / noise**2
        covariance = np.linalg.inv(precision)
        return covariance @ right, covariance

    def predict(self, settings):
        """Seconds, megabytes, and the width of the logarithm of the seconds;
        None before the first run."""
        if not self.done:
            return None
        x = self.point(settings)
        row = np.concatenate(([1], x))
        values, widths = [], []
        for which in range(3):
            mean, covariance = self.law(which, x)
            values.append(np.exp(row @ mean))
            widths.append(np.sqrt(row @ covariance @ row))
        seconds = START + values[0] + values[1]
        width = (values[0] * widths[0] + values[1] * widths[1]) / seconds
        return seconds, values[2], width
