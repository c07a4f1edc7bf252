# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes of the tutorial softCellInShear, whose folder it runs in, another scene.

    scene.py crowd SIDE END     SIDE^3 cells in shear until the strain END
    scene.py carried END        two soft spheres in a uniform flow that carries them
    scene.py held END           the same, held by tethers; END: their radii of the flow's way
    scene.py softer END         the same, the second softer by a factor of 1e4

Cells have the tutorial's material, the capillary number is 0.1.
"""

import os
import shutil
import sys

import numpy as np

RADIUS, EDGE, RATE = 4.0, 1.6, 5e-5     # um, um, 1/us
SHARE = 0.22                            # of the crowd's volume
GAP, WALL_GAP = 0.4, 0.8                # um, at the start: at least
MOVES, SEED = 100, 27


def text(value):
    if isinstance(value, dict):
        return "{ " + entries(value) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "(" + " ".join(map(text, value)) + ")"
    return value if isinstance(value, str) else f"{value:.10g}"


def entries(values):
    return " ".join(f"{key} {text(value)}" + ("" if isinstance(value, dict) else ";")
                    for key, value in values.items())


def write(path, values, kind="dictionary"):
    head = dict(version="2.0", format="ascii", object=os.path.basename(path), **{"class": kind})
    with open(path, "w") as file:
        file.write(entries(dict(FoamFile=head)) + "\n" + entries(values) + "\n")


def domain(half):
    x, y, z = half
    corners = [(-x, -y, -z), (x, -y, -z), (x, y, -z), (-x, y, -z),
               (-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]
    cells = np.maximum(2, np.rint(np.array(half) / 6))
    write("system/blockMeshDict", dict(
        scale=1, vertices=corners,
        blocks=f"(hex (0 1 2 3 4 5 6 7) {text(cells)} simpleGrading (1 1 1))",
        boundary="(upstream { type patch; faces ((0 4 7 3)); } "
                 "downstream { type patch; faces ((1 2 6 5)); } "
                 "sides { type patch; faces ((0 1 5 4) (3 7 6 2) (0 3 2 1) (4 5 6 7)); })"))


def cells(places, **more):
    bodies = {}
    for i, place in enumerate(places):
        name = f"cell{i}"
        bodies[name] = dict(type="elasticBody", position=place, **more,
                            shape=dict(type="sphere", radius=RADIUS, size=EDGE))
        for folder in ("constant", "system"):
            shutil.copytree(f"{folder}/cell", f"{folder}/{name}")
    write("constant/bodies", bodies)


def controls(end, **more):
    write("system/controlDict", dict(
        startFrom="latestTime", startTime=0, stopAt="endTime", endTime=end,
        deltaT=0.05 / RATE, adjustTimeStep="yes", writeControl="timeStep",
        writeInterval=1000000, writeFormat="binary", timePrecision=10, **more))


def places(side, half):
    """From a lattice by random moves of one after the other, where there is room."""
    random = np.random.default_rng(SEED)
    at = (2 * np.indices((side,) * 3).reshape(3, -1).T + 1 - side) * half / side
    for move in range(MOVES * len(at)):
        i = move % len(at)
        to = at[i] + random.uniform(-2, 2, 3)
        others = np.delete(at, i, axis=0)
        if (np.linalg.norm(others - to, axis=1) > 2 * RADIUS + GAP).all() \
                and (np.abs(to) < half - RADIUS - WALL_GAP).all():
            at[i] = to
    return at


def crowd(side, end):
    """Where they are at first the share of the volume is SHARE; walls go with the
    flow, and there is room for what it carries on."""
    half = RADIUS / 2 * (4 * np.pi / 3 / SHARE) ** (1 / 3) * side
    cells(places(side, half))
    domain(((1 + end) * half, half, half))
    controls(end / RATE)
    write("system/remeshDict", dict(growth=0.5))


def pair(end, **more):
    """One behind the other and aside; the flow goes RADIUS in a time of 1/RATE."""
    cells([(-6, 1, 0.5), (5, -1, -0.5)], **more)
    domain((24, 16, 16))
    speed = RADIUS * RATE * 10
    moved = dict(type="fixedValue", value=f"uniform {text((speed, 0, 0))}")
    write("0.orig/fluid/U", dict(
        dimensions="[0 1 -1 0 0 0 0]", internalField="uniform (0 0 0)",
        boundaryField=dict(sides=moved, upstream=moved, downstream=dict(
            type="traction", traction=(0, 0, 0)))), "volVectorField")
    controls(end * RADIUS / speed)
    write("system/remeshDict", dict(growth=0.5))


def main():
    kind, *numbers = sys.argv[1:]
    if kind == "crowd":
        crowd(int(numbers[0]), float(numbers[1]))
    elif kind == "carried":
        pair(float(numbers[0]))
    else:
        pair(float(numbers[0]), tether={})
    if kind == "softer":
        # seen to fail: a step is tried once
        controls(0.05 / RATE, minDeltaT=0.05 / RATE)
        write("constant/cell1/material", dict(type="neoHookean", E=1.49e-7, nu=0.49))


if __name__ == "__main__":
    main()
