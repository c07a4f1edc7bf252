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

from fsbi import adhesion, plots, results, steps
from fsbi.history import History
from fsbi.report import units

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


def check_aggregate():
    # steps of all lengths: free until 3000, then held, once jerked loose
    time = np.concatenate((np.linspace(0, 3000, 31), np.linspace(3001, 9000, 2000)))
    speed = np.where(time <= 3000, 1.0, 0.0)
    at, even = adhesion.uniform(time, speed, 30)
    check("samples at equal intervals", np.allclose(np.diff(at), 30) and at[-1] == 9000)
    mean = adhesion.moving_mean(even, 75)
    start = adhesion.aggregate_time(at, mean, 0.05)
    # 75 samples, of which fewer than 3.75 (and one on the edge) are still free
    check("an aggregate is found when the mean has forgotten the free motion",
          abs(start - (3000 + 72 * 30)) <= 30, start)
    check("none if it comes loose at the end",
          np.isnan(adhesion.aggregate_time(at, mean + (at > 8900), 0.05)))
    check("none if the speed is not known",
          np.isnan(adhesion.aggregate_time(at, mean * np.nan, 0.05)))
    check("the mean is that of the last samples",
          np.allclose(adhesion.moving_mean([1.0, 2, 3, 4], 2), [1, 1.5, 2.5, 3.5]))


def check_rolling():
    # moves for 300 at the speed 2, stands for 100, and so on
    time = np.linspace(0, 4000, 4001)
    phase = time % 400
    x = 600 * (time // 400) + 2 * np.minimum(phase, 300)
    motion = adhesion.rolling(time, x, free=2, window=20)
    check("mean velocity of a stop-and-go", abs(motion.mean - 1.5) < 1e-9)
    check("a quarter of the time in pauses, less the window",
          abs(motion.pause_fraction - 0.25) < 0.05, motion.pause_fraction)
    check("ten pauses of nearly 100", len(motion.pauses) == 10
          and all(75 <= b - a <= 105 for a, b in motion.pauses[:-1]))
    check("none in a steady motion",
          adhesion.rolling(time, 2 * time, 2, 20).pauses == [])


def check_wilson():
    # Newcombe (1998), Stat. Med. 17, 857, table I: 81 of 263, 15 of 148, 0 of 20
    for happened, trials, low, high in ((81, 263, 0.2553, 0.3662),
                                        (15, 148, 0.0624, 0.1605),
                                        (0, 20, 0.0000, 0.1611)):
        check(f"Wilson's band of {happened} of {trials}",
              np.allclose(adhesion.wilson(happened, trials), (low, high), atol=6e-5))


def check_steps():
    rows = {"0": (("1 1 accepted 9 1 1e-7 0.5 deltaT", "2 1 rejected 8 2 1e-2 - it failed, alas",
                   "3 2 accepted 7 1 1e-7 - deltaT"), ("1 0.5 0.25 1", "3 0.75 0.5 2")),
            "1": (("1.5 0.5 accepted 6 1 1e-7 - growth", "2 0.5 acc"), ("1.5 4 5",))}
    for start, (tried, seconds) in rows.items():
        os.makedirs(f"postProcessing/steps/{start}")
        with open(f"postProcessing/steps/{start}/steps.dat", "w") as file:
            file.write("\n".join(("# time length ...", *tried)) + "\n" * (start == "0"))
        with open(f"postProcessing/steps/{start}/seconds.dat", "w") as file:
            head = "# time solve bonds total" if start == "0" else "# time solve total"
            file.write("\n".join((head, *seconds)) + "\n")
    found = steps.tried(".")
    check("steps of a continued run replace what it went back behind",
          [(s.time, s.iterations) for s in found] == [(1, 9), (1.5, 6)], found)
    parts, seconds = steps.seconds(".")
    check("seconds of both runs add up, by part", parts == ["solve", "bonds", "total"]
          and np.allclose(seconds, [[1, 0.5, 0.25, 1], [1.5, 4.5, 0.25, 6]]), (parts, seconds))


def check_units():
    for columns, text, wanted in (
            (["x", "y"], "M L/T^2", ["M L/T^2"] * 2),
            (["step", "n", "s"], "T, -, s", ["T", "-", "s"]),
            (["smallest"], "L; range if larger", ["L"]),
            (["Bx", "fx", "lag", "I.a", "n"], "B: tesla, f: M L/T^2, lag: rad, I: A",
             ["tesla", "M L/T^2", "rad", "A", "-"])):
        check(f"units of columns from '{text}'", units.of_columns(columns, text) == wanted)
    check("a unit in a system", units.named("M L/T^2", "microvascular") == "nN"
          and units.named("L/T", "SI") == "m/s" and units.named("tesla", "SI") == "tesla")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    check_steps()
    check_units()
    check_results()
    check_history()
    check_plots()
    check_aggregate()
    check_rolling()
    check_wilson()
    os.chdir("/")

print(f"{counts[0]} passed, {counts[1]} failed")
sys.exit(1 if counts[1] else 0)
