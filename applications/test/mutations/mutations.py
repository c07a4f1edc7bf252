# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One-change mutations of the tutorials, run and judged (rules: judge.py).

    mutations.py                    all, in a drawn order; goes on where it was
                                    left; appends to mutations.csv
    mutations.py --count N          until there are N
    mutations.py --np N             N at a time
    mutations.py --tutorials T ...  of these only
    mutations.py --again CLASS ...  those of these classes once more
    mutations.py --only ID ...      runs these, and prints what they end with
    mutations.py --until HH:MM      starts none after this time
"""

import argparse
import collections
import csv
import multiprocessing
import os
import sys
import time

import judge
import mutate
import program
import scenes

FIELDS = ["tutorial", "file", "entry", "kind", "class", "seconds", "why"]
RUNS = os.path.abspath("runs")


def bases(tutorials):
    for name in tutorials:
        case = os.path.join(RUNS, "base", name)
        if not os.path.isdir(case):
            scenes.prepare(name, case + ".part")
            os.rename(case + ".part", case)


def identity(row):
    return f"{row['tutorial']}:{row['file']}:{row['entry']}:{row['kind']}"


def read(path):
    if not os.path.isfile(path):
        return {}
    with open(path, newline="") as file:
        return {identity(row): row for row in csv.DictReader(file)}


def write(path, rows):
    with open(path + ".new", "w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(rows, key=identity))
    os.replace(path + ".new", path)


judges = {}


def one(mutation):
    """In a worker: its own case folder and programs."""
    name = mutation.tutorial
    if name not in judges:
        case = os.path.join(RUNS, f"case{os.getpid()}", name)
        judges[name] = judge.Judge(os.path.join(RUNS, "base", name), case)
    result = judges[name].judge(mutation)
    return {"tutorial": name, "file": mutation.file, "entry": ".".join(mutation.path),
            "kind": mutation.kind, "class": result.verdict,
            "seconds": f"{result.seconds:.1f}",
            "why": result.why.replace(judges[name].case, "CASE")}


def work(todo, rows, options):
    """All of `todo`, the results written every few."""
    with multiprocessing.Pool(options.np) as pool:
        last = time.time()
        # one at a time is given out, so that the clock may end it
        for row in pool.imap_unordered(one, clocked(todo, options.until)):
            rows[identity(row)] = row
            if options.only or row["class"] not in judge.GOOD:
                print(f"{row['class']}: {identity(row)}: {row['why']}", flush=True)
            if time.time() - last > 10:
                write(options.results, rows.values())
                last = time.time()
    write(options.results, rows.values())


def clocked(todo, until):
    for mutation in todo:
        if until and time.strftime("%H:%M") >= until:
            return
        yield mutation


def chosen(options, rows):
    tutorials = options.tutorials or list(scenes.COARSE)
    bases(tutorials)
    every = mutate.drawn(m for name in tutorials
                         for m in mutate.of_case(name, os.path.join(RUNS, "base", name)))
    if options.only:
        return [m for m in every if m.id in options.only]
    again = [m for m in every if m.id in rows and rows[m.id]["class"] in options.again]
    if options.again:
        return again
    for gone in set(rows) - {m.id for m in every}:
        if rows[gone]["tutorial"] in tutorials:
            del rows[gone]      # the tutorial has changed since
    return [m for m in every if m.id not in rows][:max(options.count - len(rows), 0)]


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--count", type=int, default=10**9)
    options.add_argument("--np", type=int, default=1)
    options.add_argument("--tutorials", nargs="+")
    options.add_argument("--again", nargs="+", default=[])
    options.add_argument("--only", nargs="+", default=[])
    options.add_argument("--until")
    options.add_argument("--results", default="mutations.csv")
    options = options.parse_args()
    program.build()
    rows = read(options.results)
    work(chosen(options, rows), rows, options)
    print(*(f"{n} {c}" for c, n in
            collections.Counter(r["class"] for r in rows.values()).most_common()), sep=", ")
    return 0


if __name__ == "__main__":
    sys.exit(main())
