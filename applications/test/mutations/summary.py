# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes and counts of mutations.csv.

    summary.py mutations.csv results.csv        writes U1
    summary.py quick.csv --none CLASS           fails if there is one, and prints it
"""

import collections
import csv
import sys

from fsbi.results import Results
from judge import BAD, GOOD


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def none(rows, verdict):
    found = [r for r in rows if r["class"] == verdict]
    for row in found:
        print(row["tutorial"], row["file"], row["entry"], row["kind"], row["why"])
    return 1 if found or not rows else 0


def write(rows, path):
    counts = collections.Counter(row["class"] for row in rows)
    seconds = sum(float(row["seconds"]) for row in rows)
    results = Results("U1", path)
    # bound: issue 16, at least 2 000 mutations and none of these classes
    results.at_least("mutations", len(rows), 2000, seconds=seconds)
    for verdict in BAD:
        results.add(f"{verdict}_abs", counts[verdict], reference=0, bound=0)
    # bound: a judge that never finds a class cannot tell it
    for verdict in GOOD:
        results.at_least(verdict, counts[verdict], 1)
    results.write()
    return results.check()


def main():
    rows = read(sys.argv[1])
    if sys.argv[2] == "--none":
        return none(rows, sys.argv[3])
    return write(rows, sys.argv[2])


if __name__ == "__main__":
    sys.exit(main())
