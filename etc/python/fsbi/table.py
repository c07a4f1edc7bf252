#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the validation table of a README from the results.csv files.

    table.py README.md validation/*/results.csv

The table replaces what stands between the lines <!-- results --> and
<!-- /results -->. Rows that differ only in mesh, height, step or width are one
line, with the row that comes closest to its bound.
"""

import math
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from fsbi import results

VARIANT = re.compile(
    r"_(mesh\d+|at_[\d.]+a|step_[\d.e+-]+tau|[\d.]+us|halfWidth\d+|\d+across|w[\d.]+|\d+steps"
    r"|StVenantKirchhoff|neoHookean|displacements|tractions)(?=_|$)")
START, END = "<!-- results -->", "<!-- /results -->"


def group(row):
    name = VARIANT.sub("", row["quantity"]).removesuffix("_abs").replace("_", " ")
    wall = "_at_" in row["quantity"] and "wall" not in name
    return name + " beside a wall" if wall else name


def one_sided(row):
    """Written by results.at_least?"""
    return float(row["bound"]) == 0 and float(row["reference"]) not in (0, 1)


def closeness(row):
    bound = float(row["bound"])
    if one_sided(row):
        return float(row["reference"]) / float(row["value"])
    error = float(row["error"])
    return error / bound if bound else (0 if error == 0 else math.inf)


def number(text):
    return f"{float(text):.2g}" if float(text) else "0"


def line(folder, name, rows):
    worst = max(rows, key=closeness)
    cells = max(int(row["cells"]) for row in rows)
    if one_sided(worst):
        shown = f"{float(worst['value']):.3g}", f"≥ {float(worst['reference']):g}"
    else:
        shown = number(worst["error"]), number(worst["bound"])
    mark = "" if all(map(results.passed, rows)) else " **not met**"
    return (f"| [{worst['case']}]({folder}) | {name} | {len(rows)} | {shown[0]} |"
            f" {shown[1]}{mark} | {cells if cells else ''} |")


def table(paths):
    lines = ["| case | quantity | checks | error or value | bound | largest mesh |",
             "|---|---|---|---|---|---|"]
    for path in paths:
        groups = {}
        for row in results.read(path):
            groups.setdefault(group(row), []).append(row)
        lines += [line(os.path.dirname(path), *item) for item in groups.items()]
    return "\n".join(lines)


def main(readme, *paths):
    with open(readme) as file:
        before, _, rest = file.read().partition(START)
    _, end, after = rest.partition(END)
    if not end:
        sys.exit(f"table: {readme} has no lines {START} and {END}")
    with open(readme, "w") as file:
        file.write(f"{before}{START}\n{table(paths)}\n{END}{after}")


if __name__ == "__main__":
    main(*sys.argv[1:])
