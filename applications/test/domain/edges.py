# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths of the walls' edges in a domain that is finer for |x| below a half.

Usage: edges.py CASE FINER SIZE HALF"""

import os
import sys

import numpy as np
from vtk_case import Case, corners, points

GROWTH = 0.3            # of the size with the distance from the box


def walls(case):
    """Both ends of every edge of the walls' triangles, twice but for borders."""
    with open(os.path.join(case, "domain.foam"), "w"):
        pass
    for _, patches in Case(case).at(0).values():
        for name, patch in patches.items():
            if name not in ("inlet", "outlet"):
                t = points(patch)[corners(patch)]
                yield np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])


def main():
    case, finer, size, half = sys.argv[1], *map(float, sys.argv[2:])
    edges = np.concatenate(list(walls(case)))
    length = np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1)
    x = np.abs(edges.mean(axis=1)[:, 0])
    wanted = np.minimum(size, finer + GROWTH * np.maximum(x - half, 0))
    for name, part in (("in the box", x < half), ("away from it", x > half)):
        ratio = length[part] / wanted[part]
        print(f"{name} {part.sum()} edges, of the wanted length on average "
              f"{ratio.mean():.3f}, at most {ratio.max():.3f}")
        if abs(ratio.mean() - 1) > 0.2 or ratio.max() > 1.6:
            sys.exit(1)


if __name__ == "__main__":
    main()
