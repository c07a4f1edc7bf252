# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Probability of an aggregate by the dose, of every patient and protocol, with what so
few runs can tell (95 %, Wilson); and the smallest dose for the wanted probability."""

import csv

import numpy as np

from fsbi import plots

FOLDER = "runs/protocols/ensemble"


def rows(table):
    with open(f"{FOLDER}/{table}.csv", newline="") as file:
        return list(csv.DictReader(file))


def curve(axes, i, patient, found):
    doses = np.array([float(r["dose"]) for r in found])
    value, low, high = (np.array([float(r[word]) for r in found])
                        for word in ("value", "low", "high"))
    axes.errorbar(doses * (1 + 0.03 * (2 * i - 1)), value, [value - low, high - value],
                  color=plots.COLOURS[i], marker=plots.MARKERS[i], mfc="white", lw=1, capsize=3,
                  label=f"patient {patient}")


def dose(axes, i, row):
    y = float(row["probability"]) + 0.015 * (2 * i - 1)
    value, low, high = (float(row[word]) for word in ("dose", "low", "high"))
    axes.plot([min(low, last), min(high, last)], [y, y], color=plots.COLOURS[i], lw=4, alpha=0.4)
    if value < last:
        axes.plot(value, y, "|", color=plots.COLOURS[i], ms=9, mew=2)


summary = [r for r in rows("summary") if r["quantity"] == "aggregate"]
smallest = rows("smallest")
protocols, patients = (list(dict.fromkeys(r[word] for r in summary))
                       for word in ("protocol", "patient"))
doses = sorted({float(r["dose"]) for r in summary})
last = 2 * doses[-1]        # of the axis
figure, several = plots.plt.subplots(1, len(protocols), figsize=(8.6, 3.8), sharey=True,
                                     squeeze=False)
for axes, protocol in zip(several[0], protocols):
    for i, patient in enumerate(patients):
        curve(axes, i, patient, [r for r in summary
                                 if (r["patient"], r["protocol"]) == (patient, protocol)])
    for row in smallest:
        if row["protocol"] == protocol:
            dose(axes, patients.index(row["patient"]), row)
    axes.axhline(float(smallest[0]["probability"]), color=plots.INK, lw=0.8, ls=":")
    axes.set_xscale("symlog", linthresh=20, linscale=0.6)
    axes.set(xlabel="each dose (mg)", xlim=(-2, last), ylim=(-0.05, 1.05))
    axes.set_xticks(doses, [f"{d:g}" for d in doses])
    axes.set_title(protocol, loc="left")
several[0][0].set_ylabel("probability of an aggregate")
several[0][-1].legend(loc="upper right")
plots.save(figure, "protocols.png")
