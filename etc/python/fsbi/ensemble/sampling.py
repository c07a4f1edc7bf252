# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What varies, and which values go together.

grid             all combinations of the values
list             the values side by side
random           drawn one by one
latinHypercube   one in every one of `samples` equal parts of every distribution
Sobol            the two matrices A and B of Saltelli (2010) from a scrambled Sobol
                 sequence, and A with one column after the other from B

The last three draw numbers of a fixed seed: the same dictionary is the same plan.

References
    Saltelli, A., Annoni, P., Azzini, I., Campolongo, F., Ratto, M. & Tarantola, S.
    (2010). Variance based sensitivity analysis of model output. Comput. Phys. Commun.
    181, 259-270.
"""

import itertools

import numpy as np
from scipy import stats

from fsbi.studies.dictionary import shown

DRAWN = ("random", "latinHypercube", "Sobol")
SAMPLINGS = ("grid", "list", *DRAWN)
WORDS = ("entry", "form", "values", "range", "number", "spacing", "normal", "logNormal")
SEED = 1            # of the plan


class Varied:
    """A parameter: entries of the case that get the same value. As a parameter of
    fsbi.studies.runs its value is a text, or None: the case's own."""

    values, base = (None,), 0

    def __init__(self, name, entries, form="{}"):
        self.name, self.entries, self.form = name, entries, form

    def key(self, value):
        return [[file, entry, self.form.replace("{}", value)] for file, entry in self.entries]

    def apply(self, entries, value):
        for row in self.key(value) if value is not None else ():
            entries.set(*row)


class Parameter(Varied):
    """One that the dictionary describes."""

    def __init__(self, name, given, sampling):
        given.only(*WORDS)
        super().__init__(name, pairs(given, "entry"), shown(given.get("form", "{}")))
        if "{}" not in self.form:
            given.refuse(f"form '{self.form}' has no {{}} where the value is to stand")
        self.given = given
        self.kind = given.one("values", "range", "normal", "logNormal")
        if self.kind in ("normal", "logNormal") and sampling not in DRAWN:
            given.refuse(f"{self.kind} belongs to {', '.join(DRAWN)}, not to a {sampling}")
        for word in ("number", "spacing"):
            if word in given and self.kind != "range":
                given.refuse(f"'{word}' belongs to a range")
        if "number" in given and sampling in DRAWN:
            given.refuse(f"'number' belongs to a grid or list, not to {sampling}")
        self.logarithmic = given.choice("spacing", ("linear", "logarithmic"), "linear") \
            == "logarithmic"
        self._read()

    def _read(self):
        if self.kind == "values":
            self.texts = [shown(v) for v in self.given.list("values")]
            return
        self.pair = low, high = self.given.pair(self.kind)
        if self.kind == "range" and not low < high:
            self.given.refuse("a range is (LOW HIGH), LOW below HIGH")
        if self.logarithmic and not low > 0:
            self.given.refuse("a logarithmic range is above zero")
        if self.kind == "logNormal" and not low > 0:
            self.given.refuse("logNormal (MEDIAN DEVIATION): the median is above zero")
        if self.kind != "range" and not high > 0:
            self.given.refuse(f"the deviation of {self.kind} is above zero")

    def listed(self):
        """Its values in a grid."""
        if self.kind == "values":
            return self.texts
        number = self.given.count("number")
        return [self.at(u) for u in np.linspace(0, 1, number)]

    def at(self, u):
        """The value that is above a part u of all."""
        if self.kind == "values":
            return self.texts[min(int(u * len(self.texts)), len(self.texts) - 1)]
        a, b = self.pair
        if self.kind == "range":
            value = a * (b / a) ** u if self.logarithmic else a + u * (b - a)
        else:
            normal = stats.norm.ppf(u)
            value = a + b * normal if self.kind == "normal" else a * np.exp(b * normal)
        return f"{value:.10g}"


def pairs(given, word):
    """Of \"FILE:ENTRY\" or a list of them."""
    texts = given.get(word)
    found = []
    for text in texts if isinstance(texts, list) else [texts]:
        file, colon, entry = text.partition(":")
        if not colon or not entry:
            given.refuse(f"{word} '{text}' is not \"FILE:ENTRY\", with the quotes")
        found.append((file, entry))
    return found


def check_entries(name, pairs, case, refuse):
    """Is every entry there? Keywords that a case leaves out are not told from typos."""
    for file, entry in pairs:
        if case.get(file, entry) is not None:
            continue
        if not case.keywords(file, ""):
            refuse(f"there is no dictionary {file} in {case.case}")
        words = entry.replace(".", "/").split("/")
        while words and case.get(file, "/".join(words)) is None:
            wrong = words.pop()
        there = ", ".join(w for w in case.keywords(file, "/".join(words)) if w != "FoamFile")
        refuse(f"{file} has no entry {entry}: no '{wrong}' in "
               f"{'/'.join(words) or 'it'}, where {there or 'nothing'} is; what shall be "
               "varied is to be in the case, also a default")


def plan(sampling, parameters, samples):
    """Rows of values, in the order in which they are run."""
    if sampling == "grid":
        return [list(row) for row in itertools.product(*(p.listed() for p in parameters))]
    if sampling == "list":
        return [list(row) for row in zip(*(p.listed() for p in parameters))]
    rows = points(sampling, len(parameters), samples)
    return [[p.at(u) for p, u in zip(parameters, row)] for row in rows]


def points(sampling, dimensions, samples):
    """In the unit cube."""
    if sampling == "random":
        return np.random.default_rng(SEED).random((samples, dimensions))
    if sampling == "latinHypercube":
        return stats.qmc.LatinHypercube(dimensions, seed=SEED).random(samples)
    both = stats.qmc.Sobol(2 * dimensions, seed=SEED).random(samples)
    return saltelli(both[:, :dimensions], both[:, dimensions:])


def saltelli(a, b):
    """A, B, and A with column i of B for every i, one row of each after the other."""
    rows = []
    for j in range(len(a)):
        rows += [a[j], b[j]]
        for i in range(a.shape[1]):
            row = a[j].copy()
            row[i] = b[j, i]
            rows.append(row)
    return np.array(rows)
