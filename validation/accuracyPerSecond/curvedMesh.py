# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tetrahedra with curved sides around a body, by gmsh, for finite elements.

Middles of edges on curved surfaces and curves are put on those; all other edges
are straight. gmsh's own setOrder does the same in as many seconds as it meshes.
"""

import gmsh
import numpy as np

import bodies

LINE, TRIANGLE, TETRAHEDRON = 1, 2, 4   # gmsh's numbers
# corners that the ten nodes' last six are between, in gmsh's order
ENDS = np.array([(0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3)])


def generate(body, size, growth):
    for option, value in (("General.Terminal", 0), ("General.NumThreads", 1),
                          ("Mesh.MeshSizeExtendFromBoundary", 0),
                          ("Mesh.MeshSizeFromPoints", 0)):
        gmsh.option.setNumber(option, value)
    bodies.in_box(body)
    bodies.set_sizes(body, size, growth)
    gmsh.model.mesh.generate(3)


class Edges:
    """Numbers of the edges of cells; found again by their ends."""

    def __init__(self, cells):
        self.points = int(cells.max()) + 1
        self.keys, first, inverse = np.unique(
            self._key(cells[:, ENDS]).ravel(), return_index=True, return_inverse=True)
        self.of_cells = inverse.reshape(-1, 6)
        self.ends = cells[:, ENDS].reshape(-1, 2)[first]

    def _key(self, pairs):
        return pairs.min(axis=-1) * self.points + pairs.max(axis=-1)

    def between(self, pairs):
        return np.searchsorted(self.keys, np.unique(self._key(pairs)))


def curve(body, middles, edges, number):
    """Surfaces first: where they meet, the edges' middles are on the curve."""
    moved = []
    closest = bodies.CLOSEST.get(body)
    for dimension, kind, corners, flat in (
            (2, TRIANGLE, 3, "Plane"), (1, LINE, 2, "Line")):
        for _, tag in gmsh.model.getEntities(dimension):
            if gmsh.model.getType(dimension, tag) == flat:
                continue
            nodes = gmsh.model.mesh.getElementsByType(kind, tag)[1]
            nodes = number[nodes].reshape(-1, corners)
            pairs = np.concatenate([nodes[:, [i, (i + 1) % corners]] for i in range(corners)])
            found = edges.between(pairs)
            if closest:
                middles[found] = closest(middles[found])
            else:
                points, _ = gmsh.model.getClosestPoint(dimension, tag, middles[found].ravel())
                middles[found] = np.reshape(points, (-1, 3))
            moved.append(found)
    return np.unique(np.concatenate(moved)) if moved else np.array([], int)


def shape_gradients():
    """Of the ten nodes in their places: where a curved cell folds first."""
    barycentric = np.vstack((np.eye(4), np.eye(4)[ENDS].mean(axis=1)))
    slope = np.vstack((-np.ones(3), np.eye(3)))
    corners = (4 * barycentric - 1)[:, :, None] * slope
    i, j = ENDS.T
    middles = 4 * (barycentric[:, i, None] * slope[j] + barycentric[:, j, None] * slope[i])
    return np.concatenate((corners, middles), axis=1)


def unfold(points, cells, middles, edges, moved):
    """Pull middles towards their chords until no cell is, nearly, turned inside out:
    one doubles the iterations."""
    suspects = np.flatnonzero(np.isin(edges.of_cells, moved).any(axis=1))
    gradients = shape_gradients()
    for _ in range(8):
        nodes = np.concatenate(
            (points[cells[suspects]], middles[edges.of_cells[suspects]]), axis=1)
        jacobians = np.linalg.det(np.einsum("cni,pnj->cpij", nodes, gradients))
        bad = jacobians.min(axis=1) < 0.05 * np.abs(jacobians).mean(axis=1)
        if not bad.any():
            return
        pulled = np.unique(edges.of_cells[suspects[bad]])
        middles[pulled] = (middles[pulled] + points[edges.ends[pulled]].mean(axis=1)) / 2


def curved_mesh(body, size, growth):
    """Points, and the ten of every cell in gmsh's order."""
    gmsh.initialize()
    generate(body, size, growth)
    tags, points, _ = gmsh.model.mesh.getNodes()
    points = points.reshape(-1, 3)
    number = np.zeros(int(tags.max()) + 1, np.int64)
    number[tags] = np.arange(len(tags))
    cells = number[gmsh.model.mesh.getElementsByType(TETRAHEDRON)[1]].reshape(-1, 4)
    edges = Edges(cells)
    middles = points[edges.ends].mean(axis=1)
    moved = curve(body, middles, edges, number)
    gmsh.finalize()
    unfold(points, cells, middles, edges, moved)
    return (np.concatenate((points, middles)),
            np.concatenate((cells, len(points) + edges.of_cells), axis=1))
