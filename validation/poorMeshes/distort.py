# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Move the inner points of a saved mesh of tetrahedra at random until its largest
non-orthogonality is near the one wanted, and forget the flow, so that it is solved
from nothing; prints the largest and mean one, degrees.

    distort.py 1e-06 75
"""

import hashlib
import re
import sys

import numpy as np


def lists(path, *kinds):
    """The lists of a binary file of a mesh, one after the other."""
    with open(path, "rb") as file:
        data = file.read()
    at, found = data.index(b"// * *"), []
    for kind in kinds:
        head = re.compile(rb"\n\s*(\d+)\s*\(").search(data, at)
        at = head.end() + int(head[1]) * np.dtype(kind).itemsize
        found.append(np.frombuffer(data[head.end():at], kind))
    return found


def write(path, values):
    """Values over those of the file's first list, in the same place."""
    with open(path, "rb") as file:
        data = file.read()
    at = re.compile(rb"\n\s*\d+\s*\(").search(data, data.index(b"// * *")).end()
    with open(path, "wb") as file:
        file.write(data[:at] + values.tobytes() + data[at + values.nbytes:])


def sign(time, name):
    """A saved state is not read when a file of it has changed; this one has."""
    with open(f"{time}/{name}", "rb") as file:
        data = file.read()
    with open(f"{time}/uniform/checkpoint") as file:
        text = file.read()
    digest = hashlib.sha1(data).hexdigest()
    with open(f"{time}/uniform/checkpoint", "w") as file:
        file.write(re.sub(rf".* {name}\n", f"{digest} {len(data)} {name}\n", text))


class Mesh:
    def __init__(self, folder):
        self.points = lists(f"{folder}/points", "3f8")[0]
        self.faces = lists(f"{folder}/faces", "i4", "i4")[1].reshape(-1, 3)
        self.owner, = lists(f"{folder}/owner", "i4")
        self.neighbour, = lists(f"{folder}/neighbour", "i4")
        cells = np.concatenate([self.owner, self.neighbour])
        faces = np.concatenate([self.faces, self.faces[:len(self.neighbour)]])
        order = np.argsort(cells, kind="stable")
        corners = faces[order].reshape(-1, 12)
        self.tetrahedra = np.array([np.unique(c) for c in corners])
        self.inner = np.ones(len(self.points), bool)
        self.inner[np.unique(self.faces[len(self.neighbour):])] = False
        ends = self.tetrahedra[:, [0, 0, 0, 1, 1, 2]].ravel(), \
            self.tetrahedra[:, [1, 2, 3, 2, 3, 3]].ravel()
        self.edge = np.full(len(self.points), np.inf)
        for a, b in (ends, ends[::-1]):
            np.minimum.at(self.edge, a, np.linalg.norm(np.subtract(*self.points[[a, b]]), axis=1))

    def volumes(self, points):
        a, b, c, d = points[self.tetrahedra.T]
        return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6

    def angles(self, points):
        """Between what joins two cells and the normal of their face, degrees."""
        a, b, c = points[self.faces[:len(self.neighbour)].T]
        normal = np.cross(b - a, c - a)
        centres = points[self.tetrahedra].mean(axis=1)
        d = centres[self.neighbour] - centres[self.owner[:len(self.neighbour)]]
        cosine = np.einsum("ij,ij->i", normal, d) \
            / np.linalg.norm(normal, axis=1) / np.linalg.norm(d, axis=1)
        return np.degrees(np.arccos(cosine))

    def moved(self, part, wanted):
        """Every inner point by up to a part of its shortest edge in each direction;
        back by a tenth, and again, where a cell is worse than wanted or a twentieth of
        its volume."""
        random = np.random.default_rng(1)
        move = part * self.edge[:, None] * random.uniform(-1, 1, self.points.shape)
        move[~self.inner] = 0
        before = self.volumes(self.points)
        for _ in range(200):
            points = self.points + move
            worst = self.volumes(points) / before < 0.05
            angle = self.angles(points)
            for cells in (self.owner[:len(angle)], self.neighbour):
                worst[cells[angle > wanted]] = True
            if not worst.any():
                break
            move[np.unique(self.tetrahedra[worst])] *= 0.9
        return points


def main():
    time, wanted = sys.argv[1], float(sys.argv[2])
    mesh = Mesh(f"{time}/fluid/polyMesh")
    points = mesh.moved(1, wanted)
    for name, values in {"polyMesh/points": points, "polyMesh/referencePoints": points,
                         "U": np.zeros((len(mesh.tetrahedra), 3)),
                         "p": np.zeros(len(mesh.tetrahedra))}.items():
        write(f"{time}/fluid/{name}", values)
        sign(time, f"fluid/{name}")
    angles = mesh.angles(points)
    print(f"{angles.max():.2f} {angles.mean():.2f}")


if __name__ == "__main__":
    main()
