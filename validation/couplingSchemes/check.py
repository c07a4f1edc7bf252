# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the coupling schemes with the monolithic one; write results.csv and
draw passes and seconds per step."""

import glob
import os
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

quick = sys.argv[1] == "true"
SCHEMES = ["monolithic", "IQNILS", "Aitken", "semiImplicit", "explicit"]


REASONS = "diverges|do not agree|reached a residual|turned inside out|not finite"


class Run(Case):
    def __init__(self, folder):
        super().__init__(folder)
        self.scheme, self.ratio = name_of(folder)
        self.passes = self.history["cost"]["corrections"]
        self.axes = self.history["elasticBodies/cell/semiAxes"].array[-1, 1:]


def name_of(folder):
    scheme, ratio = os.path.basename(folder).split(".", 1)
    return scheme, float(ratio)


def refusal(folder):
    """What a run says that could not make its steps; empty if it did."""
    with open(f"{folder}/log.fsbiFoam") as log:
        return "".join(re.findall(r"FATAL ERROR:\s*(.*)", log.read()))


def compare(runs, refused):
    results = Results("couplingSchemes")
    same = {run.ratio: run.axes for run in runs if run.scheme == "monolithic"}
    for run in runs:
        cost = dict(seconds=run.seconds, cells=run.cells)
        name = f"{run.scheme}_r{run.ratio:g}"
        print(f"    {name}: passes {run.passes}, {run.seconds:.2f} s")
        if run.scheme == "monolithic":
            results.add(f"corrections_{name}_abs", run.passes.max(), 0, 5, **cost)
        else:
            difference = np.abs(run.axes / same[run.ratio] - 1).max()
            # one pass a step leaves what is not solved
            bound = 0.1 if run.scheme == "explicit" else 1e-4
            results.add(f"axes_{name}_abs", difference, 0, bound, **cost)
    for folder, reason in refused.items():
        scheme, ratio = name_of(folder)
        print(f"    {scheme}_r{ratio:g}: {reason[:150]}")
        results.at_least(f"{scheme}_r{ratio:g}_says_why",
                         bool(re.search(REASONS, reason)), 1)
    results.write()


def draw(runs, refused):
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(8.4, 3.6))
    for i, scheme in enumerate(SCHEMES):
        these = sorted((r for r in runs if r.scheme == scheme),
                       key=lambda r: r.ratio)
        style = dict(color=plots.COLOURS[i], marker=plots.MARKERS[i], label=scheme)
        ratios = [r.ratio for r in these]
        left.loglog(ratios, [r.passes.mean() for r in these], **style)
        right.loglog(ratios, [r.solve_seconds / len(r.passes) for r in these],
                     **style)
        failed = [name_of(f)[1] for f in refused if name_of(f)[0] == scheme]
        for axes, top in ((left, 100), (right, 15)):
            axes.plot(failed, [top * 1.25**i] * len(failed), color=plots.COLOURS[i],
                      marker="x", ls="none", mew=2)
    left.plot([], [], color="grey", marker="x", ls="none", mew=2, label="no solution")
    left.set(xlabel="µ/(G Δt)", ylabel="passes (Newton's corrections) a step")
    right.set(xlabel="µ/(G Δt)", ylabel="seconds a step, solvers")
    left.legend(fontsize=8, loc="upper left")
    plots.save(figure, "passes.png")


folders = sorted(glob.glob("runs/*.*"))
refused = {folder: refusal(folder) for folder in folders if refusal(folder)}
runs = [Run(folder) for folder in folders if folder not in refused]
compare(runs, refused)
if not quick:
    draw(runs, refused)
