# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The smallest dose with which something is rare enough (or frequent enough), and its
interval, from the runs at some doses.

All that is taken for granted is that more of the drug never makes it more frequent: the
estimate is the isotonic regression of what was counted, and the dose where it crosses
the wanted probability. The interval is where Wilson's bands around it cross that: every
dose whose band has the wanted probability in it. So it is the confidence of the bands at
a dose that was run, holds for counts of none and all (of which a bootstrap over seeds
makes intervals of no width), and can be read off the picture. No law of a curve is
fitted: one of logistic form has no place for the runs without a drug, in which the
probability need not be 1.

Between two doses -ln(1 - P) is linear in the part of the receptors that is free, which is
exact for a first bond, whose rate is proportional to it; of a parameter that is no dose,
linear in that.

References
    Barlow, R.E., Bartholomew, D.J., Bremner, J.M. & Brunk, H.D. (1972). Statistical
    Inference under Order Restrictions, Wiley: pool-adjacent-violators.
"""

import collections
import math

import numpy as np

from . import statistics

Smallest = collections.namedtuple("Smallest", "value low high")


def isotonic(happened, trials):
    """Probabilities that never grow, nearest to those counted (likelihood)."""
    blocks = []
    for h, n in zip(happened, trials):
        blocks.append([h, n, 1])
        while len(blocks) > 1 and blocks[-1][0] * blocks[-2][1] > blocks[-2][0] * blocks[-1][1]:
            last = blocks.pop()
            blocks[-1] = [a + b for a, b in zip(blocks[-1], last)]
    return np.array([h / n for h, n, count in blocks for _ in range(count)])


def bands(probabilities, trials, confidence):
    """Wilson's of each; with unlike numbers of trials widened until they fall, too."""
    both = np.array([statistics.proportion(p * n, n, confidence)
                     for p, n in zip(probabilities, trials)])
    low = np.minimum.accumulate(both[:, 0])
    high = np.maximum.accumulate(both[::-1, 1])[::-1]
    return low, high


def crossing(axis, probabilities, wanted):
    """Where a falling curve comes down to it; None: it does not; first: it begins there."""
    rate, aim = ([-math.log1p(-p) if p < 1 else math.inf for p in several]
                 for several in (probabilities, [wanted]))
    aim = aim[0]
    below = [i for i, r in enumerate(rate) if r <= aim]
    if not below:
        return None
    i = below[0]
    if i == 0:
        return axis[0]
    part = 1 if math.isinf(rate[i - 1]) else (rate[i - 1] - aim) / (rate[i - 1] - rate[i])
    return axis[i - 1] + part * (axis[i] - axis[i - 1])


def smallest(axis, happened, trials, wanted, confidence=0.95):
    """On an axis along which it becomes less frequent. Ends are None where the curve does
    not come down to what is wanted, and first (the low one: nothing) where it begins
    there."""
    estimate = isotonic(happened, trials)
    low, high = bands(estimate, trials, confidence)
    # all of n tell no rate; that of half a run without, or between what is wanted and all
    most = np.maximum(1 - 0.5 / np.array(trials), 0.5 + 0.5 * wanted)
    estimate = np.minimum(estimate, most)
    return Smallest(*(crossing(axis, curve, wanted) for curve in (estimate, low, high)))


class Wanted:
    """`smallest` of a dictionary: which parameter, the quantity, its probability."""

    WORDS = ("parameter", "quantity", "below", "above")

    def __init__(self, given, about):
        given.only(*self.WORDS)
        self.name = given.get("parameter", "dose")
        names = [p.name for p in about.parameters]
        if about.sampling != "grid":
            given.refuse(f"'smallest' belongs to a grid, not to {about.sampling}")
        if self.name not in names:
            given.refuse(f"parameter '{self.name}' is not one of {', '.join(names)}")
        self.parameter = about.parameters[names.index(self.name)]
        try:
            self.places = {text: float(text) for text in self.parameter.listed()}
        except ValueError:
            given.refuse(f"the values of {self.name} are not numbers")
        happen = {r.name: r for r in about.results if r.yes_or_no()}
        self.result = happen.get(given.choice("quantity", list(happen)))
        self.side = given.one("below", "above")
        self.probability = given.above(self.side, 0)
        if not self.probability < 1:
            given.refuse(f"'{self.side}' is a probability, below 1")
        self.about = about

    def curves(self, ensemble):
        """(settings but those along the curve, values of the groups by the parameter)."""
        along = [self.name, *(d.name for d in self.about.derived)]
        found = {}
        for group, result, values, _ in ensemble.estimates():
            if result is not self.result or not len(values):
                continue
            rest = {k: v for k, v in group.settings.items() if k not in along}
            found.setdefault(tuple(rest.items()), []).append(
                (self.places[group.settings[self.name]], values))
        return [(dict(rest), sorted(rows, key=lambda row: row[0]))
                for rest, rows in found.items()]

    def find(self, rest, rows):
        """Of a curve. The value is infinite if none of those run is enough, and the low
        end zero if the first may be."""
        places = [place for place, _ in rows]
        trials = [len(values) for _, values in rows]
        happened = [float(sum(values)) for _, values in rows]
        wanted = self.probability
        if self.side == "above":
            wanted = 1 - wanted
            happened = [n - h for h, n in zip(happened, trials)]
        treatment = self.about.treatment
        dose = treatment and self.name == "dose"
        axis = [treatment.free(rest, p) for p in places] if dose else places
        found = smallest(axis, happened, trials, wanted, self.about.confidence)
        back = (lambda x: treatment.dose(rest, x)) if dose else float
        value, low, high = (math.inf if x is None else
                            places[0] if x == axis[0] else back(x) for x in found)
        if low == places[0] and dose:
            low = 0.0           # how much less would do is not known
        return Smallest(value, low, high)
