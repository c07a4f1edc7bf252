# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A round tube along x as an STL file, as CAD programs write it: triangles as long
as the tube. Usage: tube_surface.py FILE RADIUS HALF_LENGTH"""

import sys

import numpy as np

from fsbi import stl

AROUND = 256        # a regular polygon's section is 1e-4 smaller than the circle's


def triangles(*corners):
    return np.stack(np.broadcast_arrays(*corners), axis=1)


def solids(radius, half):
    angle = np.linspace(0, 2 * np.pi, AROUND + 1)[:-1]
    ring = np.column_stack([0 * angle, radius * np.cos(angle), radius * np.sin(angle)])
    after = np.roll(ring, -1, axis=0)
    left, right = np.array([-half, 0, 0]), np.array([half, 0, 0])
    walls = [triangles(ring + left, after + left, after + right),
             triangles(ring + left, after + right, ring + right)]
    return {"capillary": np.concatenate(walls),
            "inlet": triangles(left, after + left, ring + left),
            "outlet": triangles(right, ring + right, after + right)}


def main():
    stl.write(sys.argv[1], solids(float(sys.argv[2]), float(sys.argv[3])))


if __name__ == "__main__":
    main()
