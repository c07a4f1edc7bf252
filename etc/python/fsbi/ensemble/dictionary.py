# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""system/ensembleDict of a case, checked: see etc/dictionaries/ensembleDict."""

import os

import numpy as np

from fsbi.studies import Refused, dictionary
from fsbi.studies.quantities import Quantity

from . import statistics
from .sampling import DRAWN, SAMPLINGS, Parameter, Varied, check_entries, plan
from .smallest import Wanted
from .treatment import Treatment

FILE = "system/ensembleDict"
WORDS = ("parameters", "quantities", "sampling", "samples", "seeds", "seedEntry",
         "confidence", "prepare", "patients", "drug", "protocols", "smallest")
TREATMENT = ("patients", "drug", "protocols")
RESULT_WORDS = ("quantity", "above", "below", "halfWidth")
SEED_ENTRY = "constant/effects:bonds/seed"


class Seed(Varied):
    """Of the random numbers, one more thing that varies."""

    name = "seed"

    def __init__(self, pair, seeds=()):
        super().__init__(self.name, [pair])
        self.seeds = seeds

    def listed(self):
        return self.seeds

    def at(self, u):
        """Another one for every u."""
        return str(int(u * (2**31 - 1)))


def read_seed(top, drawn, sampling):
    """Of `seeds` and `seedEntry`; None: the case has its own in all runs."""
    given = top.get("seeds", "none")
    if given == "none":
        if "seedEntry" in top:
            top.refuse("'seedEntry' without seeds")
        return None
    file, colon, entry = top.get("seedEntry", SEED_ENTRY).partition(":")
    if not colon or not entry:
        top.refuse("seedEntry is not \"FILE:ENTRY\", with the quotes")
    if drawn:
        top.choice("seeds", ("each", "none"))
        return Seed((file, entry))
    if given == "each":
        top.refuse(f"seeds each belongs to {', '.join(DRAWN)}; {sampling} has a "
                   "number of seeds, or a list of them")
    if not isinstance(given, list):
        given = [str(i + 1) for i in range(top.count("seeds"))]
    for seed in given:
        if not str(seed).isdigit():
            top.refuse(f"a seed is a whole number, not '{dictionary.shown(seed)}'")
    if len(set(given)) < len(given):
        top.refuse("a seed stands there twice")
    return Seed((file, entry), given)


class Result:
    """A quantity that every run has; with `above` or `below` yes or no."""

    def __init__(self, name, given, sampling):
        given.only(*RESULT_WORDS)
        self.name = name
        try:
            self.quantity = Quantity(dictionary.shown(given.get("quantity")))
        except Refused as error:
            given.refuse(str(error))
        self.asked = [word for word in ("above", "below") if word in given]
        if len(self.asked) > 1:
            given.refuse("above and below: only one of them")
        self.bound = given.number(self.asked[0]) if self.asked else None
        self.wanted = given.above("halfWidth", 0) if "halfWidth" in given else None
        if self.wanted and sampling in ("latinHypercube", "Sobol"):
            given.refuse(f"sampling {sampling} needs all of its samples, halfWidth cannot "
                         "stop it; grid, list and random can be stopped")

    def yes_or_no(self):
        return bool(self.asked)

    def value(self, folder):
        value = self.quantity.value(folder)
        if not self.asked or not np.isfinite(value):
            return value
        return float(value > self.bound if self.asked == ["above"] else value < self.bound)

    def estimate(self, values, confidence):
        """(value, low, high) of its probability or mean."""
        if not len(values):
            return np.nan, np.nan, np.nan
        if self.yes_or_no():
            band = statistics.proportion(int(sum(values)), len(values), confidence)
        else:
            band = statistics.mean(values, confidence)
        return (float(np.mean(values)), *band)


class Description:
    """What the dictionary says: sampling, samples, parameters, those derived from them,
    seed, results, confidence, prepare; treatment and smallest, or None."""

    def __init__(self, case):
        top = dictionary.read(case, FILE)
        top.only(*WORDS)
        self.top = top
        self.sampling = top.choice("sampling", SAMPLINGS, "grid")
        self.drawn = self.sampling in DRAWN
        if self.drawn != ("samples" in top):
            top.refuse("'samples' belongs to " + ", ".join(DRAWN)
                       + (f", and {self.sampling} needs it" if self.drawn else ""))
        self.samples = top.count("samples") if self.drawn else None
        if self.sampling == "Sobol" and self.samples & (self.samples - 1):
            top.refuse(f"Sobol wants a power of two as samples, not {self.samples}")
        self.treatment = self._treatment(case)
        self.parameters = self.treatment.parameters if self.treatment else []
        if "parameters" in top or not self.treatment:
            self.parameters = self.parameters + [
                Parameter(name, given, self.sampling)
                for name, given in top.sections("parameters").items()]
        self.derived = self.treatment.derived if self.treatment else []
        self._check_points()
        self.seed = read_seed(top, self.drawn, f"a {self.sampling}")
        self.results = [Result(name, given, self.sampling)
                        for name, given in top.sections("quantities").items()]
        self.confidence = top.above("confidence", 0, "0.95")
        if not self.confidence < 1:
            top.refuse("'confidence' is below 1, as 0.95")
        self.prepare = dictionary.shown(top.get("prepare", "blockMesh"))
        self._check_names()
        self.smallest = Wanted(top.section("smallest"), self) if "smallest" in top else None

    def _treatment(self, case):
        there = [word for word in TREATMENT if word in self.top]
        if there and self.sampling != "grid":
            self.top.refuse(f"'{there[0]}' belongs to a grid, not to {self.sampling}")
        return Treatment(self.top, lambda file: os.path.join(case, file)) if there else None

    def complete(self, settings):
        """With what is derived from them."""
        return self.treatment.complete(settings) if self.treatment else settings

    def tables(self):
        """Files of the case that say which runs there are, and nothing to these."""
        tables = self.treatment.tables() if self.treatment else []
        return (FILE, *map(os.path.normpath, tables))

    def _check_points(self):
        """Of a list side by side, of a grid each once."""
        if self.drawn:
            return
        columns = [p.listed() for p in self.parameters]
        if self.sampling == "list" and len(set(map(len, columns))) > 1:
            self.top.refuse("sampling list takes values side by side, but there are "
                            + ", ".join(f"{len(c)} of {p.name}"
                                        for p, c in zip(self.parameters, columns)))
        points = plan(self.sampling, self.parameters, None)
        twice = [point for point in points if points.count(point) > 1]
        if twice:
            self.top.refuse(f"{' '.join(twice[0])} stands there twice")

    def _check_names(self):
        names = ["run", "failed", *(p.name for p in self.all_parameters()),
                 *(r.name for r in self.results)]
        twice = sorted({n for n in names if names.count(n) > 1})
        if twice:
            self.top.refuse(f"'{twice[0]}' names two columns of the table")

    def all_parameters(self):
        return [*self.parameters, *self.derived, *([self.seed] if self.seed else [])]

    def check(self, entries):
        """Against the case."""
        for p in (*self.parameters, *self.derived):
            check_entries(p.name, p.entries, entries, p.given.refuse)
        if self.seed:
            check_entries("seed", self.seed.entries, entries, self.top.refuse)
