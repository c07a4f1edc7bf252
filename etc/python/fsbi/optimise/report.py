# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""table.csv and optimise.png of a search, and what is printed."""

import os

import numpy as np

from fsbi import plots
from fsbi.ensemble.report import write_table

from .study import FLAT


def write(study):
    folder = study.bench.folder
    table(study, os.path.join(folder, "table.csv"))
    study.keep_best(os.path.join(folder, "best"))
    for line in sentences(study):
        print("    " + line)
    draw(study, os.path.join(folder, "optimise.png"))


def table(study, path):
    """A row a point, means over its seeds."""
    about = study.about
    rows = []
    for p in study.points:
        row = [p.number, *p.settings.values()]
        if p.failed:
            empty = len(about.results) + 4 + len(about.constraints)
            rows.append([*row, *[""] * empty, p.failed])
            continue
        numbers = [*np.mean(list(p.rows.values()), axis=0), *p.estimate(),
                   *(p.of(c.formula).mean() for c in about.constraints)]
        rows.append([*row, *(f"{v:.10g}" for v in numbers), "yes" if p.met() else "no", ""])
    write_table(path, ["point", *(p.name for p in about.parameters),
                       *(r.name for r in about.results), "value", "low", "high",
                       *(c.name for c in about.constraints), "met", "failed"], rows)


def _band(estimate):
    value, low, high = estimate
    return f"{value:.5g}" + (f" ({low:.4g} to {high:.4g})" if low == low else "")


def _ranges(study, points):
    return ", ".join(
        "{} {:.4g} to {:.4g}".format(p.name, *(f([float(q.settings[p.name]) for q in points])
                                               for f in (min, max)))
        for p in study.about.parameters)


def sentences(study):
    about, best = study.about, study.best()
    failed = [p for p in study.points if p.failed]
    if failed:
        yield (f"{len(failed)} of {len(study.points)} points failed; the first, "
               f"{failed[0].name()}: {failed[0].failed}")
    if best.met():
        yield f"best of {len(study.points)} points: {best.name()}"
    else:
        yield f"no point meets the constraints; nearest to them: {best.name()}"
    yield f"{about.wanted} {about.goal.text}: {_band(best.estimate())}"
    for c, room in zip(about.constraints, best.rooms()):
        yield (f"{c.name}: {best.of(c.formula).mean():.5g}, {c.side} {c.bound:g} "
               + ("met" if room >= 0 else "NOT MET"))
    if study.again and study.again.failed:
        yield f"the best one failed with other seeds: {study.again.failed}"
    elif study.again:
        yield (f"with other seeds, which had no part in the choice: "
               f"{_band(study.again.estimate())}")
    yield from _flat(study, best)


def _flat(study, best):
    """How well the place is known."""
    second, alike = study.second(), study.alike()
    if study.about.seed and second and second in alike:
        yield f"the best two, {best.name()} and {second.name()}, cannot be told apart"
    if alike:
        how = "cannot be told from it" if study.about.seed else f"within {100 * FLAT:g} % of it"
        yield f"{how}: {len(alike)} more points, {_ranges(study, [best, *alike])}"
    for p in study.about.parameters:
        at = float(best.settings[p.name])
        ends = [e for e in p.pair if abs(at - e) <= study.about.tolerance * (p.pair[1] - p.pair[0])]
        if ends:
            yield f"{p.name} is at the end {ends[0]:g} of its range: better ones may be outside"


def draw(study, path):
    """The goal over the points, with the best so far, and over every parameter."""
    about = study.about
    good = [p for p in study.points if not p.failed]
    met = np.array([p.met() for p in good])
    found = np.array([p.estimate() for p in good])
    value, bars = found[:, 0], np.nan_to_num(
        [found[:, 0] - found[:, 1], found[:, 2] - found[:, 0]]).clip(0)
    best = good.index(study.best())
    panels = [("point", [p.number for p in good])] + [
        (p.name, [float(q.settings[p.name]) for q in good]) for p in about.parameters]
    figure, axes = plots.plt.subplots(1, len(panels), squeeze=False, sharey=True,
                                      figsize=(1 + 3.2 * len(panels), 3.9))
    for a, (name, x) in zip(axes[0], panels):
        x = np.array(x, float)
        for which, colour, label in ((met, plots.COLOURS[0], "constraints met"),
                                     (~met, "#bbbbbb", "not met")):
            if which.any():
                a.errorbar(x[which], value[which], bars[:, which], ls="", marker="o", ms=4.5,
                           mfc="white", color=colour, label=label, zorder=2)
        a.plot(x[best], value[best], "*", ms=13, color=plots.COLOURS[1], label="best", zorder=3)
        a.set_xlabel(name)
    for a, p in zip(axes[0][1:], about.parameters):
        if p.logarithmic:
            plots.plain_logarithm(a)
    if met.any():
        _so_far(axes[0][0], np.array(panels[0][1])[met], about.sign * value[met], about.sign)
    axes[0][0].set_ylabel(about.goal.text)
    axes[0][0].legend()
    plots.save(figure, path)


def _so_far(axes, numbers, values, sign):
    axes.step(numbers, sign * np.minimum.accumulate(values), where="post", lw=1,
              color=plots.INK, zorder=1)
