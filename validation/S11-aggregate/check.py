# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the events of one and two processes and of a restart; count the
aggregates; write results.csv and draw."""

import glob
import math
import sys

import numpy as np

from fsbi import adhesion, plots
from fsbi.case import Case
from fsbi.results import Results

INTERVAL, SAMPLES, STOPPED = 30, 75, 0.1    # us; of the mean; of the first speed
WHAT = ("pair", "set", "site", "formed")
quick = sys.argv[1:2] == ["true"]
results = Results("S11")


def same_events():
    one, two, restarted = (Case(f"runs/{name}") for name in ("np1", "np2", "restarted"))
    events, others, later = (run.history["effects/bonds/events"]
                             for run in (one, two, restarted))
    cost = dict(seconds=one.seconds, cells=one.cells)
    # bound: an event picks one of about ten receptors in reach, so two runs that
    # have nothing in common agree on six with a probability of 1e-6
    results.at_least("events_compared", len(events), 6, **cost)
    different = max(len(events), len(others)) if len(events) != len(others) else sum(
        np.any([events[c] != others[c] for c in WHAT], axis=0))
    # bound: the same random numbers, so none
    results.add("different_events_np2_abs", different, 0, 0, **cost, procs=2)
    if not different:
        # bound: speeds solved to 1e-8 leave 1e-8 of the 0.6 um by which the gap
        # closes, 4e-6 thermal lengths: rates change by 1e-5 three thermal lengths
        # from rest, waiting times of 1e2 us by 1e-3 us
        results.add("instants_np2_abs", np.abs(events["instant"] - others["instant"]).max(),
                    0, 1e-3, **cost, procs=2)
    equal = np.array_equal(events.array, later.array)
    # bound: to the last bit
    results.add("restart_differs_abs", 0 if equal else 1, 0, 0, **cost)
    print(f"    {len(events)} events, {one.seconds:.0f} s")


def outcome(folder):
    """Start of the aggregate (nan: none), bonds at the end, the curves."""
    run = Case(folder)
    time, speed = adhesion.relative_speed(run.history, "tumourCell", "leukocyte", INTERVAL)
    mean = adhesion.moving_mean(speed, SAMPLES)
    bonds = run.history["effects/bonds/LFA1-ICAM1"]
    start = adhesion.aggregate_time(time, mean, STOPPED * speed[0])
    print(f"    {folder}: aggregate from {start:.0f} us, formed {bonds['formed'].sum():.0f}, "
          f"broken {bonds['broken'].sum():.0f}, slowest {1e3 * speed.min():.3f} mm/s, "
          f"{run.seconds:.0f} s")
    return run, start, bonds["number"][-1], time, speed, mean, bonds["formed"].sum()


def ensemble(correction):
    runs = [outcome(folder) for folder in sorted(glob.glob(f"runs/{correction}[0-9]"))]
    stuck = sum(not math.isnan(r[1]) for r in runs)
    low, high = adhesion.wilson(stuck, len(runs))
    print(f"    {correction}: {stuck} of {len(runs)} form an aggregate, "
          f"probability {low:.2f} to {high:.2f}; "
          f"{np.mean([r[6] for r in runs]):.1f} bonds formed")
    return runs, stuck, low, high


def rolls_over(runs):
    """Without bonds nothing is random: seeds must not matter."""
    rejected = 0
    for run, *_ in runs:
        with open(f"{run.folder}/log.fsbiFoam") as log:
            rejected += log.read().count("rejected:")
    # bound: repulsion is met where a step ends, so that no step ends beyond it; along its
    # tangent 37 of the quick form's did, 872 of the eight runs'
    results.add("rejected_rolling_over_abs", rejected, 0, 0)
    if len(runs) > 1:
        n = min(len(mean) for *_, mean, _ in runs)
        curves = np.array([mean[:n] for *_, mean, _ in runs])
        # bound: written after it was seen (1.4 %; 53 % along the tangent)
        results.add("spread_rolling_over_abs",
                    np.nanmax(np.ptp(curves, axis=0) / np.nanmean(curves, axis=0)), 0, 0.05)


def draw(groups):
    figure, (fast, much) = plots.plt.subplots(
        1, 2, figsize=(8.4, 4.2), width_ratios=(3, 1.2))
    for i, (name, (runs, stuck, low, high)) in enumerate(groups.items()):
        for k, (_, _, _, time, speed, mean, _) in enumerate(runs):
            fast.plot(1e-3 * time, 1e3 * mean, color=plots.COLOURS[i], lw=1.2,
                      label=f"{name}, {len(runs)} seeds" if k == 0 else None)
        p = stuck / len(runs)
        much.errorbar(i, p, [[p - low], [high - p]], color=plots.COLOURS[i], marker="o",
                      capsize=6)
    fast.set(xlabel="time (ms)", ylabel="relative speed (mm/s)", ylim=(0, None))
    fast.set_title(f"Mean of {SAMPLES} samples", loc="left")
    fast.legend(title="faceCorrection")
    much.set(xlim=(-0.6, 1.6), ylim=(-0.05, 1.05), xticks=range(len(groups)),
             xticklabels=list(groups))
    much.set_title("Aggregates, 95 %", loc="left")
    plots.save(figure, "aggregates.png")


def main():
    same_events()
    if quick:
        rolls_over([outcome("runs/none1")])
    else:
        groups = {name: ensemble(name) for name in ("global", "none")}
        draw(groups)
        for name, expected in (("global", 1), ("none", 0)):
            runs, stuck, low, high = groups[name]
            # bound: one run. In equilibrium `none` has 0.01 bonds by the table's rates,
            # so that two of eight runs with a bond have a probability of 0.003; with
            # `global` tens of receptors pass, and none binds in exp(-10) of runs
            results.add(f"aggregates_{name}_abs", stuck / len(runs), expected, 1 / len(runs),
                        seconds=sum(r[0].seconds for r in runs), cells=runs[0][0].cells)
        rolls_over(groups["none"][0])
    results.write()


if __name__ == "__main__":
    main()
