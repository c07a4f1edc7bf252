# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways of all runs, mean speeds with their intervals and pauses by the density of
selectin; one of the runs beside the same in full."""

import csv
import glob
import json
import os

import numpy as np

from fsbi import adhesion, plots
from fsbi.history import History

WINDOW = 2000           # us, over which a velocity is taken
START = 20000           # us, when it has been caught
SAME = ("100", "1")     # density and seed of the run in full


def way(folder):
    """Times and way along the wall."""
    x = History(f"{folder}/postProcessing/history.h5")["bodies/leukocyte/position"]
    return x["time"], x["x"] - x["x"][0]


def runs():
    """{(density, seed): (time, way, seconds)} of the ensemble."""
    found = {}
    for path in glob.glob("runs/densities/ensemble/runs/*/run.json"):
        with open(path) as file:
            record = json.load(file)
        key = record["settings"]["density"], record["settings"]["seed"]
        found[key] = (*way(os.path.dirname(path)), record["seconds"])
    return found


def speeds():
    """Rows of summary.csv for the speed."""
    with open("runs/densities/ensemble/summary.csv", newline="") as file:
        return [r for r in csv.DictReader(file) if r["quantity"] == "speed"]


def pauses(all_runs, density, free):
    """Parts of the time in pauses, of the runs of a density."""
    parts = []
    for (at, _), (time, x, _) in all_runs.items():
        if at == density:
            rolls = time >= START
            parts.append(adhesion.rolling(time[rolls], x[rolls], free, WINDOW).pause_fraction)
    return np.array(parts)


def paths(axes, all_runs, densities, full):
    for i, density in enumerate(densities):
        mine = [v for (at, _), v in sorted(all_runs.items()) if at == density]
        for j, (time, x, _) in enumerate(mine):
            axes.plot(1e-3 * time, x, color=plots.COLOURS[i % 6], lw=0.7, alpha=0.6,
                      label=density if j == 0 else None)
    axes.plot(1e-3 * full[0], full[1], "k--", lw=1.4, label="one in full")
    axes.set(xlabel="time (ms)", ylabel="way (µm)")
    axes.set_title("Ways on so many P-selectin per µm²", loc="left")
    axes.legend(fontsize=9)


def means(axes, rows, held, free):
    x = np.array([float(r["density"]) for r in rows])
    value, low, high = (1e3 * np.array([float(r[w]) for r in rows])
                        for w in ("value", "low", "high"))
    axes.errorbar(x, value, [value - low, high - value], marker="o", mfc="white", lw=1,
                  capsize=3, color=plots.COLOURS[0], label="mean speed (mm/s), 95 %")
    axes.axhline(1e3 * free, color="black", lw=1.2, ls="--", label="without bonds")
    axes.plot(x, [p.mean() for p in held], marker="s", mfc="white", lw=1, ls=":",
              color=plots.COLOURS[1], label="part of the time in pauses")
    axes.set(xlabel="P-selectin (1/µm²)", ylabel="mm/s, and part of the time",
             xscale="log", ylim=(0, None))
    axes.set_xticks(x, [f"{v:g}" for v in x])
    axes.minorticks_off()
    axes.legend(fontsize=9)


def main():
    found, rows = runs(), speeds()
    densities = [r["density"] for r in rows]
    free = History("runs/free/postProcessing/history.h5")["bodies/leukocyte/velocity"]["x"][-1]
    held = [pauses(found, d, free) for d in densities]
    full = way("runs/full")
    figure, (where, fast) = plots.plt.subplots(1, 2, figsize=(9, 4))
    paths(where, found, densities, full)
    means(fast, rows, held, free)
    plots.save(figure, "densities.png")
    for row, parts in zip(rows, held):
        low, high = (1e3 * float(row[w]) for w in ("low", "high"))
        print(f"    {row['density']} per um2: {1e3 * float(row['value']):.3f} mm/s "
              f"({low:.3f} to {high:.3f}), in pauses for {100 * parts.mean():.0f} % of the time")
    time, x, _ = found[SAME]
    most = np.abs(np.interp(full[0], time, x) - full[1]).max()
    print(f"    without bonds {1e3 * free:.3f} mm/s; {len(found)} runs by the table took "
          f"{sum(v[2] for v in found.values()):.0f} s of processor; seed {SAME[1]} at "
          f"{SAME[0]} is within {most:.3f} um of its run in full ({full[1][-1]:.2f} um)")


main()
