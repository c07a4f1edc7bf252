# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A quarter of a square plate with a round hole, for gmshToFoam, on the standard
output: a box bent around the hole, tetrahedra of its hexahedra.

    plate_mesh.py SIDE RADIUS THICKNESS NRADIAL NAROUND NTHICK

Its x is the way from the hole (patch x0) to the outer sides (x1), y the angle, from
the plane y = 0 (patch y0) to x = 0 (y1), z itself.
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.environ["FSBI_DIR"], "validation"))
import box_mesh                                                 # noqa: E402

GROWTH = 6              # of edges from the hole to the sides


def bend(points, side, radius, thickness):
    """Of the unit cube; near the hole cells are as long as wide."""
    s = (GROWTH**points[:, 0] - 1) / (GROWTH - 1)
    angle = np.pi / 2 * points[:, 1]
    ray = np.array([np.cos(angle), np.sin(angle)])
    outer = side * ray / np.abs(ray).max(axis=0)
    x, y = (1 - s) * radius * ray + s * outer
    return np.array([x, y, thickness * points[:, 2]]).T


def main(side, radius, thickness, *cells):
    cells = np.array(cells, int)
    cube = box_mesh.vertices(np.ones(3), cells, 0)
    volumes = box_mesh.elements(cells, True)
    points = bend(cube, float(side), float(radius), float(thickness))
    # on planes to the last digit
    points[np.abs(points) < 1e-12] = 0
    box_mesh.write(points, box_mesh.outward(points, volumes),
                   box_mesh.boundary(cube, volumes, np.ones(3)))


if __name__ == "__main__":
    main(*sys.argv[1:])
