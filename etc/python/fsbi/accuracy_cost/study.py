# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A study: which variants, in which order, what came out, what to take.

One parameter at a time around the case as it is. The best value of a quantity is the
reference, or that of the case corrected by every parameter's distance from its limit.
The error of a variant is that to the best value; the advice adds up the parameters'
own errors, without letting them cancel.
"""

import collections
import itertools
import sys

import numpy as np

from .. import convergence
from ..studies import Refused
from ..studies.runs import Failed
from ..studies.spread import duration, spread
from .predict import UNSURE, Predictor

Advice = collections.namedtuple("Advice", "settings error seconds megabytes width")


class Variant:
    def __init__(self, settings, base):
        self.settings = settings
        changed = [(k, v) for k, v in settings.items() if v != base[k]]
        self.parameter = changed[0][0] if len(changed) == 1 else None
        self.name = ", ".join(f"{k} {v}" for k, v in changed) or "as it is"
        self.record, self.failed, self.values = None, None, None
        self.errors, self.error = None, np.nan

    def done(self):
        return self.values is not None


class Study:
    def __init__(self, bench, parameters, quantities, references, scales, jobs=1):
        self.bench, self.parameters, self.jobs = bench, parameters, jobs
        self.quantities, self.references, self.scales = quantities, references, scales
        self.base = {k.name: k.values[k.base] for k in parameters}
        self.predictor = Predictor(parameters)
        self.variants = [Variant(s, self.base) for s in self._planned()]
        self.extra = []                     # of the advice

    def _planned(self):
        yield dict(self.base)
        for k in self.parameters:
            for v in k.values:
                if v != k.values[k.base]:
                    yield {**self.base, k.name: v}

    # Running

    def guess(self, variant):
        """Relative cost by usual exponents, to order the runs by."""
        x = self.predictor.point(variant.settings)
        return float(np.dot([p[0][0] for p in self.predictor.priors], x))

    def run(self, out=sys.stdout):
        """All variants that are not kept from before, cheap ones first."""
        waiting = []
        for v in sorted(self.variants, key=self.guess):
            record = self.bench.load(v.settings, self.parameters)
            if record:
                self.take(v, record)
            else:
                waiting.append(v)
        kept = len(self.variants) - len(waiting)
        if kept:
            print(f"{kept} of {len(self.variants)} variants are kept from before", file=out)
        Progress(self, waiting, out).run()

    def predicted(self, variant):
        """(seconds, megabytes, width, how) before the run; None: no way."""
        found = self.predictor.predict(variant.settings)
        if found is None or found[2] > UNSURE:
            short = self.bench.calibrate(variant.settings, self.parameters)
            if short:
                return (*short, 0.2, "calibration")
        return (*found, "laws" if found[2] <= UNSURE else "guess") if found else None

    def measure(self, variant, tell=None, prediction=None):
        """Run one; the record is taken by who started it."""
        notes = dict(contended=self.jobs > 1)
        if prediction:
            notes.update(predicted=prediction[0], predictedMegabytes=prediction[1],
                         predictedBy=prediction[3])
        return self.bench.run(variant.settings, self.parameters, tell, **notes)

    def take(self, variant, record):
        variant.record = record
        # processor seconds are those of an idle machine; it waited for others
        # where they passed much faster than the clock
        record["contended"] |= record["wall"] > 1.3 * record["seconds"] + 1
        values = np.array([q.value(record["folder"]) for q in self.quantities])
        if not np.isfinite(values).all():
            variant.failed = "a value is not finite"
            return
        variant.values = values
        self.predictor.add(variant.settings, record["seconds"] - record["meshing"],
                           record["meshing"], record["megabytes"])

    # Errors

    def analyse(self):
        base = self.variants[0]
        if not base.done():
            raise Refused("the case as it is does not run: "
                          f"{base.failed or 'stopped'}; nothing can be compared")
        self.limits = [{k.name: self._limit(k, i) for k in self.parameters}
                       for i in range(len(self.quantities))]
        self.best, self.unsure, self.scale, self.floor = [], [], [], []
        for i, limits in enumerate(self.limits):
            known = [e for e in limits.values() if e]
            value = base.values[i]
            own = value + sum(e.limit - value for e in known)
            reference = self.references[i]
            best = own if reference is None else reference
            self.best.append(best)
            self.unsure.append(np.sqrt(sum(e.uncertainty**2 for e in known)))
            self.scale.append(self.scales[i] or abs(best) or abs(value) or 1.0)
            self.floor.append(abs(best - own))
        for v in (*self.variants, *self.extra):
            if v.done():
                v.errors = np.abs(v.values - self.best) / self.scale
                v.error = float(v.errors.max())

    def of_parameter(self, parameter):
        """The variants of a parameter that were run, the base among them, in order."""
        found = {v.settings[parameter.name]: v for v in self.variants
                 if v.done() and v.parameter in (None, parameter.name)}
        return [found[v] for v in parameter.values if v in found]

    def _limit(self, parameter, i):
        """Estimate over a parameter's values, None for words or one value."""
        if not parameter.numeric():
            return None
        ran = self.of_parameter(parameter)
        if len(ran) < 2:
            return None
        return convergence.estimate([parameter.size(v.settings[parameter.name]) for v in ran],
                                    [v.values[i] for v in ran])

    def uncertainty(self):
        """Of the best values, relative, the largest; with references that of the
        limit of the runs, which the floor is known to."""
        return float(max(u / s for u, s in zip(self.unsure, self.scale)))

    def scattered(self):
        """Parameters whose values do not follow one power, in words."""
        found = dict.fromkeys(
            f"{k} ({q.label})" for q, limits in zip(self.quantities, self.limits)
            for k, e in limits.items() if e and e.kind in ("scattered", "monotone"))
        return ", ".join(found)

    def pareto(self, cost):
        """The variants that none beats in both error and cost, cheap first."""
        return front([v for v in (*self.variants, *self.extra) if v.done()],
                     lambda v: v.record[cost], lambda v: v.error)

    # Advice

    def advise(self, accuracy):
        """The cheapest settings whose parameters' errors and floor add up to the
        accuracy at most, or that were run and have it; None if there are none."""
        choices = [self._choices(k) for k in self.parameters]
        floor = np.array(self.floor) / self.scale
        mean, _ = self.predictor.law(0, np.zeros(len(self.predictor.features)))
        mesh, _ = self.predictor.law(1, np.zeros(len(self.predictor.features)))
        measured = {tuple(v.settings[k.name] for k in self.parameters): v.error
                    for v in (*self.variants, *self.extra) if v.done()}
        best = None
        for row in itertools.product(*choices):
            error = measured.get(tuple(c[0] for c in row))
            if error is None:
                error = float((floor + sum(c[1] for c in row)).max())
            if error > accuracy:
                continue
            x = np.concatenate(([1], *[c[2] for c in row]))
            seconds = np.exp(x @ mean) + np.exp(x @ mesh)
            if best is None or seconds < best[0]:
                best = seconds, row, error
        if best is None:
            return None
        settings = {k.name: c[0] for k, c in zip(self.parameters, best[1])}
        return Advice(settings, best[2], *self.predictor.predict(settings))

    def reachable(self):
        """The smallest error that any choice has."""
        least = min(v.error for v in (*self.variants, *self.extra) if v.done())
        floor = np.array(self.floor) / self.scale
        return min(least, float((floor + sum(
            min((c[1] for c in self._choices(k)), key=max) for k in self.parameters)).max()))

    def _choices(self, parameter):
        """(value, own errors relative, features) of values run, and of those
        between and somewhat beyond for the built-in parameters."""
        found = []
        for v in self.of_parameter(parameter):
            value = v.settings[parameter.name]
            found.append((value, self._own(parameter, value, v), self._features(parameter, value)))
        if parameter.name not in self.predictor_names() or len(found) < 3:
            return found
        sizes = sorted(float(c[0]) for c in found)
        low = 0.5 * sizes[0] if self._regular(parameter) else sizes[0]
        for size in np.exp(np.linspace(np.log(low), np.log(sizes[-1]), 13)):
            value = f"{size:.3g}"
            if value not in parameter.values:
                found.append((value, self._own(parameter, value), self._features(parameter, value)))
        return found

    def predictor_names(self):
        return {"mesh", "timeStep", "tolerance"}

    def _regular(self, parameter):
        return all(limits[parameter.name].kind in ("asymptotic", "settled")
                   for limits in self.limits)

    def _features(self, parameter, value):
        settings = {**self.base, parameter.name: value}
        x = self.predictor.point(settings)
        return x[[f[0] is parameter for f in self.predictor.features]]

    def _own(self, parameter, value, variant=None):
        """A parameter's own error of every quantity: measured, but not less than the
        fit has, since a value may pass the limit by chance."""
        errors = []
        for i, limits in enumerate(self.limits):
            e = limits[parameter.name]
            base = self.variants[0].values[i]
            measured = abs(variant.values[i] - (e.limit if e else base)) if variant else 0.0
            errors.append(max(measured, self._fitted(parameter, value, i)) / self.scale[i])
        return np.array(errors)

    def _fitted(self, parameter, value, i):
        """By the fit; without one, the largest distance from the limit of the
        next coarser value and all finer ones; of the finest, to the next."""
        e = self.limits[i][parameter.name]
        if e is None:
            return 0.0
        size = parameter.size(value)
        if e.kind != "scattered":
            order = e.order if np.isfinite(e.order) else convergence.FORMAL
            return abs(e.factor) * size**order
        ran = self.of_parameter(parameter)
        sizes = [parameter.size(v.settings[parameter.name]) for v in ran]
        first = max(j for j, s in enumerate(sizes) if s >= size * (1 - 1e-9) or j == 0)
        first = min(first, len(ran) - 2)
        return max(abs(v.values[i] - e.limit) for v in ran[first:])

    def verify(self, advice, out=sys.stdout):
        """Run the settings advised; the variant, with its error."""
        base = self.base
        same = [v for v in self.variants if v.settings == advice.settings]
        variant = same[0] if same else Variant(advice.settings, base)
        if not same:
            self.extra.append(variant)
            record = self.bench.load(variant.settings, self.parameters)
            if record:
                self.take(variant, record)
            else:
                Progress(self, [variant], out).run()
        if variant.done():
            variant.errors = np.abs(variant.values - self.best) / self.scale
            variant.error = float(variant.errors.max())
        return variant

    def recommend(self, accuracy, verify=False, out=sys.stdout):
        """Advice and the variant that verified it, or None. Errors of two parameters
        may be more than their sum: where the run shows that, the parameters are asked
        for as much less, twice at most."""
        advice, variant, wanted = self.advise(accuracy), None, accuracy
        for _ in range(3 if verify and advice else 0):
            variant = self.verify(advice, out)
            if not variant.done() or variant.error <= accuracy:
                break
            wanted *= min(0.8, accuracy / variant.error)
            again = self.advise(wanted)
            if again is None or again.settings == advice.settings:
                break
            advice = again
        if variant is not None and variant.settings != advice.settings:
            variant = self.verify(advice, out)
        return advice, variant

    def cheapest(self, accuracy):
        """Of the runs within the accuracy; None if there is none."""
        good = [v for v in (*self.variants, *self.extra)
                if v.done() and v.error <= accuracy]
        return min(good, key=lambda v: v.record["seconds"], default=None)

    def within(self, factor=1.5):
        """(number within the factor, number predicted, those of them that were
        guesses) of the predictions."""
        made = [v.record for v in (*self.variants, *self.extra)
                if v.done() and v.record.get("predicted")]
        good = [r for r in made if 1 / factor <= r["seconds"] / r["predicted"] <= factor]
        return len(good), len(made), sum(r["predictedBy"] == "guess" for r in made)


