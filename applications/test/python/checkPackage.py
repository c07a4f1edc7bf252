# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of the Python package, in the form that validation/Alltest collects."""

import contextlib
import io
import os
import sys
import tempfile

import h5py
import numpy as np

from fsbi import plots, results
from fsbi.history import History

counts = [0, 0]


def check(name, ok, why="no"):
    counts[0 if ok else 1] += 1
    print(f"ok - {name}" if ok else f"NOT OK - {name}: {why}")


def refused(action, error):
    try:
        action()
    except error:
        return True
    return False


def quietly(action, *arguments, **options):
    with contextlib.redirect_stdout(io.StringIO()):
        return action(*arguments, **options)


def check_results():
    r = results.Results("S6")
    r.add("omega", 25.1e-6, reference=25e-6, bound=0.01, seconds=41, cells=9)
    r.add("drift_abs", 3e-5, reference=0, bound=5e-4)
    r.at_least("order", 1.97, 1.95)
    r.write()
    check("results within their bounds pass", quietly(results.check) == 0)
    check("they are read back", len(results.read()) == 3
          and abs(float(results.read()[0]["error"]) - 0.004) < 1e-9)
    for quantity, value in (("omega", 25.3e-6), ("omega", float("nan"))):
        r = results.Results("S6", "bad.csv")
        r.add(quantity, value, reference=25e-6, bound=0.01)
        r.write()
        check(f"{value} instead of 25e-6 fails",
              quietly(results.check, "bad.csv") == 1)
    r = results.Results("S2", "bad.csv")
    r.at_least("order", 1.9, 1.95)
    r.write()
    check("an order too low fails", quietly(results.check, "bad.csv") == 1)
    check("a reference of zero needs _abs",
          refused(lambda: r.add("drift", 1e-5, 0, 1e-4), ValueError))


def check_history():
    rows = np.array([[0, 1.0], [1, 2.0], [2, 4.0], [0, 0]])
    with h5py.File("history.h5", "w", libver="latest") as file:
        table = file.create_dataset("bodies/cell/speed", data=rows)
        table.attrs["columns"] = np.array([b"time", b"u"])
        table.attrs["units"] = np.array([b"um/us"])
    speed = History("history.h5")["bodies/cell/speed"]
    check("a history is read by names", list(speed["u"]) == [1, 2, 4])
    check("without the torn row of a killed run", len(speed) == 3)
    check("with its units", speed.units == "um/us")
    check("an unknown column is refused", refused(lambda: speed["v"], KeyError))


def check_plots():
    h = np.array([4.0, 2.0, 1.0])
    orders = quietly(plots.convergence, "order.png", h, {"u": 0.01 * h**2})
    check("the order of h^2 is 2", np.allclose(orders["u"], 2))
    t = np.linspace(0, 60, 300)
    quietly(plots.curves, "curve.png", [("computed", t, np.sin(t))],
            theory=[("theory", t, np.sin(t))], xlabel="time (µs)", title="sine")
    for name in ("order.png", "curve.png"):
        check(f"{name} is small", 0 < os.path.getsize(name) < 150_000)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    check_results()
    check_history()
    check_plots()
    os.chdir("/")

print(f"{counts[0]} passed, {counts[1]} failed")
sys.exit(1 if counts[1] else 0)
