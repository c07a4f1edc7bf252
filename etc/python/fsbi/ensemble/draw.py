# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of an ensemble: of a grid or list every result over the parameter with
the most values, or that of which the smallest is wanted, in a grid with a line for the
values of the others; of drawn values every result over each; with sampling Sobol the
indices."""

import numpy as np

from fsbi import plots

from . import statistics


def draw(ensemble, path):
    if ensemble.about.sampling == "Sobol":
        figure = _indices(ensemble)
    elif ensemble.about.drawn:
        figure = _scattered(ensemble)
    else:
        figure = _lines(ensemble)
    plots.save(figure, path)


def _numbers(texts):
    """Of texts; None unless all are numbers."""
    try:
        return [float(t) for t in texts]
    except ValueError:
        return None


def _axis(axes, parameter, texts):
    """Places of texts on the x axis, which is made for them."""
    places = _numbers(texts)
    if places is None:
        names = list(dict.fromkeys(parameter.texts))
        axes.set_xticks(range(len(names)), names)
        axes.set_xlim(-0.5, len(names) - 0.5)
        places = [names.index(t) for t in texts]
    elif parameter.logarithmic:
        plots.plain_logarithm(axes)
    axes.set_xlabel(parameter.name)
    return np.array(places, float)


def _label(ensemble, result):
    percent = f"{100 * ensemble.about.confidence:g} %"
    return f"probability of {result.name} (bars: {percent})" if result.yes_or_no() \
        else f"{result.name} (bars: {percent} of the mean)"


def _lines(ensemble):
    results = ensemble.results
    figure, axes = plots.plt.subplots(len(results), 1, squeeze=False,
                                      figsize=(6.4, 1 + 3.2 * len(results)))
    wanted = ensemble.about.smallest
    first = wanted.parameter if wanted else max(ensemble.about.parameters,
                                                key=lambda p: len(set(p.listed())))
    grid = ensemble.about.sampling == "grid"
    apart = [p for p in ensemble.about.parameters
             if grid and p is not first and len(set(p.listed())) > 1]
    found = list(ensemble.estimates())
    for i, result in enumerate(results):
        a = axes[i][0]
        places = _axis(a, first, [g.settings[first.name] for g in ensemble.groups])
        lines = {}
        for place, (group, _, values, estimate) in zip(places, found[i::len(results)]):
            name = ", ".join(f"{p.name} {group.settings[p.name]}" for p in apart)
            lines.setdefault(name, []).append((place, *estimate))
            if not result.yes_or_no():
                a.plot([place] * len(values), values, ".", color="#bbbbbb", ms=3.5, zorder=1)
        for j, (name, rows) in enumerate(lines.items()):
            x, y, low, high = np.array(sorted(rows)).T
            bars = np.nan_to_num([np.maximum(y - low, 0), np.maximum(high - y, 0)])
            a.errorbar(x, y, bars, capsize=3, label=name, color=plots.COLOURS[j % 6],
                       marker=plots.MARKERS[j % 6], mfc="white", lw=1, ls="-" if grid else "")
        a.set_ylabel(_label(ensemble, result))
        if result.yes_or_no():
            a.set_ylim(-0.05, 1.05)
        if wanted and result is wanted.result:
            _smallest(a, ensemble)
        if len(lines) > 1:
            a.legend()
    return figure


def _smallest(axes, ensemble):
    """The probability wanted, and where on it the parameter is, of every curve."""
    wanted = ensemble.about.smallest
    axes.axhline(wanted.probability, color=plots.INK, lw=0.8, ls=":")
    curves = wanted.curves(ensemble)
    for i, (rest, rows) in enumerate(curves):
        value, low, high = wanted.find(rest, rows)
        last = rows[-1][0]
        y = wanted.probability + 0.012 * (i - (len(curves) - 1) / 2)
        axes.plot([min(low, last), min(high, last)], [y, y], color=plots.COLOURS[i % 6], lw=4,
                  alpha=0.4, solid_capstyle="butt")
        if value < np.inf:
            axes.plot(value, y, "|", color=plots.COLOURS[i % 6], ms=9, mew=2)
    places = [p for p in wanted.places.values() if p > 0]
    if max(places, default=1) > 20 * min(places, default=1):
        axes.set_xscale("symlog", linthresh=min(places))


def _scattered(ensemble):
    parameters, results = ensemble.about.parameters, ensemble.results
    figure, axes = plots.plt.subplots(
        len(results), len(parameters), squeeze=False, sharey="row",
        figsize=(1 + 3.2 * len(parameters), 1 + 2.8 * len(results)))
    good = [m for m in ensemble.counting() if not m.failed]
    for i, result in enumerate(results):
        for a, parameter in zip(axes[i], parameters):
            x = _axis(a, parameter, [m.settings[parameter.name] for m in good])
            a.plot(x, [m.values[i] for m in good], plots.MARKERS[i % 6], mfc="none",
                   color=plots.COLOURS[i % 6], ms=4)
        axes[i][0].set_ylabel(result.name)
        if result.yes_or_no():
            axes[i][0].set_yticks([0, 1], ["no", "yes"])
    return figure


def _indices(ensemble):
    blocks, _ = ensemble.blocks()
    names = [p.name for p in ensemble.parameters]
    figure, axes = plots.plt.subplots(len(ensemble.results), 1, squeeze=False,
                                      figsize=(6.4, 1 + 3.2 * len(ensemble.results)))
    for i, result in enumerate(ensemble.results):
        a = axes[i][0]
        found = statistics.indices(blocks[:, :, i], ensemble.about.confidence)
        for side, label, (y, low, high) in ((-0.15, "first order", found[:3]),
                                            (0.15, "total", found[3:])):
            bars = np.nan_to_num([np.maximum(y - low, 0), np.maximum(high - y, 0)])
            a.errorbar(np.arange(len(names)) + side, y, bars, ls="", capsize=3, mfc="white",
                       marker="os"[side > 0], color=plots.COLOURS[side > 0], label=label)
        a.axhline(0, color=plots.INK, lw=0.8)
        a.set_xticks(range(len(names)), names)
        a.set(ylabel=f"part of the variance of {result.name}", xlim=(-0.6, len(names) - 0.4))
        a.legend()
    return figure
