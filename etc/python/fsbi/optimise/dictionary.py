# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""system/optimiseDict of a case, checked: see etc/dictionaries/optimiseDict."""

import numpy as np

from fsbi.ensemble.dictionary import Result, read_seed
from fsbi.ensemble.sampling import Parameter, check_entries
from fsbi.studies import Refused, dictionary
from fsbi.studies.formula import Formula

FILE = "system/optimiseDict"
GOALS = ("maximise", "minimise")
SIDES = ("above", "below")
WORDS = ("parameters", "quantities", *GOALS, "constraints", "runs", "tolerance", "seeds",
         "seedEntry", "confidence", "prepare")
CONSTRAINT_WORDS = ("formula", *SIDES)


def _formula(given, word, names):
    try:
        return Formula(dictionary.shown(given.get(word)), names)
    except Refused as error:
        given.refuse(str(error))


class Constraint:
    """Of a formula, averaged over the seeds."""

    def __init__(self, name, given, names):
        given.only(*CONSTRAINT_WORDS)
        self.name = name
        self.formula = _formula(given, "formula", names)
        self.side = given.one(*SIDES)
        self.bound = given.number(self.side)

    def room(self, value):
        """To the bound; below zero: it is not met."""
        return value - self.bound if self.side == "above" else self.bound - value


class Description:
    """What the dictionary says: parameters, results, goal (a formula) and sign, which
    makes it the lower the better, constraints, runs, tolerance, seed, confidence,
    prepare."""

    def __init__(self, case):
        top = dictionary.read(case, FILE)
        top.only(*WORDS)
        self.top = top
        self.parameters = [self._parameter(name, given)
                           for name, given in top.sections("parameters").items()]
        self.results = [Result(name, given, "")
                        for name, given in top.sections("quantities").items()]
        for result in self.results:
            if result.wanted:
                top.refuse(f"'halfWidth' of {result.name} belongs to fsbiEnsemble")
        names = [p.name for p in self.parameters] + [r.name for r in self.results]
        self._check_names(names, top.values.get("constraints"))
        self.wanted = top.one(*GOALS)
        self.sign = 1 if self.wanted == "minimise" else -1
        self.goal = _formula(top, self.wanted, names)
        self.constraints = [Constraint(name, given, names) for name, given in
                            (top.sections("constraints") if "constraints" in top else {}).items()]
        self.seed = read_seed(top, False, "a point")
        self.confidence = top.above("confidence", 0, "0.95")
        if not self.confidence < 1:
            top.refuse("'confidence' is below 1, as 0.95")
        self.tolerance = top.above("tolerance", 0, "0.01")
        if not self.tolerance < 0.1:
            top.refuse("'tolerance', of every range, is below 0.1")
        self.runs = top.count("runs")
        self._check_runs()
        self.prepare = dictionary.shown(top.get("prepare", "blockMesh"))

    def _parameter(self, name, given):
        parameter = Parameter(name, given, "random")
        if parameter.kind != "range":
            given.refuse(f"only a range can be searched, not {parameter.kind}")
        return parameter

    def _check_runs(self):
        """Enough for the first points and a simplex."""
        least = (2 * len(self.parameters) + 3) * len(self.seeds())
        if self.runs < least:
            self.top.refuse(f"{self.runs} runs are too few: with {len(self.parameters)} "
                            f"parameters and {len(self.seeds())} seeds at least {least}")

    def _check_names(self, names, constraints):
        wrong = [n for n in names if not n.isidentifier()]
        if wrong:
            self.top.refuse(f"'{wrong[0]}' cannot stand in a formula: letters, digits and _")
        names = ["point", "value", "low", "high", "met", "failed", "seed", *names,
                 *(constraints.values if isinstance(constraints, dictionary.Dictionary) else ())]
        twice = sorted({n for n in names if names.count(n) > 1})
        if twice:
            self.top.refuse(f"'{twice[0]}' names two columns of the table")

    def seeds(self):
        """Of every point; [None]: the case's own."""
        return self.seed.seeds if self.seed else [None]

    def other_seeds(self):
        """As many that no point has had."""
        if not self.seed:
            return []
        first = max(int(s) for s in self.seed.seeds) + 1
        return [str(first + i) for i in range(len(self.seed.seeds))]

    def points(self):
        """How many of them all runs are, with one more for the other seeds."""
        return self.runs // len(self.seeds()) - bool(self.seed)

    def all_parameters(self):
        return [*self.parameters, *([self.seed] if self.seed else [])]

    def happens(self):
        """The quantity, if the goal is nothing but how likely one is."""
        return next((r for r in self.results
                     if r.yes_or_no() and r.name == self.goal.text.strip()), None)

    def settings(self, point):
        """Of a point of the unit cube, with the digits that foamDictionary keeps."""
        return {p.name: f"{float(p.at(float(u))):.6g}"
                for p, u in zip(self.parameters, np.clip(point, 0, 1))}

    def check(self, entries):
        """Against the case."""
        for p in self.parameters:
            check_entries(p.name, p.entries, entries, p.given.refuse)
        if self.seed:
            check_entries("seed", self.seed.entries, entries, self.top.refuse)
