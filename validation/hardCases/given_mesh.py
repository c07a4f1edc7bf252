# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of the user's own, as bad as wanted: the beam of beamSelfWeight, 8 x 8 x
64 cells, its inner points moved. In place of a Scene."""

import os
import re
import shutil
import subprocess

import numpy as np

from scene import Flow

EDGE = 0.0375                   # m


def shaken(part):
    """Every inner point by up to a part of the edge in each direction."""
    random = np.random.default_rng(1)

    def move(points, inner):
        points[inner] += part * EDGE * random.uniform(-1, 1, (inner.sum(), 3))
    return move


def sheared(way):
    """Layers across bulge along the beam by `way` (m) in the middle."""
    def move(points, inner):
        low = points.min(axis=0)
        waves = np.sin(np.pi * (points - low) / (points.max(axis=0) - low))
        points[:, 2] += way * waves.prod(axis=1)
    return move


class GivenBeam:
    bodies, effects, remesh, faulty = (), {}, {}, None
    flow, end = Flow("rest"), 1.0

    def __init__(self, move):
        self.move = move

    def write(self, folder):
        shutil.rmtree(folder, ignore_errors=True)
        tutorial = os.path.join(os.environ["FSBI_DIR"], "tutorials", "beamSelfWeight")
        shutil.copytree(tutorial, folder, ignore=shutil.ignore_patterns(
            "[1-9]*", "postProcessing", "log.*", "polyMesh"))
        shutil.copytree(f"{folder}/0.orig", f"{folder}/0", dirs_exist_ok=True)
        control = f"{folder}/system/controlDict"
        with open(control) as file:
            text = re.sub(r"^writeFormat.*", "writeFormat ascii;", file.read(), flags=re.M)
        with open(control, "w") as file:
            file.write(text + "\nwritePrecision 12;\n")
        with open(f"{folder}/log.blockMesh", "w") as log:
            subprocess.run(["blockMesh"], cwd=folder, stdout=log, stderr=log, check=True)
        self.move_points(f"{folder}/constant/polyMesh/points")

    def move_points(self, path):
        with open(path) as file:
            text = file.read()
        head = re.search(r"\n\d+\n\(\n", text).end()
        points = np.array([line.strip("()").split() for line in
                           re.findall(r"\([-+.e\d ]+\)", text[head:])], float)
        inside = (points > points.min(axis=0) + 1e-9) & (points < points.max(axis=0) - 1e-9)
        self.move(points, inside.all(axis=1))
        with open(path, "w") as file:
            file.write(text[:head])
            np.savetxt(file, points, fmt="(%.12g %.12g %.12g)")
            file.write(")\n")
