#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A box for gmshToFoam, on the standard output.

    box_mesh.py tetrahedra|moved LX LY LZ NX NY NZ

Vertices inside and on the sides are moved at random by up to 15 % of a cell's
edges, those on a side along it. tetrahedra: six around the long diagonal of
every hexahedron. moved: the hexahedra themselves.
"""

import itertools
import sys

import numpy as np

PATCHES = ["x0", "x1", "y0", "y1", "z0", "z1"]


def vertices(lengths, cells, share=0.15):
    random = np.random.default_rng(1)
    axes = [np.arange(n + 1) for n in cells]
    index = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    inside = (index > 0) & (index < cells)
    moved = index + share * random.uniform(-1, 1, index.shape) * inside
    return moved * lengths / cells


def elements(cells, tetrahedra):
    """Vertices of the cells, numbered from 0."""
    def number(i):
        return (i[0] * (cells[1] + 1) + i[1]) * (cells[2] + 1) + i[2]

    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
               (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    unit = np.eye(3, dtype=int)
    found = []
    for i in itertools.product(*map(range, cells)):
        if not tetrahedra:
            found.append([number(np.add(i, c)) for c in corners])
            continue
        for a, b, c in itertools.permutations(range(3)):
            path = np.cumsum([i, unit[a], unit[b], unit[c]], axis=0)
            found.append([number(p) for p in path])
    return np.array(found)


def outward(points, cells):
    """Tetrahedra with positive volume."""
    if cells.shape[1] == 4:
        x = points[cells]
        volume = np.einsum("ij,ij->i", x[:, 1] - x[:, 0],
                           np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 0]))
        cells[volume < 0] = cells[volume < 0][:, [0, 2, 1, 3]]
    return cells


def boundary(points, cells, lengths):
    """(patch, vertices) of every face on a side of the box."""
    if cells.shape[1] == 4:
        faces = [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)]
    else:
        faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6),
                 (0, 4, 7, 3), (1, 2, 6, 5)]
    for face in faces:
        these = cells[:, face]
        for axis in range(3):
            for end in range(2):
                on = np.isclose(points[these][:, :, axis],
                                end * lengths[axis]).all(axis=1)
                for vertices in these[on]:
                    yield 2 * axis + end, vertices


def write(points, volumes, faces):
    """On the standard output; faces: as of boundary()."""
    faces = list(faces)
    print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7")
    for i, name in enumerate(PATCHES):
        print(f'2 {i + 1} "{name}"')
    print(f'3 7 "inside"\n$EndPhysicalNames\n$Nodes\n{len(points)}')
    for i, point in enumerate(points):
        print(i + 1, *(f"{x:.16g}" for x in point))
    print(f"$EndNodes\n$Elements\n{len(faces) + len(volumes)}")
    surfaces = [(patch + 1, face) for patch, face in faces]
    inside = [(7, cell) for cell in volumes]
    for i, (group, these) in enumerate(surfaces + inside):
        shape = (2 if len(these) == 3 else 3) if group < 7 else \
            (4 if len(these) == 4 else 5)
        print(i + 1, shape, 2, group, group, *(these + 1))
    print("$EndElements")


def main(kind, *numbers):
    lengths = np.array(numbers[:3], float)
    cells = np.array(numbers[3:], int)
    points = vertices(lengths, cells)
    volumes = outward(points, elements(cells, kind == "tetrahedra"))
    write(points, volumes, boundary(points, volumes, lengths))


if __name__ == "__main__":
    main(*sys.argv[1:])
