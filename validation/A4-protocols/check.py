# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""First bonds, dose curves and smallest doses against exact.py; results.csv,
protocols.png. Eight kinds of receptors that know nothing of each other are eight
studies."""

import csv
import glob
import json
import math
import os

import numpy as np

import exact
import scene
from fsbi import adhesion, plots
from fsbi.history import History
from fsbi.results import Results

PATIENTS = {"whole": scene.DENSITY, "half": scene.DENSITY / 2}
WANTED = 0.5
DRAWN = 10000           # studies, for the bounds
KINDS = range(1, scene.KINDS + 1)


def first_bonds(study):
    """By patient, of every run without a drug and every kind."""
    found = {}
    for path in glob.glob(f"runs/{study}/ensemble/runs/*/run.json"):
        with open(path) as file:
            settings = json.load(file)["settings"]
        if float(settings["dose"]) != 0:
            continue
        events = History(path.replace("run.json", "postProcessing/history.h5"))[
            "effects/bonds/events"]
        for pair in range(scene.KINDS):
            mine = events["instant"][events["pair"] == pair]
            found.setdefault(settings["patient"], []).append(
                min(mine.min(initial=scene.END), scene.END))
    return {patient: np.array(times) for patient, times in found.items()}


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def bonds():
    """(patient, dose): of every seed, whether each kind has a bond."""
    found = {}
    for row in rows("runs/doses/ensemble/table.csv"):
        found.setdefault((row["patient"], float(row["dose"])), []).append(
            [float(row[f"bond{i}"]) for i in KINDS])
    return {key: np.array(values) for key, values in found.items()}


def covered(happened, n, p):
    low, high = adhesion.wilson(happened, n)
    return low <= p <= high


def drawn_misses(probabilities, n):
    """Bands that miss, of DRAWN studies. Seeds are the same at all doses, so that what
    happens at one tells of the others: either as much as it can, or nothing."""
    random = np.random.default_rng(1)
    hit = np.array([[covered(h, n, p) for h in range(n + 1)] for p in probabilities])
    worst = 0
    for shape in ((scene.KINDS, 1, n), (scene.KINDS, len(probabilities), n)):
        misses = []
        for _ in range(DRAWN):
            happened = (random.random(shape) < np.array(probabilities)[None, :, None]).sum(axis=2)
            misses.append(sum((~hit[j][happened[:, j]]).sum()
                              for j in range(len(probabilities))))
        mean = np.mean(misses)
        worst = max(worst, np.quantile(np.abs(misses - mean), 0.997))
    return mean, worst


def check_times(results):
    found = first_bonds("waiting")
    means = {}
    for patient, density in PATIENTS.items():
        times = found[patient]
        means[patient] = times.mean()
        # bound: 3 standard errors of an exponential's mean
        results.add("first_bond_time", times.mean(), reference=exact.mean_time(density),
                    bound=3 / math.sqrt(len(times)), variant=patient)
    # bound: the same of a quotient; rates are one over the means, and halve
    results.add("first_bond_rate_ratio", means["whole"] / means["half"],
                reference=exact.mean_time(PATIENTS["whole"]) / exact.mean_time(PATIENTS["half"]),
                bound=3 * math.sqrt(2 / len(times)))


def check_bands(results, found):
    n = len(next(iter(found.values())))
    exactly = [exact.bond(PATIENTS[patient], dose) for patient, dose in found]
    misses = sum(not covered(int(values[:, k].sum()), n, p)
                 for values, p in zip(found.values(), exactly) for k in range(scene.KINDS))
    # bound: what 99.7 % of drawn studies are within, of their mean
    mean, bound = drawn_misses(exactly, n)
    results.add("bands_that_miss_abs", misses, reference=mean, bound=bound)
    results.add("bands_abs", len(found) * scene.KINDS,
                reference=len(found) * scene.KINDS, bound=0)


def check_smallest(results, n):
    found = {}
    for i in KINDS:
        for row in rows(f"runs/smallest{i}.csv"):
            found.setdefault(row["patient"], []).append(
                [float(row[word]) for word in ("dose", "low", "high")])
    misses = 0
    for patient, several in found.items():
        density = PATIENTS[patient]
        truth = exact.smallest(density, WANTED)
        misses += sum(not low <= truth <= high for _, low, high in several)
        # bound: 3 standard deviations of the mean logarithm over the kinds; that of one
        # by what n trials tell about P, with P = 1 - exp(-L phi) and dose ~ 1/phi - 1
        phi = exact.free(truth)
        slope = -math.log(WANTED) * WANTED * (1 - phi)
        deviation = math.sqrt(WANTED * (1 - WANTED) / n) / slope / math.sqrt(scene.KINDS)
        middle = math.exp(np.mean(np.log([value for value, _, _ in several])))
        results.add("smallest_dose", middle, reference=truth,
                    bound=math.expm1(3 * deviation), variant=patient)
    # bound: of 16 intervals of 95 % more than 4 miss once in a thousand times
    results.add("smallest_dose_intervals_that_miss_abs", misses, reference=0, bound=4)
    return found


def check_same(results):
    """Tables of one core, of two, of what was killed and continued, not of the quick form:
    lines that differ."""
    def lines(name):
        return [line for table in ("table", "summary", "smallest")
                for line in open(f"runs/{name}/ensemble/{table}.csv", "rb")]

    one = lines("one")
    for name in ("two", "killed"):
        if not os.path.isdir(f"runs/{name}"):
            continue
        other = lines(name)
        results.add("lines_that_differ_abs",
                    sum(a != b for a, b in zip(one, other)) + abs(len(one) - len(other)),
                    reference=0, bound=0, variant=name)


def draw(found, smallest):
    figure, (curve, intervals) = plots.plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True,
                                                    height_ratios=(2, 1))
    n = len(next(iter(found.values())))
    fine = np.concatenate(([0], np.geomspace(2, 400, 120)))
    for i, (patient, density) in enumerate(PATIENTS.items()):
        colour = plots.COLOURS[i]
        doses = [d for p, d in found if p == patient]
        counts = [int(found[patient, d][:, 0].sum()) for d in doses]
        part = np.divide(counts, n)
        bands = np.array([adhesion.wilson(c, n) for c in counts])
        curve.errorbar(doses, part, np.abs(bands.T - part), ls="", capsize=3, mfc="white",
                       marker=plots.MARKERS[i], color=colour,
                       label=f"{density:g} receptors/µm², {n} seeds each (95 %, Wilson)")
        curve.plot(fine, [exact.bond(density, d) for d in fine], color=colour, lw=1,
                   label="closed form" if i == 0 else None)
        truth = exact.smallest(density, WANTED)
        for j, (value, low, high) in enumerate(smallest[patient]):
            y = j + 9 * i
            intervals.plot([low, min(high, 320)], [y, y], color=colour, lw=1.5)
            intervals.plot(value, y, "|", color=colour, ms=8)
        intervals.plot([truth] * 2, [9 * i - 0.5, 9 * i + 7.5], color=plots.INK, lw=1, ls=":")
    curve.axhline(WANTED, color=plots.INK, lw=0.8, ls=":")
    curve.set(ylabel="probability of a bond in 4 ms", ylim=(-0.03, 1.03))
    curve.set_title("A drug blocks receptors of a block held over a wall", loc="left")
    curve.legend(loc="lower left")
    intervals.set_xscale("symlog", linthresh=10, linscale=0.5)
    doses = [0, 10, 20, 40, 80, 160, 320]
    intervals.set_xticks(doses, [str(d) for d in doses])
    intervals.set(xlabel="dose", yticks=[], xlim=(-1, 400),
                  ylabel="smallest dose for 1/2,\n8 studies each")
    plots.save(figure, "protocols.png")


def main():
    results = Results("A4")
    check_times(results)
    found = bonds()
    check_bands(results, found)
    smallest = check_smallest(results, len(next(iter(found.values()))))
    check_same(results)
    results.write()
    draw(found, smallest)


if __name__ == "__main__":
    main()