def front(items, cost, error):
    found, least = [], np.inf
    for item in sorted(items, key=lambda v: (cost(v), error(v))):
        if error(item) < least:
            found.append(item)
            least = error(item)
    return found


class Progress:
    """Runs what waits, one line each, with the time predicted and left."""

    def __init__(self, study, waiting, out):
        self.study, self.waiting, self.out = study, waiting, out
        self.total, self.ran = len(waiting), 0

    def run(self):
        spread(self.waiting, self.study.jobs, self._begin, self._finished, self.study.bench.stop)

    def _begin(self, variant):
        prediction = self._announce(variant)
        return lambda: self.study.measure(variant, self._tell, prediction)

    def _announce(self, variant):
        try:
            prediction = self.study.predicted(variant)
        except Failed:
            prediction = None               # the run will say why
        left = [p[0] for v in self.waiting
                if (p := self.study.predictor.predict(v.settings))]
        self.ran += 1
        self.head = f"[{self.ran}/{self.total}] {variant.name}"
        words = f"predicted {duration(prediction[0])}" if prediction else "not predicted"
        if prediction and prediction[3] != "laws":
            words += f" ({prediction[3]})"
        if len(left) == len(self.waiting) and prediction:
            words += f", all {duration(prediction[0] + sum(left))}"
        self.line = f"{self.head:32} {words}"
        print(self.line, end="" if self.study.jobs == 1 else "\n", file=self.out, flush=True)
        return prediction

    def _tell(self, part):
        if self.out.isatty() and self.study.jobs == 1:
            print(f"\r{self.line}  {100 * part:3.0f} %", end="", file=self.out, flush=True)

    def _finished(self, variant, job):
        who = "" if self.study.jobs == 1 else f"    {variant.name}"
        try:
            record = job.result()
            self.study.take(variant, record)
        except Failed as error:
            variant.failed = str(error)
        if variant.failed:
            print(f"{who}; failed: {variant.failed}", file=self.out, flush=True)
            return
        values = ", ".join(f"{q.label} {v:.8g}" for q, v
                           in zip(self.study.quantities, variant.values))
        print(f"{who}; took {duration(record['seconds'])}, {record['megabytes']:.0f} MB: "
              f"{values}", file=self.out, flush=True)
