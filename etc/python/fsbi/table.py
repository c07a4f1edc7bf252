#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
r"""Write the validation tables of two READMEs from the results.csv files.

    table.py README.md validation/README.md validation/*/results.csv \
        applications/test/mutations/results.csv

A table replaces what stands between the lines <!-- results --> and
<!-- /results -->: in the first file a line for each folder, in the second one
for each quantity, with the variant (mesh, height, step, seed) that comes closest
to its bound.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from fsbi import results           # noqa: E402

START, END = "<!-- results -->", "<!-- /results -->"


def group(row):
    return row["quantity"].removesuffix("_abs").replace("_", " ")


def one_sided(row):
    """Written by results.at_least?"""
    return float(row["bound"]) == 0 and float(row["reference"]) not in (0, 1)


def closeness(row):
    bound = float(row["bound"])
    if one_sided(row):
        value = float(row["value"])
        return float(row["reference"]) / value if value else math.inf
    error = float(row["error"])
    return error / bound if bound else (0 if error == 0 else math.inf)


def number(text):
    return f"{float(text):.2g}" if float(text) else "0"


def shown(row):
    """Error and bound, or value and the least it may be"""
    if one_sided(row):
        return f"{float(row['value']):.3g}", f"≥ {float(row['reference']):g}"
    return number(row["error"]), number(row["bound"])


def quantities(path):
    groups = {}
    for row in results.read(path):
        groups.setdefault(group(row), []).append(row)
    return groups


def missed(rows):
    return not all(map(results.passed, rows))


def quantity_lines(path, readme):
    folder = os.path.relpath(os.path.dirname(path), os.path.dirname(readme))
    for name, rows in quantities(path).items():
        worst = max(rows, key=closeness)
        cells = max(int(row["cells"]) for row in rows)
        value, bound = shown(worst)
        yield (f"| [{worst['case']}]({folder}) | {name} | {len(rows)} | {value} | {bound}"
               f"{' **not met**' if missed(rows) else ''} | {cells if cells else ''} |")


def purpose(folder):
    """The first sentence or two of its Allrun"""
    words = []
    with open(os.path.join(folder, "Allrun")) as file:
        for text in list(file)[1:]:
            if not text.startswith("# ") or text.startswith("# Usage"):
                break
            words.append(text[2:].strip())
    return " ".join(words)


def folder_line(path):
    folder = os.path.dirname(path)
    groups = quantities(path)
    names = [name for name, rows in groups.items() if missed(rows)]
    checks = sum(map(len, groups.values()))
    return (f"| [{os.path.basename(folder)}]({folder}) | {purpose(folder)} | {checks} |"
            f" {', '.join(names) if names else 'all met'} |")


def overview(paths):
    return ["| validation | what | checks | bounds not met |", "|---|---|---|---|",
            *map(folder_line, paths)]


def details(paths, readme):
    return ["| case | quantity | checks | error or value | bound | largest mesh |",
            "|---|---|---|---|---|---|",
            *(line for path in paths for line in quantity_lines(path, readme))]


def replace(readme, lines):
    with open(readme) as file:
        before, _, rest = file.read().partition(START)
    _, end, after = rest.partition(END)
    if not end:
        sys.exit(f"table: {readme} has no lines {START} and {END}")
    table = "\n".join(lines)
    with open(readme, "w") as file:
        file.write(f"{before}{START}\n{table}\n{END}{after}")


def main(readme, full, *paths):
    replace(readme, overview(paths))
    replace(full, details(paths, full))


if __name__ == "__main__":
    main(*sys.argv[1:])
