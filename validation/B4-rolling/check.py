# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean speed, pauses and bonds over the seeds: slower than without bonds, and
the same on a finer mesh and with shorter steps; write results.csv and draw."""

import glob
import sys

import numpy as np

from fsbi import adhesion, plots
from fsbi.case import Case
from fsbi.results import Results

BODIES = ("rigid", "elastic")
CAUGHT, WINDOW = 8000, 2000        # us: from when on; over which a speed is taken
MEASURES = ("speed", "pauses", "bonds")
# bound: two means of independent seeds differ by more than three standard
# errors in one of 140 comparisons by chance (Student, 14 degrees of freedom)
SIGMAS = 3
quick = sys.argv[1:2] == ["true"]
results = Results("B4")


def path(run, body):
    table = run.history["bodies/leukocyte/position" if body == "rigid"
                        else "elasticBodies/leukocyte/centre"]
    return table["time"], table["x"]


def free_speed(body):
    time, x = path(Case(f"runs/{body}_free"), body)
    return (x[-1] - x[0]) / (time[-1] - time[0])


def measures(run, body, free):
    """Speed over that without bonds, part of the time in pauses, bonds"""
    time, x = path(run, body)
    caught = time >= CAUGHT if not quick else time >= 0
    motion = adhesion.rolling(time[caught], x[caught], free, WINDOW)
    bonds = run.history["effects/bonds/selectin"]
    later = bonds["time"] >= time[caught][0]
    number = np.trapz(bonds["number"][later], bonds["time"][later])
    return (motion.mean / free, motion.pause_fraction,
            number / np.ptp(bonds["time"][later])), motion


def seeds(body, variant, free):
    runs = [Case(folder) for folder in sorted(glob.glob(f"runs/{body}_{variant}_*"))]
    values = np.array([measures(run, body, free)[0] for run in runs])
    cost = dict(seconds=sum(run.seconds for run in runs), cells=runs[0].cells)
    return runs, values, cost


def standard_error(values):
    return values.std(axis=0, ddof=1) / np.sqrt(len(values))


def compare(body, free):
    _, base, cost = seeds(body, "base", free)
    # bound: the issue's, eight seeds
    results.at_least(f"{body}_seeds", len(base), 8, **cost)
    mean, error = base.mean(axis=0), standard_error(base)
    print(f"    {body}: " + ", ".join(
        f"{name} {m:.3g} +- {e:.2g}" for name, m, e in zip(MEASURES, mean, error)))
    # bound: cases table: bonds hold back, so that it is slower than free, and
    # that by more than chance
    results.add(f"{body}_speed_and_three_errors_abs", mean[0] + SIGMAS * error[0], 0, 1,
                **cost)
    for variant in ("mesh", "step"):
        _, other, cost = seeds(body, variant, free)
        apart = np.hypot(error, standard_error(other))
        for i, name in enumerate(MEASURES):
            difference = other.mean(axis=0)[i] - mean[i]
            if difference:      # no run paused, neither here nor there
                difference /= apart[i]
            results.add(f"{body}_{name}_by_{variant}_in_errors_abs", abs(difference), 0,
                        SIGMAS, **cost)
            print(f"        {variant}: {name} {other.mean(axis=0)[i]:.3g}, "
                  f"{difference:+.1f} standard errors")
    return base


def draw(free):
    figure, axes = plots.plt.subplots(2, 2, figsize=(8.4, 6), sharex="col",
                                      width_ratios=(3, 1.4))
    for row, body in zip(axes, BODIES):
        for folder in sorted(glob.glob(f"runs/{body}_base_*")):
            time, x = path(Case(folder), body)
            row[0].plot(1e-3 * time, x - x[0], color=plots.COLOURS[0], lw=1)
        row[0].plot(1e-3 * time, free[body] * time, color="black", ls="--", lw=1.2,
                    label="without bonds")
        row[0].set(ylabel="way (µm)", ylim=(0, 9))
        row[0].set_title(f"{body} leukocyte, eight seeds", loc="left")
        row[0].legend(loc="upper left")
        for k, variant in enumerate(("base", "mesh", "step")):
            _, values, _ = seeds(body, variant, free[body])
            row[1].plot([k] * len(values), values[:, 0], ls="none", marker="o", ms=4,
                        mfc="white", color=plots.COLOURS[k])
            row[1].errorbar(k + 0.25, values[:, 0].mean(), standard_error(values)[0],
                            color=plots.COLOURS[k], marker="s", capsize=5)
        row[1].set(ylabel="speed / that without bonds", ylim=(0, 1.1), xlim=(-0.5, 2.7),
                   xticks=range(3), xticklabels=("base", "finer\nmesh", "shorter\nsteps"))
    axes[1, 0].set(xlabel="time (ms)")
    plots.save(figure, "rolling.png")


def main():
    if quick:
        free = free_speed("rigid")
        run = Case("runs/rigid_base_1")
        (speed, _, number), motion = measures(run, "rigid", free)
        cost = dict(seconds=run.seconds, cells=run.cells)
        # bound: bonds can only hold back; the gap and so the speed without bonds
        # vary by a few per cent (Goldman: by 2 % from a gap of 0.09 to 0.07 radii)
        results.add("rigid_fastest_over_free_abs", motion.speed.max() / free, 0, 1.05, **cost)
        results.at_least("rigid_bonds", number, 1, **cost)
    else:
        free = {body: free_speed(body) for body in BODIES}
        for body in BODIES:
            compare(body, free[body])
        draw(free)
    results.write()


if __name__ == "__main__":
    main()
