# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""table.csv, summary.csv and sensitivities.csv of an ensemble, and what is printed."""

import csv
import os

import numpy as np

from . import statistics


def write(ensemble):
    folder = ensemble.bench.folder
    table(ensemble, os.path.join(folder, "table.csv"))
    summary(ensemble, os.path.join(folder, "summary.csv"))
    if ensemble.about.smallest:
        smallest(ensemble, os.path.join(folder, "smallest.csv"))
    _tell_failures(ensemble)
    if ensemble.about.sampling == "Sobol":
        sensitivities(ensemble, os.path.join(folder, "sensitivities.csv"))


def write_table(path, header, rows):
    with open(path + ".part", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([header, *rows])
    os.replace(path + ".part", path)


def table(ensemble, path):
    """A row a run that counts, also if it failed."""
    parameters = [p.name for p in ensemble.parameters]
    header = ["run", *parameters, *(r.name for r in ensemble.results), "failed"]
    empty = [""] * len(ensemble.results)
    write_table(path, header, [
        [m.number, *(m.settings[p] for p in parameters),
         *(empty if m.failed else [f"{v:.10g}" for v in m.values]), m.failed or ""]
        for m in ensemble.counting()])


def summary(ensemble, path):
    """Of every group and result; printed, too."""
    names = list(ensemble.groups[0].settings)
    rows = []
    for group, result, values, (value, low, high) in ensemble.estimates():
        failed = sum(bool(m.failed) for m in group.counting())
        rows.append([*(group.settings[n] for n in names), result.name,
                     "probability" if result.yes_or_no() else "mean", len(values), failed,
                     *(f"{v:.10g}" for v in (value, low, high))])
        print("    " + sentence(ensemble, group, result, values, (value, low, high)))
    write_table(path, [*names, "quantity", "what", "runs", "failed", "value", "low", "high"], rows)


def sentence(ensemble, group, result, values, estimate):
    value, low, high = estimate
    head = ", ".join(f"{k} {v}" for k, v in group.settings.items())
    head = (head + ": " if head else "") + result.name
    if not len(values):
        return f"{head}: no run ended well"
    if result.yes_or_no():
        text = f"{head} in {sum(values):.0f} of {len(values)} runs, probability {value:.3g}"
    else:
        text = f"{head} {value:.5g}, mean of {len(values)} run{'s'[:len(values) > 1]}"
    band = f" ({low:.3g} to {high:.3g})" if low == low else ""
    left = len(group.members) - len(group.counting())
    return text + band + (f"; {left} more were not needed" if left else "")


def smallest(ensemble, path):
    """Of every curve; printed, too."""
    about = ensemble.about
    wanted, rows = about.smallest, []
    for rest, points in wanted.curves(ensemble):
        found = wanted.find(rest, points)
        rows.append([*rest.values(), wanted.result.name, wanted.side, f"{wanted.probability:g}",
                     *(f"{v:.10g}" for v in found)])
        head = ", ".join(f"{k} {v}" for k, v in rest.items())
        print(f"    {head + ': ' if head else ''}{_least(wanted, found, points)}")
    names = list(rest) if rows else []
    write_table(path, [*names, "quantity", "side", "probability", wanted.name, "low", "high"],
                rows)


def _least(wanted, found, points):
    what = f"{wanted.name} for a probability of {wanted.result.name} {wanted.side} " \
        f"{wanted.probability:g}"
    last = f"{points[-1][0]:g}"
    low = f"{found.low:.3g}" if found.low < np.inf else last
    high = f"{found.high:.3g}" if found.high < np.inf else f"more than {last}, the largest run"
    if found.value == np.inf:
        return f"smallest {what}: more than {last}, the largest run (at least {low})"
    return f"smallest {what}: {found.value:.3g} ({low} to {high})"


def _tell_failures(ensemble):
    failed = [m for m in ensemble.counting() if m.failed]
    if failed:
        print(f"    {len(failed)} of {len(ensemble.counting())} runs failed, see table.csv; "
              f"the first, run {failed[0].number} ({failed[0].name()}): {failed[0].failed}")


def sensitivities(ensemble, path):
    blocks, broken = ensemble.blocks()
    if broken:
        print(f"    {broken} samples with a run that failed are left out of the sensitivities")
    rows = []
    for i, result in enumerate(ensemble.results):
        found = statistics.indices(blocks[:, :, i], ensemble.about.confidence)
        for p, row in zip(ensemble.parameters, zip(*found)):
            rows.append([result.name, p.name, *(f"{v:.6g}" for v in row)])
            print(f"    {result.name}, {p.name}: first-order index {row[0]:.2f} ({row[1]:.2f} to "
                  f"{row[2]:.2f}), total {row[3]:.2f} ({row[4]:.2f} to {row[5]:.2f})")
    write_table(path, ["quantity", "parameter", "first", "firstLow", "firstHigh", "total",
                       "totalLow", "totalHigh"], rows)
