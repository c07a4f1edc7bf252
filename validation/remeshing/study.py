# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of forces and shape on three sizes of cells; write study.csv.

What the sizes tend to is extrapolated from the two finer ones at second order,
that of the operators; the order observed, from all three, stands beside.
"""

import csv

import numpy as np

from fsbi import convergence
from fsbi.case import Case
from quantities import AXES, FORCES, rows

SIZES = 1, 3 / 4, 9 / 16


def difference(values, others):
    """Relative, the mean of all steps."""
    return np.mean(np.linalg.norm(values - others, axis=1)
                   / np.linalg.norm(others, axis=1))


def study(values):
    """Errors on the three sizes and the order observed."""
    coarse, middle, fine = values
    limit = convergence.richardson(SIZES, values)
    order = convergence.order_of_differences(SIZES, difference(middle, coarse),
                                             difference(fine, middle))
    return [difference(v, limit) for v in values] + [order]


def main():
    runs = [Case(f"sizes/size{i}") for i in (1, 2, 3)]
    with open("study.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["quantity", *(f"error_{run.cells}_cells" for run in runs), "order"])
        for name, table in {**FORCES, "shape_after_20": AXES}.items():
            values = [rows(run, table) for run in runs]
            if table == AXES:
                values = [v[-1:] for v in values]
            result = study(values)
            writer.writerow([name, *(f"{v:.4g}" for v in result)])
            print(f"    {name}: errors {result[0]:.2g} {result[1]:.2g} {result[2]:.2g}, "
                  f"order {result[3]:.2f}")


if __name__ == "__main__":
    main()
