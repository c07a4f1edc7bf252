# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One look for all curves: legible, colour-blind safe, small files.

    from fsbi import plots

    plots.curves(
        "velocity.png",
        [("fsbiFoam", t, u)],
        theory=[("exact law", tExact, uExact)],
        xlabel="time (µs)", ylabel="velocity (µm/µs)", title="...",
    )
    orders = plots.convergence("order.png", h, {"velocity": errors}, order=2)
"""

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

from . import pictures
from .convergence import orders as observed

matplotlib.use("Agg")           # no display is needed

# Okabe and Ito's colours without the yellow; markers tell the lines apart, too
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
THEORY = ["-", "--", ":", "-."]
INK = "#333333"

STYLE = {
    "figure.figsize": (6.4, 4.2),
    "figure.dpi": 130,
    "font.size": 11,
    "axes.titlesize": 11.5,
    "axes.labelsize": 11,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlepad": 10,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "legend.fontsize": 10,
    "lines.linewidth": 1.8,
    "lines.markersize": 5.5,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
    "axes.formatter.limits": (-3, 4),
    "axes.formatter.use_mathtext": True,
}
plt.rcParams.update(STYLE)


def save(figure, path):
    """Write a PNG of at most 150 kB and close the figure."""
    figure.tight_layout()
    pictures.save(figure, path)
    print(f"    {path}")


def curves(path, computed, theory=(), xlabel="", ylabel="", title="",
           xlog=False, ylog=False, ylow=None, note=""):
    """Computed curves with markers over theory as thin black lines.

    computed and theory are lists of (label, x, y); returns nothing.
    """
    figure, axes = plt.subplots()
    for i, (label, x, y) in enumerate(theory):
        axes.plot(x, y, THEORY[i % 4], color="black", lw=1.2, label=label,
                  zorder=3)
    for i, (label, x, y) in enumerate(computed):
        every = max(1, len(np.atleast_1d(x)) // 18)
        axes.plot(x, y, color=COLOURS[i % 6], marker=MARKERS[i % 6],
                  markevery=every, mfc="white", mew=1.4, label=label,
                  alpha=0.9)
    if xlog:
        axes.set_xscale("log")
    if ylog:
        axes.set_yscale("log")
    if ylow is not None:
        axes.set_ylim(ylow, 1.1 * axes.get_ylim()[1])
    _finish(figure, axes, xlabel, ylabel, title, note)
    save(figure, path)


def _finish(figure, axes, xlabel, ylabel, title, note=""):
    axes.set(xlabel=xlabel, ylabel=ylabel)
    axes.set_title(title, loc="left")
    if note:
        axes.set_title(note, loc="right", fontsize=9, color="#666666")
    entries = len(axes.get_legend_handles_labels()[1])
    if entries > 2:      # no room among the curves
        axes.legend(fontsize=9, ncol=2, loc="upper center",
                    bbox_to_anchor=(0.5, -0.15 - 0.01 * entries))
    elif entries:
        axes.legend()


def plain_logarithm(axes):
    """A logarithmic x axis with plain numbers at 1, 2, 5."""
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(lambda x, _: f"{x:g}")
    axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


class _PlainNumbers(matplotlib.ticker.LogFormatter):
    """0.04 on a logarithmic axis, not 4e-02."""

    def _num_to_string(self, x, vmin, vmax):
        return f"{x:g}"


def convergence(path, h, errors, order=2, xlabel="cell size (µm)",
                ylabel="relative error", title=""):
    """Errors over size in a log-log plot with a triangle of the expected
    order; the observed order of the finest pair stands in the legend.

    errors: a dict label -> values, or (h, values) where the sizes differ.
    Returns a dict label -> observed orders, from coarse to fine.
    """
    figure, axes = plt.subplots()
    orders = {}
    lowest = None
    for i, (label, values) in enumerate(errors.items()):
        sizes, values = values if isinstance(values, tuple) else (h, values)
        index = np.argsort(sizes)[::-1]
        sizes = np.asarray(sizes, float)[index]
        values = np.asarray(values, float)[index]
        orders[label] = observed(sizes, values)
        axes.loglog(sizes, values, color=COLOURS[i % 6], marker=MARKERS[i % 6],
                    mfc="white", mew=1.4,
                    label=f"{label}: order {orders[label][-1]:.2f}")
        if lowest is None or values[-1] < lowest[1][-1]:
            lowest = (sizes, values)
    sizes, values = lowest
    guide = 0.6 * values[-1] * (sizes / sizes[-1]) ** order
    axes.loglog(sizes, guide, color="black", lw=1, ls="--",
                label=f"slope {order:g}")
    axes.xaxis.set_major_formatter(_PlainNumbers(labelOnlyBase=False))
    axes.xaxis.set_minor_formatter(_PlainNumbers(minor_thresholds=(2, 0.6)))
    axes.grid(True, which="minor", lw=0.3)
    _finish(figure, axes, xlabel, ylabel, title)
    save(figure, path)
    return orders
