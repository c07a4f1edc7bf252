# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs by tables of resistances against full runs and exact flow: results.csv,
reduced.png."""

import os
import re

import numpy as np
from scipy.integrate import solve_ivp

from fsbi import plots
from fsbi.bispherical import wall
from fsbi.case import Case
from fsbi.results import Results

RADIUS, FORCE, HEIGHT = 4, 0.075, 8     # of the sphere that sinks
results = Results("A7")


def path_error(run, full):
    """Largest distance of two paths at a time, over the length of the second."""
    x, y = run.position("a"), full.position("a")
    return (np.linalg.norm(x - y, axis=1).max()
            / np.linalg.norm(np.diff(y, axis=0), axis=1).sum())


def axis(run):
    """Of the body, its own x, over time."""
    w, x, y, z = run.history["bodies/a/orientation"].array[:, 1:].T
    return np.array([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]).T


def turn_error(run, full):
    """Largest angle between the axes [rad]; the accuracy of small ones by the sine."""
    return np.linalg.norm(np.cross(axis(run), axis(full)), axis=1).max()


def checks(folder):
    """Differences of velocity that full solutions told."""
    with open(os.path.join(folder, "log.fsbiFoam")) as log:
        return [float(v) / 100 for v in
                re.findall(r"^Check: a full solution differs by (\S+) %", log.read(), re.M)]


def compare(name):
    full, short, fine = (Case(f"runs/{name}{part}") for part in ("", ".reduced", ".fine"))
    # bound: issue 22 asks for 1 % of the path
    results.add("path_error_abs", path_error(short, full), 0, 0.01, variant=name,
                seconds=full.seconds, cells=full.cells)
    if name == "ellipsoid":
        # bound: as much of a radian
        results.add("axis_error_abs", turn_error(short, full), 0, 0.01, variant=name)
    told = checks(f"runs/{name}.checked")
    # bound: that of the path, in velocity
    results.add("largest_check_abs", max(told), 0, 0.01, variant=name)
    # bound: issue 22 asks for 1000. Processor's seconds a step, with the start: both runs
    # cover the same time, the second one in a hundred times as many steps
    a_step = [run.processor_seconds / len(run.time()) for run in (full, fine)]
    results.at_least("seconds_a_step_ratio", a_step[0] / a_step[1], 1000, variant=name,
                     seconds=fine.seconds)
    print(f"    {name}: {1e3 * a_step[0]:.0f} ms a step in full, {1e3 * a_step[1]:.2f} by the "
          f"table, whole runs of equal steps {full.seconds:.1f} and {short.seconds:.2f} s; "
          f"{len(told)} checks")
    return full, short


def sinks():
    """Gap over time, exactly and by a table."""
    run = Case("runs/sinking")
    times, gap = run.time(), run.position("a")[:, 1] / RADIUS - 1
    speed = FORCE / (6 * np.pi * RADIUS)
    exact = solve_ivp(lambda t, g: [-speed / RADIUS / wall(g[0])], (0, times[-1]),
                      [HEIGHT / RADIUS - 1], t_eval=times, rtol=1e-9, atol=1e-12).y[0]
    # bound: the project's 2 % of forces in gaps (N1)
    results.add("exact_sinking_abs", np.abs(gap - exact).max() / (exact[0] - exact[-1]),
                0, 0.02, variant=f"gap {exact[0]:.2g} to {exact[-1]:.2g} radii",
                seconds=run.seconds)
    return times, gap, exact


def rolls():
    """Mean speeds of the same seeds."""
    seeds = sorted({int(n[len("rolling"):]) for n in os.listdir("runs")
                    if re.fullmatch(r"rolling\d+", n)})
    runs = {part: [Case(f"runs/rolling{s}{part}") for s in seeds] for part in ("", ".reduced")}
    full, short = ([(r.position("leukocyte")[-1, 0] - r.position("leukocyte")[0, 0])
                    / (r.time()[-1] - r.time()[0]) for r in runs[p]] for p in ("", ".reduced"))
    print("    speeds, in full and by the table:",
          *(f"{1e3 * a:.2f} {1e3 * b:.2f}," for a, b in zip(full, short)))
    # bound: issue 22 asks for 5 % of the mean speed
    results.add("rolling_speed", np.mean(short), np.mean(full), 0.05,
                variant=f"{len(seeds)} seeds")
    # bound: issue 22 asks for 100, of whole runs in processor's seconds
    cost = [sum(r.processor_seconds for r in runs[p]) for p in ("", ".reduced")]
    results.at_least("seconds_ratio_bonds", cost[0] / cost[1], 100, seconds=cost[1])


def draw(pairs, sunk):
    figure, axes = plots.plt.subplots(1, 2, figsize=(9, 3.8))
    for i, (name, (full, short)) in enumerate(pairs.items()):
        for run, style in ((full, dict(marker="o", ls="", mfc="white", markevery=6)),
                           (short, dict(ls="-", label=name))):
            x = run.position("a")
            axes[0].plot(x[:, 0], x[:, 1], color=plots.COLOURS[i], **style)
    axes[0].set(xlabel="x (um)", ylabel="y (um)", title="by the table, and in full (circles)")
    axes[0].legend()
    if sunk:
        times, gap, exact = sunk
        axes[1].plot(times, exact, color="0.7", lw=4, label="exact")
        axes[1].plot(times, gap, color=plots.COLOURS[0], label="by the table")
        axes[1].set(xlabel="time (us)", ylabel="gap (radii)")
        axes[1].legend()
    plots.save(figure, "reduced.png")


def main():
    names = [n for n in ("rest", "shear", "ellipsoid") if os.path.isdir(f"runs/{n}")]
    pairs = {name: compare(name) for name in names}
    sunk = sinks() if os.path.isdir("runs/sinking") else None
    if os.path.isdir("runs/rolling1"):
        rolls()
    if sunk:
        draw(pairs, sunk)
    results.write()


if __name__ == "__main__":
    main()
