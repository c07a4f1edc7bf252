# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a study: error against seconds and against memory."""

import numpy as np

from fsbi import pictures, plots

TITLES = {"mesh": "mesh", "timeStep": "time step", "tolerance": "tolerance"}
SMALLEST = 1e-9             # errors of zero have no place on the axis


def draw(study, path, advice=None, accuracy=None, verified=None, title=""):
    figure, axes = plots.plt.subplots(1, 2, figsize=(10.4, 4.7), sharey=True,
                                      width_ratios=(1.45, 1))
    for a, cost, label in zip(axes, ("seconds", "megabytes"),
                              ("processor seconds", "most memory (MB)")):
        _panel(study, a, cost)
        a.set(xlabel=label, yscale="log")
        a.margins(0.08, 0.12)               # room for the values beside the points
        _scale(a, [v.record[cost] for v in study.variants if v.done()])
        a.grid(True, which="minor", axis="y", lw=0.3)
        a.yaxis.set_major_locator(plots.matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
        a.yaxis.set_minor_formatter(plots.matplotlib.ticker.NullFormatter())
        a.yaxis.set_major_formatter(lambda y, _: f"{100 * y:g} %")
    _label(study, axes[0])
    _marks(study, axes, advice, accuracy, verified)
    names = ", ".join(dict.fromkeys(q.label for q in study.quantities))
    several = ", the largest of them" if len(study.quantities) > 1 else ""
    axes[0].set_ylabel("error" + several)
    figure.suptitle(title or f"What accuracy costs: {names}", x=0.01, ha="left", fontsize=12.5)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncols=min(4, len(labels)),
                  fontsize=9.5, frameon=False)
    rows = -(-len(labels) // 4)
    figure.tight_layout(rect=(0, 0.045 + 0.04 * rows, 1, 1))
    pictures.save(figure, path)
    print(f"    {path}")


def _scale(axes, costs):
    """Logarithmic where it matters, with plain numbers at 1, 2, 5."""
    if max(costs) < 4 * min(costs):
        axes.set_xlim(left=0)
        axes.ticklabel_format(axis="x", style="plain")
        return
    plots.plain_logarithm(axes)


def _xy(variants, cost):
    return ([v.record[cost] for v in variants],
            [max(v.error, SMALLEST) for v in variants])


def _panel(study, axes, cost):
    front = study.pareto(cost)
    axes.step(*_xy(front, cost), where="post", color="#bbbbbb", lw=5, alpha=0.55,
              solid_capstyle="round", zorder=1, label="best of the runs")
    for i, parameter in enumerate(study.parameters):
        ran = study.of_parameter(parameter)
        axes.plot(*_xy(ran, cost), color=plots.COLOURS[i % 6], marker=plots.MARKERS[i % 6],
                  mfc="white", mew=1.5, ms=6.5, ls="-" if parameter.numeric() else ":",
                  label=TITLES.get(parameter.name, parameter.name), zorder=3)
    base = study.variants[0]
    axes.plot(*_xy([base], cost), ls="none", marker="o", ms=9, color=plots.INK,
              label="the case as it is", zorder=4)


def _label(study, axes):
    """Values beside the points; those at the ends of a parameter only if many, and
    none on the base's point."""
    base = np.log(np.ravel(_xy([study.variants[0]], "seconds")))
    for i, parameter in enumerate(study.parameters):
        ran = [v for v in study.of_parameter(parameter) if v.parameter]
        shown = ran if len(ran) < 7 else [ran[0], ran[-1]]
        for v in shown:
            x, y = _xy([v], "seconds")
            if np.abs(np.log([x[0], y[0]]) - base).max() < 0.1:
                continue
            text = v.settings[parameter.name]
            text = f"×{float(text):g}" if parameter.name in TITLES else text[:18]
            axes.annotate(text, (x[0], y[0]), (5, 6 if i % 2 == 0 else -12),
                          textcoords="offset points", fontsize=8.5,
                          color=plots.COLOURS[i % 6])


def _marks(study, axes, advice, accuracy, verified):
    unsure = study.uncertainty()
    low = min(a.get_ylim()[0] for a in axes)
    for a in axes:
        # below, errors cannot be told
        if all(r is None for r in study.references) and unsure > 0:
            a.axhspan(min(low, unsure) * 0.2, unsure, color="#f3f3f3", zorder=0, lw=0,
                      label="below the estimate's uncertainty")
        if accuracy:
            a.axhline(accuracy, color=plots.INK, lw=0.9, ls=(0, (5, 4)), zorder=1,
                      label=f"wanted: {100 * accuracy:g} %")
        a.set_ylim(bottom=low)
    if advice:
        kw = dict(marker="*", ms=16, mec=plots.COLOURS[1], mew=1.5, ls="none", zorder=5)
        if verified is not None and verified.done():
            for a, cost in zip(axes, ("seconds", "megabytes")):
                a.plot(*_xy([verified], cost), mfc=plots.COLOURS[4],
                       label="recommended, run", **kw)
        else:
            for a, x in zip(axes, (advice.seconds, advice.megabytes)):
                a.plot([x], [advice.error], mfc="none", label="recommended, predicted", **kw)
