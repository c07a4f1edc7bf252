# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is known of the errors of a run: distances from an exact solution (the
function object exactError), and what fsbiAccuracyCost found for the case."""

import csv
import glob
import html
import os


def section(run):
    known = _exact(run) + _studied(run)
    case = html.escape(os.path.basename(run.case))
    return known or (
        "<p>No estimate of this run's error is in the case. fsbiAccuracyCost finds one by"
        f" coarser and finer runs: <code>fsbiAccuracyCost {case} --quantity ...</code></p>")


def _exact(run):
    """The latest errors against an exact solution."""
    files = glob.glob(os.path.join(run.case, "postProcessing", "*", "*", "errors.csv"))
    if not files:
        return ""
    latest = max(files, key=lambda f: float(f.split(os.sep)[-2]))
    with open(latest, newline="") as file:
        row = next(csv.DictReader(file))
    cells = "".join(f"<tr><td>{html.escape(k)}</td><td>{html.escape(v)}</td></tr>"
                    for k, v in row.items())
    return ("<h3>Distance from the exact solution, relative</h3>"
            f"<table><tr><th>norm</th><th>value</th></tr>{cells}</table>")


def _studied(run):
    path = os.path.join(run.case, "accuracyCost", "report.md")
    if not os.path.isfile(path):
        return ""
    with open(path) as file:
        return f"<h3>Found by fsbiAccuracyCost</h3><pre>{html.escape(file.read())}</pre>"
