# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points, their runs, and which of them is the best.

Every point has the same seeds, so that chance is nearly the same at two of them, and
their difference is known better than either. The search asks for one point after the
other from what it knows: made again, with the runs that are kept, it asks for the
same ones, which is how a study that was stopped goes on.
"""

import shutil
import sys
import time

import numpy as np

from fsbi.ensemble import statistics
from fsbi.ensemble.study import told
from fsbi.studies import Refused
from fsbi.studies.runs import Failed
from fsbi.studies.spread import duration, spread

from . import search

FLAT = 0.01     # runs without chance: points are as good if no more apart


class Point:
    """What the runs at a point gave: `rows`, one of every seed."""

    def __init__(self, number, settings, about):
        self.number, self.settings, self.about = number, settings, about
        self.rows, self.failed = {}, None

    def name(self):
        return ", ".join(f"{name} {float(value):.5g}" for name, value in self.settings.items())

    def ended(self, seeds):
        return self.failed is not None or all(s in self.rows for s in seeds)

    def named(self, row):
        return {**{n: float(v) for n, v in self.settings.items()},
                **{r.name: v for r, v in zip(self.about.results, row)}}

    def of(self, formula):
        """Of every seed."""
        return np.array([formula(self.named(row)) for row in self.rows.values()])

    def value(self):
        return self.about.sign * float(self.of(self.about.goal).mean())

    def rooms(self):
        return [c.room(float(self.of(c.formula).mean())) for c in self.about.constraints]

    def measured(self):
        """(value, the lower the better, rooms); nan if a run failed."""
        if self.failed:
            return [np.nan] * (1 + len(self.about.constraints))
        return [self.value(), *self.rooms()]

    def met(self):
        return not self.failed and min(self.rooms(), default=0) >= 0

    def estimate(self):
        """(value, low, high) of the goal."""
        values = self.of(self.about.goal)
        happens = self.about.happens()
        if happens:
            return happens.estimate(values, self.about.confidence)
        return (float(values.mean()), *statistics.mean(values, self.about.confidence))


class Optimisation:
    def __init__(self, bench, about, jobs=1, out=sys.stdout):
        self.bench, self.about, self.jobs, self.out = bench, about, jobs, out
        self.parameters = about.all_parameters()
        self.points, self.again = [], None
        self.kept, self.took = 0, []

    # Runs

    def _settings(self, point, seed):
        return point.settings if seed is None else {**point.settings, "seed": seed}

    def _take(self, point, seed, record):
        """record(): a run's; what it gave, or why it gave nothing."""
        try:
            folder = record()["folder"]
        except Failed as failure:
            point.failed = point.failed or str(failure)
            return
        point.rows[seed] = [r.value(folder) for r in self.about.results]
        named = point.named(point.rows[seed])
        formulae = [self.about.goal, *(c.formula for c in self.about.constraints)]
        wrong = [f.text for f in formulae if not np.isfinite(f(named))]
        if wrong:
            point.failed = f"{wrong[0]}: not a finite number"

    def _load(self, point, seed):
        """Is it kept from before?"""
        settings = self._settings(point, seed)
        record = self.bench.load(settings, self.parameters)
        failed = self.bench.failure(settings, self.parameters)
        if record:
            self._take(point, seed, lambda: record)
        elif failed:
            point.failed = point.failed or failed
        self.kept += bool(record or failed)
        return bool(record or failed)

    def _run(self, points, seeds):
        waiting = [(p, s) for p in points for s in seeds if not self._load(p, s)]
        if waiting and not self.took and self.kept:
            print(f"{self.kept} runs are kept from before", file=self.out)
        begun = {}

        def begin(item):
            point, seed = item
            begun[item] = time.monotonic()
            return lambda: self.bench.run(self._settings(point, seed), self.parameters)

        def finished(item, job):
            self._take(*item, job.result)
            self.took.append(time.monotonic() - begun[item])
            self._tell(*item)

        spread(waiting, self.jobs, begin, finished, self.bench.stop)
        for point in points:        # the table does not depend on which ended first
            point.rows = {s: point.rows[s] for s in seeds if s in point.rows}

    def done(self):
        return self.kept + len(self.took)

    def _tell(self, point, seed):
        name = point.name() + (f", seed {seed}" if seed else "")
        if seed in point.rows:
            what = ", ".join(f"{r.name} {told(r, v)}"
                             for r, v in zip(self.about.results, point.rows[seed]))
        else:
            what = f"failed: {point.failed}"
        left = np.mean(self.took) * (self.about.runs - self.done()) / self.jobs
        print(f"[{self.done()}/{self.about.runs}] {name}; took {duration(self.took[-1])}: {what}"
              + (f"; at most {duration(left)} left" if left > 0 else ""),
              file=self.out, flush=True)

    # Search

    def _at(self, unit):
        """The point there; a new one, or that which has these values."""
        settings = self.about.settings(unit)
        for point in self.points:
            if point.settings == settings:
                return point
        self.points.append(Point(len(self.points) + 1, settings, self.about))
        return self.points[-1]

    def _measure(self, unit):
        point = self._at(unit)
        if not point.ended(self.about.seeds()):
            self._run([point], self.about.seeds())
        return point.measured()

    def run(self):
        about = self.about
        first = search.first_points(len(about.parameters), about.points())
        self._run([self._at(unit) for unit in first], about.seeds())
        rows = [p.measured() for p in self.points]
        start = search.best(rows)
        if start is None:
            raise Refused(f"all of the first {len(rows)} points failed; the first, "
                          f"{self.points[0].name()}: {self.points[0].failed}")
        search.descend(self._measure, first[start], search.Scaled(rows),
                       about.points() - len(first), about.tolerance)
        best = self.best()
        if about.seed:
            self.again = Point(best.number, best.settings, about)
            self._run([self.again], about.other_seeds())

    def best(self):
        return self.points[search.best([p.measured() for p in self.points])]

    # Results

    def alike(self):
        """Other points that are as good as the best one, as far as is known: the
        interval of the difference has the zero in it; without chance: by FLAT."""
        best = self.best()
        return [p for p in self.points if p is not best and p.met() and self._alike(p, best)]

    def _alike(self, point, best):
        goal = self.about.goal
        if not self.about.seed:
            return abs(point.value() - best.value()) <= FLAT * abs(best.value())
        low, high = statistics.mean(point.of(goal) - best.of(goal), self.about.confidence)
        return not (low > 0 or high < 0)        # nan of few seeds: not known

    def second(self):
        """The next best that meets the constraints, or None."""
        best = self.best()
        others = [p for p in self.points if p is not best and p.met()]
        return min(others, key=lambda p: p.value(), default=None)

    def keep_best(self, folder):
        """The case with its values, ready to run, with the results of its run."""
        best = self.best()
        shutil.rmtree(folder, ignore_errors=True)
        seed = self.about.seeds()[0]
        settings = self._settings(best, seed)
        self.bench.copy(folder, settings, self.parameters)
        record = self.bench.load(settings, self.parameters)
        shutil.copytree(record["folder"], folder, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("run.json"))
