# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of a run's history on the command line, also while it runs.

    python3 -m fsbi history CASE                        all tables
    python3 -m fsbi history CASE bodies/cell/position   its last rows
    python3 -m fsbi history CASE cost --csv             all rows, for other programs

CASE is a case's folder or a history file. Paths may end early: `bodies/cell`
shows all tables of that body, one after the other.

    python3 -m fsbi report CASE                         one page, as fsbiReport
"""

import argparse
import csv
import os
import sys

from .history import History


def options(arguments):
    parser = argparse.ArgumentParser(
        prog="python3 -m fsbi", usage=__doc__,
        formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("command", choices=["history"])
    parser.add_argument("case")
    parser.add_argument("table", nargs="?", default="")
    parser.add_argument("--rows", type=int, default=10, help="how many of the last rows (10)")
    parser.add_argument("--csv", action="store_true", help="all rows, with commas")
    return parser.parse_args(arguments)


def file_of(case):
    if os.path.isfile(case):
        return case
    path = os.path.join(case, "postProcessing", "history.h5")
    if not os.path.isfile(path):
        raise SystemExit(f"python3 -m fsbi: no {path}; the run writes it with its first step")
    return path


def print_list(history):
    paths = history.paths()
    width = max((len(path) for path in paths), default=0)
    for path in paths:
        table = history[path]
        last = f"to {table.array[-1, 0]:.8g}" if len(table) else ""
        print(f"{path:{width}}  {len(table):6} rows {last:16} "
              f"{' '.join(table.columns)}  [{table.units}]")


def print_rows(table, rows):
    widths = [max(len(column), 12) for column in table.columns]
    print(" ".join(f"{c:>{w}}" for c, w in zip(table.columns, widths)))
    for row in table.array[-rows:]:
        print(" ".join(f"{v:{w}.{6 if i else 9}g}"
                       for i, (v, w) in enumerate(zip(row, widths))))


def print_csv(table):
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows([f"{v:.17g}" for v in row] for row in table.array)


def main(arguments):
    given = options(arguments)
    history = History(file_of(given.case))
    if not given.table:
        print_list(history)
        return
    wanted = given.table.strip("/")
    chosen = [p for p in history.paths() if p == wanted or p.startswith(wanted + "/")]
    if not chosen or (given.csv and len(chosen) > 1):
        raise SystemExit("python3 -m fsbi: say which of the tables "
                         + ", ".join(chosen or history.paths()))
    for path in chosen:
        table = history[path]
        if given.csv:
            print_csv(table)
        else:
            print(f"{path} [{table.units}]")
            print_rows(table, given.rows)


try:
    if sys.argv[1:2] == ["report"]:
        from .report.__main__ import main as report
        report(sys.argv[2:])
    else:
        main(sys.argv[1:])
except BrokenPipeError:                     # `| head` has seen enough
    sys.stderr.close()
