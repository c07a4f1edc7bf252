# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""L2 error of the velocity around a sphere: of the cells' means, from a case
written in binary."""

import os
import re

import numpy as np
from scipy.special import roots_jacobi

import bodies


def quadrature(n=3):
    """Barycentric points and weights in a tetrahedron, exact up to degree 2 n - 1: Gauss
    points of a cube, collapsed."""
    (x, a), (y, b), (z, c) = (roots_jacobi(n, k, 0) for k in (2, 1, 0))
    x, y, z = np.meshgrid((1 + x) / 2, (1 + y) / 2, (1 + z) / 2, indexing="ij")
    y, z = y * (1 - x), z * (1 - x) * (1 - y)
    weights = a[:, None, None] * b[:, None] * c
    return (np.stack((1 - x - y - z, x, y, z), axis=-1).reshape(-1, 4),
            weights.ravel() / weights.sum())


def values(path, kind, lists=1):
    """The first lists of a binary file."""
    with open(path, "rb") as file:
        content = file.read()
    found, place = [], content.index(b"// * *")
    for _ in range(lists):
        start = re.compile(rb"\n(\d+)\n?\(").search(content, place)
        size = np.dtype(kind).itemsize * int(start[1])
        place = start.end() + size
        found.append(np.frombuffer(content[start.end():place], kind))
    return found


def corners(mesh):
    """Of all tetrahedra."""
    faces = values(f"{mesh}/faces", "i4", 2)[1].reshape(-1, 3)
    owner, neighbour = (values(f"{mesh}/{n}", "i4")[0] for n in ("owner", "neighbour"))
    order = np.argsort(np.concatenate((owner, neighbour)), kind="stable")
    points = np.concatenate((faces, faces[:len(neighbour)]))[order].reshape(-1, 12)
    # every point of a cell is in three of its faces
    return np.sort(points)[:, ::3]


def cells_with(name, folder, kind="f8"):
    """Corners and a field of all cells at the last time."""
    mesh = f"{folder}/0/fluid/polyMesh"
    x = values(f"{mesh}/points", "3f8")[0][corners(mesh)]
    time = max((t for t in os.listdir(folder) if re.match(r"[0-9.e-]+$", t)), key=float)
    return x, values(f"{folder}/{time}/fluid/{name}", kind)[0]


def volumes_of(x):
    return np.abs(np.linalg.det(x[:, 1:] - x[:, :1])) / 6


def velocity_error(folder, radius, speed):
    """Root mean square over the far velocity."""
    x, u = cells_with("U", folder, "3f8")
    x, u = x / radius, u / speed
    exact = sum(weight * bodies.stokes(np.einsum("i,cij->cj", point, x))
                for point, weight in zip(*quadrature()))
    return np.sqrt(np.average(np.sum((u - exact) ** 2, axis=1), weights=volumes_of(x)))
