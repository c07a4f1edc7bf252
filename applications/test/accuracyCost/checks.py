# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks in the form that validation/Alltest collects."""

counts = [0, 0]


def check(name, ok, why="no"):
    counts[0 if ok else 1] += 1
    print(f"ok - {name}" if ok else f"NOT OK - {name}: {why}", flush=True)


def end():
    print(f"{counts[0]} passed, {counts[1]} failed")
    raise SystemExit(bool(counts[1]))
