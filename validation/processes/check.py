# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the histories of every scene on 1, 2 and 4 processes, and of runs
continued from a saved state with those that were not stopped; write results.csv.

"The same" is to 1e-5 of a scale, on other numbers of processes, and to 1e-10 of
it when a run is continued on as many. The scale of a table is its largest number.
What cancels, or is nothing, in a scene has the scale of what it is made of:

- forces and torques: the largest of all bodies, at least Stokes' drag 6 pi mu a U
  and torque 8 pi mu a^3 omega at the largest velocities: on free bodies they
  cancel; angular velocities: at least U/a, the surface of a body that turns in
  nothing but the mesh's error is as fast as that error;
- an elastic body's centre: at least its radius a; its energy and the reaction of
  its supports: at least those of a strain of 0.1 %, 1e-6 E a^3 and 1e-3 E a^2;
  work: at least that of this reaction over a radius (the surface of
  rotatingSphere travels far against a force of nothing)."""

import glob
import math
import re
import sys

import numpy as np

from fsbi.case import Case
from fsbi.results import Results

# against the run on one process; a restart against that on two
RUNS = {"np2": "np 2", "np4": "np 4", "2to1": "2 to 1", "2to4": "2 to 4"}
HEADS = [*RUNS.values(), "restart"]

# bound: parts of a mesh are preconditioned otherwise, so that solutions differ by what
# the solvers leave, 1e-9 of the residual; the recorded sum of tractions may be a 1e4th
# of their size
BOUND = 1e-5

# bound: case B6 of the project. The same work is done in the same order
RESTART = 1e-10

results = Results("B6")


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
    for name in ("/reaction/", "/work", "/energy", "/centre", "/angularVelocity"):
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
    spin = max(speed / a, fastest("/angularVelocity"))
    return {"/force/": 6 * math.pi * mu * a * speed,
            "/torque/": 8 * math.pi * mu * a**3 * spin, "/angularVelocity": spin}


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
    for run, first in [*((run, "np1") for run in RUNS), ("2to2", "np2")]:
        print(scene, run)
        try:
            found[run] = difference(Case(folder(scene, first)), Case(folder(scene, run)))
        except (OSError, KeyError, IndexError) as fault:
            print(f"  {fault}")
            found[run] = math.nan
    found["restart"] = found.pop("2to2")
    return found, one


def main():
    lines = [
        "| scene | " + " | ".join(HEADS) + " | cells |",
        "|---" * (len(HEADS) + 2) + "|",
    ]
    for scene in sys.argv[1:]:
        try:
            found, one = compared(scene)
        except (OSError, KeyError, IndexError):
            print(f"{scene}: not run")
            lines.append(f"| {scene} |" + " not run |" * len(HEADS) + " |")
            results.add(f"{scene}_processes_abs", math.nan, 0, BOUND)
            results.add(f"{scene}_restart_abs", math.nan, 0, RESTART)
            continue
        # nan, of a run without an end, is the worst
        restart = found.pop("restart")
        worst = max(found.values(), key=lambda d: math.inf if math.isnan(d) else d)
        cost = dict(cells=one.cells, seconds=one.seconds)
        results.add(f"{scene}_processes_abs", worst, 0, BOUND, procs=4, **cost)
        results.add(f"{scene}_restart_abs", restart, 0, RESTART, procs=2, **cost)
        found["restart"] = restart
        lines.append(f"| {scene} | "
                     + " | ".join(f"{d:.1e}" for d in found.values())
                     + f" | {one.cells} |")
    results.write()
    with open("table.md", "w") as file:
        file.write("Largest difference from the run on one process, over the largest number of its"
                   " table\n(of what cancels: over scales of the scene, see check.py); 2 to N: from"
                   " the middle on N;\nrestart: from the middle on two, against two without a stop."
                   " Written by check.py.\n\n" + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
