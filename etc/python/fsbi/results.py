# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The results.csv of a validation: write, read, check against the bounds.

    results = Results("S6")
    results.add("omega", 25.1e-6, reference=25e-6, bound=0.01, seconds=41)
    results.add("drift_abs", 3e-5, reference=0, bound=5e-4, variant="mesh2")
    results.write()
    sys.exit(results.check())

The error is relative to the reference, or absolute when the quantity's name
ends in _abs. A quantity of several meshes, steps or seeds is one quantity with
as many variants: tables show the one that comes closest to its bound. Several
parts of a validation may append to one file: results.write(append=True). On the
command line, `results.py results.csv` prints and checks a file.
"""

import csv
import math
import os
import sys

HEADER = "case,quantity,variant,value,reference,error,bound,seconds,cells,procs".split(",")


def error(quantity, value, reference):
    """Relative, or absolute for the quantities that end in _abs."""
    difference = abs(value - reference)
    if quantity.endswith("_abs"):
        return difference
    if reference == 0:
        raise ValueError(
            f"{quantity}: a reference of zero has no relative error; "
            "let the quantity's name end in _abs"
        )
    return difference / abs(reference)


def passed(row):
    """Within its bound? False for nan, too."""
    return float(row["error"]) <= float(row["bound"])


def line(row):
    """One line of a test's print-out."""
    name = " ".join(filter(None, (row["case"], row["quantity"], row["variant"])))
    text = (
        f"{name}: value {float(row['value']):.6g}, "
        f"reference {float(row['reference']):.6g}, "
        f"error {float(row['error']):.2e}, bound {float(row['bound']):.1e}"
    )
    return ("ok - " if passed(row) else "NOT OK - ") + text


def read(path="results.csv"):
    with open(path, newline="") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != HEADER:
            raise ValueError(f"{path}: the header must be {','.join(HEADER)}")
        return list(reader)


def check(path="results.csv"):
    """Print one line per row; 0 when there are rows and all are in bounds."""
    rows = read(path)
    for row in rows:
        print(line(row))
    return 0 if rows and all(passed(row) for row in rows) else 1


class Results:
    def __init__(self, case, path="results.csv"):
        self.case = case
        self.path = path
        self.rows = []

    def add(self, quantity, value, reference, bound, seconds=math.nan,
            cells=0, procs=1, variant=""):
        """One quantity; a bound on the value itself has reference 0 and _abs."""
        return self._row(quantity, value, reference,
                         error(quantity, value, reference),
                         bound, seconds, cells, procs, variant)

    def at_least(self, quantity, value, lowest, seconds=math.nan, cells=0,
                 procs=1, variant=""):
        """One-sided, as for orders of convergence: the error is what lacks,
        relative, and must be zero."""
        lack = 0 if value >= lowest else abs(value / lowest - 1)
        return self._row(quantity, value, lowest, lack, 0, seconds, cells, procs, variant)

    def _row(self, quantity, value, reference, error, bound, seconds, cells,
             procs, variant):
        row = dict(
            case=self.case,
            quantity=quantity,
            variant=variant,
            value=f"{value:.10g}",
            reference=f"{reference:.10g}",
            error=f"{error:.4g}",
            bound=f"{bound:.4g}",
            seconds="" if math.isnan(seconds) else f"{seconds:.1f}",
            cells=int(cells),
            procs=int(procs),
        )
        self.rows.append(row)
        return row

    def write(self, append=False):
        append = append and os.path.isfile(self.path)
        with open(self.path, "a" if append else "w", newline="") as file:
            writer = csv.DictWriter(file, HEADER, lineterminator="\n")
            if not append:
                writer.writeheader()
            writer.writerows(self.rows)

    def check(self):
        for row in self.rows:
            print(line(row))
        return 0 if self.rows and all(map(passed, self.rows)) else 1


if __name__ == "__main__":
    sys.exit(check(*sys.argv[1:2]))
