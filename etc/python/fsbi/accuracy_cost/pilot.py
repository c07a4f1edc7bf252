# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Some seeds on all levels of a parameter, and what they say: ensemble.csv, ensemble.png,
a recommendation. fsbiAccuracyCost --ensemble."""

import csv
import os
import sys
import time

import numpy as np

from fsbi import plots
from fsbi.ensemble.dictionary import Seed
from fsbi.ensemble.sampling import check_entries
from fsbi.studies import Refused, command
from fsbi.studies.runs import Failed
from fsbi.studies.spread import duration, spread

from .multilevel import SURE, Levels

LEAST = 4               # seeds on all levels: fewer have no interval of a correlation


def seed_of(text, bench, count):
    file, colon, entry = text.partition(":")
    if not colon or not entry:
        raise Refused(f"--seedEntry {text} is not FILE:ENTRY")

    def refuse(what):
        raise Refused(f"--ensemble: {what}")

    check_entries("seed", [(file, entry)], bench.entries, refuse)
    return Seed((file, entry), [str(i + 1) for i in range(count)])


class Run:
    def __init__(self, level, seed, settings):
        self.level, self.seed, self.settings = level, seed, settings
        self.value, self.record, self.failed = None, None, None

    def name(self):
        return ", ".join(f"{k} {v}" for k, v in self.settings.items())


class Pilot:
    """Runs of all levels, the values of one parameter, with each of the seeds."""

    def __init__(self, bench, parameter, seed, quantity, jobs=1, out=sys.stdout):
        if not parameter.numeric() or len(parameter.values) < 2:
            raise Refused(f"--ensemble: values of {parameter.name} are to be two numbers or "
                          "more, from coarse to fine")
        self.bench, self.quantity, self.jobs, self.out = bench, quantity, jobs, out
        self.parameter, self.parameters = parameter, [parameter, seed]
        self.runs = [Run(i, s, {parameter.name: value, "seed": s}) for s in seed.listed()
                     for i, value in enumerate(parameter.values)]
        self.took = []

    def run(self):
        for r in self.runs:
            record = self.bench.load(r.settings, self.parameters)
            if record:
                self._take(r, record)
        waiting = [r for r in self.runs if r.record is None]
        if len(waiting) < len(self.runs):
            print(f"{len(self.runs) - len(waiting)} of {len(self.runs)} runs are kept from before",
                  file=self.out)
        self.begun, self.total, self.left = {}, len(waiting), waiting
        spread(waiting, self.jobs, self._begin, self._finished, self.bench.stop)

    def done(self):
        return sum(r.record is not None for r in self.runs)

    def _begin(self, run):
        self.begun[run] = time.monotonic()
        return lambda: self.bench.run(run.settings, self.parameters)

    def _take(self, run, record):
        run.record, run.value = record, self.quantity.value(record["folder"])
        if not np.isfinite(run.value):
            run.failed = f"{self.quantity.label} is not finite"

    def _finished(self, run, job):
        took = time.monotonic() - self.begun[run]
        self.took.append(took)
        try:
            self._take(run, job.result())
        except Failed as error:
            run.failed = str(error)
        what = f"failed: {run.failed}" if run.failed else \
            f"{self.quantity.label} {run.value:.5g}"
        left = np.mean(self.took) * len(self.left) / self.jobs
        print(f"[{len(self.took)}/{self.total}] {run.name()}; took {duration(took)}: {what}"
              + (f"; {duration(left)} left" if left else ""), file=self.out, flush=True)

    def levels(self, reference=None):
        """Of the seeds that ended well on all levels."""
        bad = {r.seed for r in self.runs if r.failed}
        good = [r for r in self.runs if r.seed not in bad]
        count = len(self.parameter.values)
        if len(good) < LEAST * count:
            first = next((r for r in self.runs if r.failed), None)
            raise Refused(f"only {len(good) // count} seeds ended well on all levels, fewer than "
                          f"{LEAST}" + (f"; {first.name()}: {first.failed}" if first else ""))
        if bad:
            print(f"    {len(bad)} seeds failed on some level and are left out", file=self.out)
        at = [[r for r in good if r.level == i] for i in range(count)]
        self.cells = [max(r.record["cells"] for r in mine) for mine in at]
        sizes = [self.parameter.size(v) for v in self.parameter.values]
        return Levels([[r.value for r in mine] for mine in at],
                      [np.mean([r.record["seconds"] for r in mine]) for mine in at],
                      sizes, reference)


# What is told

def rows(pilot, levels, best):
    """Of every level; numbers of seeds are those of the best mix."""
    for i, value in enumerate(pilot.parameter.values):
        below = i - 1 if i else None
        seeds = best.seeds[best.levels.index(i)] if best and i in best.levels else 0
        yield (value, pilot.cells[i], levels.seconds[i], levels.means[i], levels.variance(i),
               levels.variance(i, below) if i else np.nan,
               levels.correlation(i, below) if i else np.nan, levels.bias[i],
               levels.unsure[i], seeds)


HEADER = ("level", "cells", "seconds", "mean", "variance", "differenceVariance", "correlation",
          "bias", "biasStandardError", "seeds")


def table(pilot, levels, best, path):
    with open(path + ".part", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for r in rows(pilot, levels, best):
            writer.writerow([r[0], r[1], *(f"{v:.6g}" if v == v else "" for v in r[2:-1]), r[-1]])
    os.replace(path + ".part", path)


def text(pilot, levels, wanted, scale):
    """What is printed: a line a level, then what is cheapest."""
    mixes = levels.mixes(wanted)
    best = mixes[0] if mixes else None
    lines = [f"{pilot.parameter.name:>9} {'cells':>8} {'seconds':>8} {'mean':>11} {'variance':>10} "
             f"{'of diff.':>10} {'corr.':>6} {'bias':>10} {'+-':>9} {'seeds':>6}"]
    for r in rows(pilot, levels, best):
        of, r_ = (f"{v:{w}}" if v == v else "" for v, w in ((r[5], ".3g"), (r[6], ".2f")))
        lines.append(f"{r[0]:>9} {r[1]:8d} {r[2]:8.3g} {r[3]:11.5g} {r[4]:10.3g} {of:>10} {r_:>6} "
                     f"{r[7]:10.3g} {r[8]:9.2g} {r[9]:6d}")
    return lines + [""] + advice(pilot, levels, wanted, scale, mixes), best


def described(pilot, levels, mix):
    names = [pilot.parameter.values[i] for i in mix.levels]
    word = pilot.parameter.name
    if len(names) == 1:
        return f"{word} {names[0]} alone, {mix.seeds[0]} seeds"
    parts = [f"{mix.seeds[0]} seeds on {word} {names[0]}"]
    parts += [f"{n} on both {a} and {b}" for n, a, b in zip(mix.seeds[1:], names, names[1:])]
    return ", ".join(parts)


def advice(pilot, levels, wanted, scale, mixes):
    head = f"For an error of {wanted / scale:g} ({wanted:.3g}) of the mean"
    lines = []
    if not mixes:
        lines.append(f"{head}: no level reaches it, the least bias is {levels.least():.2g}; "
                     "take finer ones.")
    else:
        best, single = mixes[0], levels.single(wanted)
        lines.append(f"{head} take {described(pilot, levels, best)}: {duration(best.cost)}, "
                     f"error {best.error:.2g}.")
        if len(best.levels) > 1 and single:
            lines.append(f"One level, {described(pilot, levels, single)}, takes "
                         f"{duration(single.cost)}, {single.cost / best.cost:.2g} times as long.")
        elif len(best.levels) == 1:
            lines.append("One level is the cheapest" + _why(pilot, levels) + ".")
    if levels.reference is None:
        lines.append(f"The bias is by order {levels.order:.2g}.")
    vague = [v for i, v in enumerate(pilot.parameter.values)
             if levels.counted(i) == 0 and SURE * levels.unsure[i] > 0.5 * wanted]
    if vague:
        lines.append(f"Warning: by {levels.seeds} seeds the bias of {pilot.parameter.name} "
                     f"{', '.join(vague)} cannot be told from zero and counts as none, but may be "
                     f"more than half of what is wanted: more --seeds would say more.")
    return lines


def _why(pilot, levels):
    values = pilot.parameter.values
    apart = [f"{values[i - 1]} and {values[i]}" for i in range(1, levels.count)
             if not levels.correlated(i, i - 1)]
    if not apart:
        return ": a correction by differences would cost more"
    return ": paths of the same seeds do not correlate on " + "; ".join(apart)


def draw(pilot, levels, wanted, scale, best, path, title=""):
    """Error of the mean over seconds: every level alone, and the cheapest mix."""
    figure, axes = plots.plt.subplots(figsize=(7, 4.6))
    high = np.sqrt(max(levels.variance(i) for i in range(levels.count))) / scale
    cheap = min(levels.seconds)
    for i, value in enumerate(pilot.parameter.values):
        seeds = np.geomspace(1, 1e5, 200)
        error = np.sqrt(levels.counted(i)**2 + levels.variance(i) / seeds) / scale
        axes.plot(seeds * levels.seconds[i], error, color=plots.COLOURS[i % 6],
                  label=f"{pilot.parameter.name} {value}")
    found = [(m[0].cost, m[0].error / scale) for e in np.geomspace(high, 0.05 * wanted / scale, 120)
             if (m := levels.mixes(e * scale))]
    if found:
        axes.plot(*zip(*found), color=plots.INK, ls="--", lw=1.6, label="cheapest mix")
    axes.axhline(wanted / scale, color=plots.INK, lw=0.9, ls=(0, (5, 4)),
                 label=f"wanted: {wanted / scale:g}")
    last = 10 * cheap
    if best:
        axes.plot([best.cost], [best.error / scale], ls="none", marker="*", ms=15, mfc="white",
                  mec=plots.COLOURS[1], label="recommended")
        last = 20 * best.cost
    plots.plain_logarithm(axes)
    axes.set(xlim=(0.8 * cheap, last), yscale="log", ylim=(0.2 * wanted / scale, 1.5 * high),
             xlabel="processor's seconds of all runs", ylabel="root mean square error of the mean")
    axes.set_title(title or f"What a mean costs: {pilot.quantity.label}", loc="left")
    axes.legend(fontsize=9)
    plots.save(figure, path)


def conclude(pilot, reference, scale, accuracy, title=""):
    """Run what is missing, then tell, and write both files."""
    bench, quantity = pilot.bench, pilot.quantity
    os.makedirs(bench.kept, exist_ok=True)
    try:
        pilot.run()
    except KeyboardInterrupt:
        command.stopped(pilot.done(), len(pilot.runs))
    levels = pilot.levels(reference)
    scale = scale or abs(reference or levels.means[-1] + levels.bias[-1])
    if not scale > 0:
        raise Refused(f"{quantity.text}: a mean of zero has no relative error; give --scale")
    lines, best = text(pilot, levels, accuracy * scale, scale)
    print("\n".join(lines))
    table(pilot, levels, best, os.path.join(bench.folder, "ensemble.csv"))
    draw(pilot, levels, accuracy * scale, scale, best,
         os.path.join(bench.folder, "ensemble.png"), title)
