# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which runs there are, in which order, which of them count.

Runs that differ by their seed alone are a group; if values were drawn all are one. A
group stops at the first number of its runs, in their order, with which every
half-width wanted is reached. Runs that were begun beside the last of these do not
count, so that the table does not depend on how many ran at a time, nor on what was
stopped and continued.
"""

import sys
import time

import numpy as np

from fsbi.studies import Refused
from fsbi.studies.runs import Failed
from fsbi.studies.spread import duration, spread

from . import sampling

LEAST = 8       # runs of a group, before it stops: bands of fewer say little


class Member:
    """A run: its number, values of all parameters; what came of it."""

    def __init__(self, number, settings):
        self.number, self.settings = number, settings
        self.values, self.failed = None, None

    def name(self):
        return ", ".join(f"{name} {value}" for name, value in self.settings.items())

    def ended(self):
        return self.values is not None or self.failed is not None


class Group:
    def __init__(self, settings):
        self.settings, self.members = settings, []
        self.counts = None          # how many of them count, once that is known
        self._looked = LEAST

    def update(self, reached):
        """reached(values): are these enough?"""
        while self.counts is None:
            first = self.members[:self._looked]
            if not all(m.ended() for m in first):
                return
            good = [m.values for m in first if not m.failed]
            if len(first) == len(self.members) or len(good) >= LEAST and reached(good):
                self.counts = len(first)
            self._looked += 1

    def counting(self):
        return self.members[:self.counts]


class Ensemble:
    def __init__(self, bench, description):
        self.bench, self.about = bench, description
        self.parameters = description.all_parameters()
        self.results = description.results
        self.members, self.groups = [], []
        self._plan()

    def _plan(self):
        about = self.about
        if about.drawn:
            rows = sampling.plan(about.sampling, self.parameters, about.samples)
            self.groups = [Group({})]
            for row in rows:
                self._add(self.groups[0], dict(zip((p.name for p in self.parameters), row)))
            return
        points = sampling.plan(about.sampling, about.parameters, None)
        names = [p.name for p in about.parameters]
        self.groups = [Group(about.complete(dict(zip(names, point)))) for point in points]
        # a seed for all points, then the next: what is there early says most
        for seed in about.seed.listed() if about.seed else [None]:
            for group in self.groups:
                self._add(group, {**group.settings, **({} if seed is None else {"seed": seed})})

    def _add(self, group, settings):
        member = Member(len(self.members) + 1, settings)
        member.group = group
        group.members.append(member)
        self.members.append(member)

    # Running

    def load(self, members):
        """What is kept of them from before; how many that are."""
        for member in members:
            record = self.bench.load(member.settings, self.parameters)
            if record:
                self._take(member, record["folder"])
            else:
                member.failed = self.bench.failure(member.settings, self.parameters)
        for group in self.groups:
            group.update(self._enough)
        return sum(m.ended() for m in members)

    def waiting(self):
        return [m for m in self.members if not m.ended() and m.group.counts is None]

    def measure(self, member):
        return self.bench.run(member.settings, self.parameters)

    def take(self, member, job):
        """What a run gave, or why it did not."""
        try:
            self._take(member, job()["folder"])
        except Failed as failure:
            member.failed = str(failure)
        member.group.update(self._enough)

    def _take(self, member, folder):
        values = [r.value(folder) for r in self.results]
        wrong = [r.name for r, v in zip(self.results, values) if not np.isfinite(v)]
        if wrong:
            member.failed = f"{', '.join(wrong)}: not a finite number"
        else:
            member.values = values

    def _enough(self, rows):
        wanted = [(i, r) for i, r in enumerate(self.results) if r.wanted]
        return bool(wanted) and all(
            self._half_width(r, [row[i] for row in rows]) <= r.wanted for i, r in wanted)

    def _half_width(self, result, values):
        _, low, high = result.estimate(values, self.about.confidence)
        return (high - low) / 2

    def run(self, jobs, out=sys.stdout):
        waiting = self.waiting()
        Progress(self, waiting, jobs, out).run()

    # Results

    def counting(self):
        """In the order of the numbers."""
        found = [m for group in self.groups for m in group.counting()]
        return sorted(found, key=lambda m: m.number)

    def estimates(self):
        """(group, result, values that count, (value, low, high)) of all."""
        for group in self.groups:
            for i, result in enumerate(self.results):
                values = [m.values[i] for m in self._independent(group) if not m.failed]
                yield group, result, values, result.estimate(values, self.about.confidence)

    def _independent(self, group):
        """Those drawn independently: of Saltelli's only A and B."""
        members = group.counting()
        if self.about.sampling != "Sobol":
            return members
        block = 2 + len(self.parameters)
        return [m for i, m in enumerate(members) if i % block < 2]

    def blocks(self):
        """Values (samples, A B AB_1 ..., results) of Saltelli's samples that have all
        their runs, and how many have not."""
        block = 2 + len(self.parameters)
        found = [self.members[i:i + block] for i in range(0, len(self.members), block)]
        whole = [[m.values for m in b] for b in found if not any(m.failed for m in b)]
        if len(whole) < 2:
            raise Refused("of the samples fewer than two have all their runs; see the table "
                          "for why they failed")
        return np.array(whole), len(found) - len(whole)


class Progress:
    """One line a run, with what it gave and the time left."""

    def __init__(self, ensemble, waiting, jobs, out):
        self.ensemble, self.waiting, self.jobs, self.out = ensemble, waiting, jobs, out
        self.begun, self.took, self.running = {}, [], 0

    def run(self):
        spread(self.waiting, self.jobs, self._begin, self._finished, self.ensemble.bench.stop)

    def _begin(self, member):
        self.begun[member.number] = time.monotonic()
        self.running += 1
        return lambda: self.ensemble.measure(member)

    def _finished(self, member, job):
        self.running -= 1
        took = time.monotonic() - self.begun[member.number]
        self.took.append(took)
        self.ensemble.take(member, job.result)
        self.waiting[:] = [m for m in self.waiting if m.group.counts is None]
        what = f"failed: {member.failed}" if member.failed else ", ".join(
            f"{r.name} {told(r, v)}" for r, v in zip(self.ensemble.results, member.values))
        left = np.mean(self.took) * (len(self.waiting) + 0.5 * self.running) / self.jobs
        print(f"[{member.number}/{len(self.ensemble.members)}] {member.name()}; took "
              f"{duration(took)}: {what}" + (f"; {duration(left)} left" if left else ""),
              file=self.out, flush=True)


def told(result, value):
    return ("no", "yes")[int(value)] if result.yes_or_no() else f"{value:.5g}"
