# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The force on all outer boundaries of a Stokes flow, from the fields U and p
that a run wrote in ascii, and the mesh: nothing of the solver is used.

The flow is a linear shear (a uniform stress, whose sum over a closed boundary
is zero) and a disturbance u, p, which vanishes on the patches of given velocity
and has no traction on the others. At a wall the traction of the disturbance is
mu du/dn - p n. Pressure and derivative come from least squares over the cells
around a face, with d the distance from the wall, s and t along it:

    p linear in d, s, t: the cells at the face's vertices,
    u/d quadratic in d, s, t: these, and those at their vertices.

The error falls with the square of the cells' size: that of the pressure."""

import re

import numpy as np

from fsbi import fields


def _list(path):
    """The rows of a list of labels, or of faces."""
    with open(path) as file:
        text = file.read()
    start = re.search(r"\n(\d+)\s*\n\(", text)
    body = text[start.end():text.index("\n)", start.end())].strip()
    return np.array([re.sub(r"^\d+\(|\)", "", row).split() for row in body.split("\n")],
                    int)


def _patches(path):
    with open(path) as file:
        found = re.findall(r"(\w+)\s*\{[^}]*?nFaces\s+(\d+);\s*startFace\s+(\d+);",
                           file.read())
    return {name: range(int(start), int(start) + int(n)) for name, n, start in found}


def linear(d, s, t):
    return [np.ones_like(d), d, s, t]


def quadratic(d, s, t):
    return [*linear(d, s, t), d * d, d * s, d * t, s * s, s * t, t * t]


def first(columns, weight, values):
    """The first coefficient of a weighted fit."""
    values = values.reshape(len(weight), -1)
    fit = np.linalg.lstsq(columns * weight, values * weight, rcond=1e-6)[0][0]
    return fit if len(fit) > 1 else fit[0]


class TetrahedralFlow:
    """Mesh and disturbance of a saved time of region fluid."""

    def __init__(self, folder, rate):
        mesh = folder + "/polyMesh/"
        self.points = fields.points(mesh + "points")
        self.faces = _list(mesh + "faces")
        self.owner = _list(mesh + "owner")[:, 0]
        self.patches = _patches(mesh + "boundary")
        neighbour = _list(mesh + "neighbour")[:, 0]
        pairs = [(self.owner, self.faces), (neighbour, self.faces[:len(neighbour)])]
        self.p = fields.internal(folder + "/p")[:, 0]
        corners = [set() for _ in self.p]
        for cells, faces in pairs:
            for cell, face in zip(cells, faces):
                corners[cell].update(face)
        if any(len(c) != 4 for c in corners):
            raise ValueError(folder + ": not all cells are tetrahedra")
        self.corners = np.array([list(c) for c in corners])
        self.centres = self.points[self.corners].mean(axis=1)
        self.u = fields.internal(folder + "/U")
        self.u[:, 0] -= rate * self.centres[:, 1]
        self.around = [set() for _ in self.points]
        for cell, c in enumerate(corners):
            for vertex in c:
                self.around[vertex].add(cell)

    def cells_at(self, vertices):
        return sorted(set().union(*(self.around[v] for v in vertices)))

    def seen(self, cells, x, frame, powers):
        """Rows of a fit over cells around a face; their weights and distances."""
        r = (self.centres[cells] - x.mean(axis=0)) @ frame.T
        weight = 1 / np.linalg.norm(r, axis=1)[:, None]
        return np.stack(powers(*r.T), axis=1), weight, r[:, :1]

    def traction(self, face, mu):
        """Of the disturbance on a face of given velocity, times its area."""
        x = self.points[self.faces[face]]
        S = 0.5 * np.cross(x[1] - x[0], x[2] - x[0])
        area = np.linalg.norm(S)
        n, along = S / area, (x[1] - x[0]) / np.linalg.norm(x[1] - x[0])
        frame = np.stack([-n, along, np.cross(n, along)]) / np.sqrt(area)
        near = self.cells_at(self.faces[face])
        wide = self.cells_at(np.unique(self.corners[near]))
        near_rows, near_weight, _ = self.seen(near, x, frame, linear)
        p = first(near_rows, near_weight, self.p[near])
        rows, weight, d = self.seen(wide, x, frame, quadratic)
        slope = first(rows * d, weight**2, self.u[wide]) / np.sqrt(area)
        slope -= n * (n @ slope)                    # no flow through the wall
        return -mu * slope * area - p * S


def wall_force(folder, rate, mu, walls):
    """Sum of the tractions on the patches of given velocity."""
    flow = TetrahedralFlow(folder, rate)
    return sum(flow.traction(face, mu) for name in walls for face in flow.patches[name])
