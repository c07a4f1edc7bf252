# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces for the tests of fsbiDomain, as STL files.

    surfaces.py FILE box|hollow|open|crossed

A box of 4 by 3 by 2 with its corner in the origin, whose faces are solids of their
own; hollow: with a cube of edge 1 inside that fluid flows around; open: without
the face zmax; crossed: a corner pulled through the face xmin."""

import sys

import numpy as np

from fsbi import stl

FACES = {               # corners by bits x, y, z; turned outward
    "xmin": (0, 4, 6, 2), "xmax": (1, 3, 7, 5), "ymin": (0, 1, 5, 4),
    "ymax": (2, 6, 7, 3), "zmin": (0, 2, 3, 1), "zmax": (4, 5, 7, 6),
}


def box(low, high, inward=False):
    corner = [np.where([c & 1, c & 2, c & 4], high, low) for c in range(8)]
    solids = {}
    for name, (a, b, c, d) in FACES.items():
        pair = [(a, b, c), (a, c, d)]
        solids[name] = [[corner[i] for i in (t[::-1] if inward else t)] for t in pair]
    return solids


path, kind = sys.argv[1:3]
solids = box([0, 0, 0], [4, 3, 2])
if kind == "hollow":
    post = box([1, 1, 0.5], [2, 2, 1.5], inward=True)
    solids["post"] = [t for face in post.values() for t in face]
elif kind == "open":
    del solids["zmax"]
elif kind == "crossed":
    for face in solids.values():
        for triangle in face:
            for i, corner in enumerate(triangle):
                if np.all(corner == [4, 3, 2]):
                    triangle[i] = np.array([-1, 1.5, 1])

stl.write(path, solids)
