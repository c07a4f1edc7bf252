# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The triangulated spheres of a run: how far they stand off the true ones, and
the gaps and speeds of approach of their triangles, computed anew from the
recorded motion."""

import numpy as np


def triangles_of(path):
    """Corners in a binary STL file."""
    rows = np.fromfile(path, np.uint8)[84:].reshape(-1, 50)
    return rows[:, 12:48].copy().view("<f4").reshape(-1, 3, 3).astype(float)


def rotations(quaternions):
    """Matrices of rows (w x y z)."""
    w, x, y, z = quaternions.T
    return np.moveaxis(np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]), 2, 0)


def nearest(x, corners):
    """Of points x (n, 3) and of each one's own triangles (n, k, 3, 3): vectors
    from the triangles' nearest points to x."""
    x = x[:, None]
    a, b, c = np.moveaxis(corners, 2, 0)
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=2)[..., None]
    foot = x - np.sum((x - a) * normal, axis=2)[..., None] * normal
    inside = np.ones(foot.shape[:2], bool)
    ends = []
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.sum(np.cross(q - p, foot - p) * normal, axis=2) >= 0
        along = np.sum((x - p) * (q - p), axis=2) / np.sum((q - p)**2, axis=2)
        ends.append(x - p - np.clip(along, 0, 1)[..., None] * (q - p))
    ends = np.array(ends)
    best = np.argmin(np.linalg.norm(ends, axis=3), axis=0)
    away = np.take_along_axis(ends, best[None, ..., None], axis=0)[0]
    return np.where(inside[..., None], x - foot, away)


class Sphere:
    """One of a run, with what was recorded of it."""

    def __init__(self, run, name, radius, start):
        self.radius = radius
        self.position = run.position(name)
        self.velocity = run.velocity(name)
        self.spin = run.spin(name)
        self.turn = rotations(run.history[f"bodies/{name}/orientation"].array[:, 1:])
        self.corners = triangles_of(f"{run.folder}/{name}.stlb") - start
        centres = self.corners.mean(axis=1)
        a, b, c = np.moveaxis(self.corners, 1, 0)
        normals = np.cross(b - a, c - a)
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        # least distances of triangles' centres and planes from the middle;
        # largest distance of a corner from its triangle's centre
        self.centres = np.linalg.norm(centres, axis=1).min()
        self.planes = np.abs(np.sum(a * normals, axis=1)).min()
        self.width = np.linalg.norm(self.corners - centres[:, None], axis=2).max()

    def placed(self, i):
        return self.corners @ self.turn[i].T + self.position[i]

    def speed(self, i, x):
        return self.velocity[i] + np.cross(self.spin[i], x - self.position[i])


def gap_behind_triangles(minimum, sphere, other=None):
    """The least gap of true spheres, or of a sphere and a wall, when the centre
    of no triangle is nearer than the minimum to the other's triangles.

    The line of centres meets a triangle of the sphere, whose centre is at most
    its width w from there and at least r from the sphere's middle: along the
    line it is at least q = sqrt(r^2 - w^2) from it, beside it at most w. The
    other's triangles enclose a ball of the radius of their planes, R'. So that
    centre is at most sqrt((D - q)^2 + w^2) - R' from them, which must be above
    the minimum.
    """
    w = sphere.width
    q = np.sqrt(sphere.centres**2 - w**2)
    if other is None:
        return minimum + q - sphere.radius
    distance = q + np.sqrt((minimum + other.planes)**2 - w**2)
    return distance - sphere.radius - other.radius


def time_to_contact(i, sphere, other, among=16, tie=1e-5):
    """The shortest, over the sphere's triangles, of gap over speed. The other's
    speed is that of the nearest triangle's centre; where several are nearest,
    in a corner or an edge, the slowest approach of theirs."""
    centres, corners = sphere.placed(i).mean(axis=1), other.placed(i)
    middles = corners.mean(axis=1)
    apart = np.linalg.norm(centres[:, None] - middles, axis=2)
    near = np.argpartition(apart, among, axis=1)[:, :among]
    away = nearest(centres, corners[near])
    gaps = np.linalg.norm(away, axis=2)
    gap = gaps.min(axis=1)
    closing = other.speed(i, middles[near]) - sphere.speed(i, centres)[:, None]
    speeds = np.sum(closing * away, axis=2) / gaps
    speed = np.where(gaps < gap[:, None] + tie, speeds, np.inf).min(axis=1)
    return np.min(gap[speed > 0] / speed[speed > 0], initial=np.inf)


def time_to_wall(i, sphere):
    """Beside the wall y = 0."""
    centres = sphere.placed(i).mean(axis=1)
    speed = -sphere.velocity[i, 1] - np.cross(sphere.spin[i],
                                              centres - sphere.position[i])[:, 1]
    return np.min(centres[:, 1][speed > 0] / speed[speed > 0], initial=np.inf)
