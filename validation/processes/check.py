# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the histories of every scene with the run on one process; write
results.csv. A difference is relative to the largest number of its table, of
forces and torques to the largest of all bodies and at least to Stokes' drag
6 pi mu a U and torque 8 pi mu a^3 omega: on free bodies they cancel. A centre's
is relative to at least the radius, energy and reaction of a solid body to at
least those of a strain of 0.1 %, work to that of this reaction over a radius:
the surface of rotatingSphere travels far against a force of nothing."""

import glob
import math
import re
import sys

import numpy as np

from fsbi.case import Case
from fsbi.results import Results

RUNS = {"np2": "np 2", "np4": "np 4", "2to2": "restart", "2to1": "2 to 1", "2to4": "2 to 4"}
BOUND = 1e-5        # what is left of forces that nearly cancel has few digits
results = Results("processes")


def tables(history):
    """Numbers by path; without times and seconds of wall clock; work apart."""
    found = {}
    for path in history.paths():
        columns = history[path].columns
        kept = [i for i, c in enumerate(columns) if c not in ("time", "seconds", "work")]
        if path != "cost":
            found[path] = history[path].array[:, kept]
        if "work" in columns:
            found[path + "/work"] = history[path]["work"][:, None]
    return found


def scale_of(path):
    """What is measured by one scale: a table, or all forces or torques."""
    for name in ("/reaction/", "/work", "/energy", "/centre"):
        if name in path:
            return name
    if path.endswith(("/fluidForce", "/tether")):
        return "/force/"
    for load in ("/force/", "/torque/"):
        if load in path:
            return load
    return path


def stokes(run, values):
    """Drag and torque of the first body's radius at the largest velocities."""
    text = {}
    for name in ("fluid/material", "bodies"):
        try:
            with open(f"{run.folder}/constant/{name}") as file:
                text[name] = file.read()
        except FileNotFoundError:
            return {}
    mu = re.search(r"viscosity\s+([0-9.e+-]+)", text["fluid/material"])
    radius = re.search(r"radius\s+([0-9.e+-]+)", text["bodies"])
    if not mu or not radius:
        return {}
    mu, a = float(mu[1]), float(radius[1])

    def fastest(name):
        return max((np.max(np.abs(table), initial=0) for path, table in values.items()
                    if path.endswith(name)), default=0)

    # of elastic bodies there is the centre's way from row to row
    ways = [run.history[path].array for path in values if path.endswith("/centre")]
    speeds = [np.max(np.abs(np.diff(way[:, 1:], axis=0) / np.diff(way[:, :1], axis=0)), initial=0)
              for way in ways]
    speed = max(speeds + [fastest("/velocity")])
    return {"/force/": 6 * math.pi * mu * a * speed,
            "/torque/": 8 * math.pi * mu * a**3 * fastest("/angularVelocity")}


def strained(run):
    """Energy, force and work at a strain of 0.1 %, and the radius."""
    text = ""
    for file in [f"{run.folder}/constant/bodies", *glob.glob(f"{run.folder}/constant/*/material")]:
        with open(file) as opened:
            text += opened.read()
    radius = re.search(r"radius\s+([0-9.e+-]+)", text)
    modulus = re.search(r"^E\s+([0-9.e+-]+)", text, re.M)
    if not radius or not modulus:
        return {}
    a, E = float(radius[1]), float(modulus[1])
    return {"/energy": 1e-6 * E * a**3, "/reaction/": 1e-3 * E * a**2,
            "/work": 1e-3 * E * a**3, "/centre": a}


def difference(one, other):
    first, second = tables(one.history), tables(other.history)
    if first.keys() != second.keys() or not first:
        return math.nan
    scales = stokes(one, first) | strained(one)
    for path, table in first.items():
        size = np.max(np.abs(table), initial=0)
        scales[scale_of(path)] = max(size, scales.get(scale_of(path), 0))
    worst = 0
    for path, table in first.items():
        if table.shape != second[path].shape:
            return math.nan
        largest = np.max(np.abs(table - second[path]), initial=0)
        # a table of nothing but round-off has no scale
        if scales[scale_of(path)] > 0:
            change = largest / scales[scale_of(path)]
            if not change <= worst:
                worst = change
                print(f"  {path}: {change:.1e}")
    return worst


def folder(scene, run):
    return f"runs/{scene}.{run.removeprefix('np')}"


def compared(scene):
    """Difference by run, and the run on one process."""
    one = Case(folder(scene, "np1"))
    found = {}
    for run in RUNS:
        print(scene, RUNS[run])
        try:
            found[run] = difference(one, Case(folder(scene, run)))
        except (OSError, KeyError, IndexError) as fault:
            print(f"  {fault}")
            found[run] = math.nan
    return found, one


lines = [
    "| scene | " + " | ".join(RUNS.values()) + " | cells |",
    "|---" * (len(RUNS) + 2) + "|",
]
for scene in sys.argv[1:]:
    try:
        found, one = compared(scene)
    except (OSError, KeyError, IndexError):
        print(f"{scene}: not run")
        lines.append(f"| {scene} |" + " not run |" * len(RUNS) + " |")
        continue
    # nan, of a run without an end, is the worst
    worst = max(found.values(), key=lambda d: math.inf if math.isnan(d) else d)
    results.add(f"{scene}_abs", worst, 0, BOUND, cells=one.cells, seconds=one.seconds, procs=4)
    lines.append(f"| {scene} | "
                 + " | ".join(f"{d:.1e}" for d in found.values())
                 + f" | {one.cells} |")
results.write()
with open("table.md", "w") as file:
    file.write("Largest difference from the run on one process, relative to its table's"
               " largest number\n(what cancels: to scales of the scene, see check.py);"
               " restart: from the middle on two\nprocesses; 2 to N: from there on N."
               " Written by check.py.\n\n" + "\n".join(lines) + "\n")
