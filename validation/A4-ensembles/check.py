# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""First bonds against what independent receptors say; results.csv, dose.png.

Receptors are scattered over the cell, and bind one by one. That none of those in an
area has bound in a time T has the probability exp(-density integral(1 - exp(-rates T))),
for a Poisson number of them (a thousandth off for the 3 000 that the cell has, of which
some per cent are near the wall): the first bond's rate, L = -ln(1 - P) over T, is
proportional to the receptors, also if a drug takes each with a probability. So are
the bonds formed.

Bounds: three standard deviations of what so many seeds can tell, independent of each
other (the same seeds at all points make differences smaller, if anything):
L from P of n runs has P/(n (1 - P)) as variance; a receptor hardly ever forms two
bonds, so that the number of all is Poisson's, with mean L n."""

import csv
import math

import numpy as np

from fsbi import adhesion, plots
from fsbi.results import Results

PLANNED = 0.8               # P with all receptors: n seeds tell L best there


def read():
    """Whether a bond formed, and how many, of all runs of (density, blocked)."""
    found = {}
    with open("runs/wall/ensemble/table.csv", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault((float(row["density"]), float(row["blocked"])), []).append(
                (float(row["bond"]), float(row["formed"])))
    return {key: np.array(rows) for key, rows in found.items()}


def rate(rows):
    """L; of all runs with a bond that of half a run without."""
    part = min(rows[:, 0].mean(), 1 - 0.5 / len(rows))
    return -math.log(1 - part)


def scatter(part, n):
    """Relative standard deviations of L and of the bonds formed, with a part of the
    receptors, of n runs; from what was planned, not from what came out."""
    full = -math.log(1 - PLANNED) * part
    happens = 1 - math.exp(-full)
    return math.sqrt(happens / (1 - happens) / n) / full, 1 / math.sqrt(full * n)


def main():
    found = read()
    whole = found[15, 0]
    n = len(whole)
    results = Results("A4")
    results.add("runs_missing_abs", len(found) * n - sum(map(len, found.values())),
                reference=0, bound=0)
    for name, key, part in (("half_density", (7.5, 0), 0.5), ("half_blocked", (15, 0.5), 0.5),
                            ("three_quarters_blocked", (15, 0.75), 0.25)):
        if key not in found:        # quick
            continue
        some = found[key]
        # bound: see above, of a quotient
        bounds = [3 * math.hypot(*pair) for pair in zip(scatter(1, n), scatter(part, n))]
        results.add("first_bond_rate_ratio", rate(some) / rate(whole), reference=part,
                    bound=bounds[0], variant=name)
        results.add("formed_ratio", some[:, 1].mean() / whole[:, 1].mean(), reference=part,
                    bound=bounds[1], variant=name)
    if (15, 0.5) in found:
        draw({key: rows for key, rows in found.items() if key[0] == 15}, rate(whole), n)
    results.write()


def draw(found, full, n):
    figure, axes = plots.plt.subplots()
    free = np.array([1 - blocked for _, blocked in found])
    happened = [int(rows[:, 0].sum()) for rows in found.values()]
    part = np.divide(happened, n)
    bands = np.array([adhesion.wilson(h, n) for h in happened])
    axes.errorbar(free, part, np.abs(bands.T - part), capsize=3, ls="", marker="o", mfc="white",
                  label=f"{n} seeds each (95 %, Wilson)")
    fine = np.linspace(0, 1, 100)
    axes.plot(fine, 1 - np.exp(-full * fine), color="black", lw=1,
              label="single receptors, from the point without a drug")
    axes.set(xlabel="part of the receptors that is free", ylabel="probability of a bond in 4 ms",
             ylim=(-0.03, 1.03))
    axes.set_title("A drug blocks a part of the receptors of a held cell", loc="left")
    axes.legend(loc="lower right")
    plots.save(figure, "dose.png")


if __name__ == "__main__":
    main()
