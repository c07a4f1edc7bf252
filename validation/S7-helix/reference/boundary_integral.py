#!/usr/bin/env python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance of helical filaments in unbounded Stokes flow by a boundary integral,
independent of fsbiFoam; writes helix.csv and convergence.csv beside it.

    ./boundary_integral.py           # 4 min

The traction f on a rigid body that moves with the velocity u is, on its surface,

    u(x) = 1/(8 pi mu) int (I/d + d d/d^3) . f(y) dS(y),    d = x - y.

The surface is exact, a tube around the centreline (R cos s, R sin s,
pitch s/(2 pi)) with hemispheres about its ends. Panels are rectangles of arc length
and angle, with a constant traction, collocated at their centres; integrals are
Gauss's, those over a point's own panel after Duffy's substitution, so that there is
nothing to regularise: the edge of the panels is the one parameter. The limit of
vanishing edges is extrapolated with the order that the three finest meshes show,
and the uncertainty is by how much it differs from that of the three before.

A filament without turns is a sphere, whose resistance is known.

Motion along the axis z and turning about it, with the drift along y that goes with
them, change sign by half a turn about x: one half of the panels is unknown, and
there is no unknown pressure inside. Matrices are of (y, z, turning about z); mu = 1,
R = 1, 5 turns.
"""

import os

import numpy as np

HALF_TURN = np.diag([1.0, -1.0, -1.0])
NEAR = 4                                # panels' sizes, to be integrated better
LEVELS = {2: (4, 6, 8, 10), 1.5: (3, 4, 6), 4: (3, 4, 6), 8: (3, 4, 6)}
QUANTITIES = "yy yz yw a b c axial_only axis_held".split()


class Filament:
    def __init__(self, pitch=2.0, turns=5.0, radius=1.0, filament=0.1):
        self.radius, self.filament, self.turns = radius, filament, turns
        self.rise = pitch / (2 * np.pi)
        self.slope = np.hypot(radius, self.rise)        # arc length per angle
        self.arc = 2 * np.pi * turns * self.slope
        self.curvature = radius / self.slope**2

    def surface(self, sigma, phi):
        """Points, and area per d(sigma) d(phi). sigma: arc length along the
        centreline, goes on over the hemispheres; phi: around, 0 is outside."""
        s = np.clip(sigma, 0, self.arc)
        angle = s / self.slope
        cos, sin, one = np.cos(angle), np.sin(angle), np.ones_like(angle)
        centre = np.stack([self.radius * cos, self.radius * sin,
                           self.rise * angle - self.rise * np.pi * self.turns], -1)
        normal = np.stack([cos, sin, 0 * one], -1)
        tangent = np.stack([-self.radius * sin, self.radius * cos, self.rise * one],
                           -1) / self.slope
        latitude = ((sigma - s) / self.filament)[..., None]
        across = (np.cos(phi)[..., None] * normal
                  + np.sin(phi)[..., None] * np.cross(tangent, normal))
        x = centre + self.filament * (np.cos(latitude) * across + np.sin(latitude) * tangent)
        wound = np.where(sigma == s, 1 + self.curvature * self.filament * np.cos(phi), 1)
        return x, self.filament * np.cos(latitude[..., 0]) * wound

    def panels(self, around):
        """Centres in (sigma, phi) and half widths of the panels of one half."""
        edge = 2 * np.pi * self.filament / around
        cap = np.pi / 2 * self.filament
        rows = max(2, round(cap / edge))
        edges = np.linspace(-cap, 0, rows + 1)
        if self.arc > 0:
            rings = round(self.arc / 2 / edge)
            edges = np.append(edges, np.linspace(0, self.arc / 2, rings + 1)[1:])
        sigma = (edges[1:] + edges[:-1]) / 2
        phi = (np.arange(around) + 0.5) * 2 * np.pi / around
        centres = np.stack(np.meshgrid(sigma, phi, indexing="ij"), -1).reshape(-1, 2)
        half = np.stack(np.meshgrid(np.diff(edges) / 2, np.full(around, np.pi / around),
                                    indexing="ij"), -1).reshape(-1, 2)
        return centres, half


def square(points):
    """Gauss's points and weights of (-1, 1) x (-1, 1)."""
    x, w = np.polynomial.legendre.leggauss(points)
    return (np.stack(np.meshgrid(x, x, indexing="ij"), -1).reshape(-1, 2),
            np.outer(w, w).ravel())


def around_centre(points):
    """The same for integrands that grow as 1/distance towards the centre: four
    triangles that meet there, a square each (Duffy)."""
    x, w = square(points)
    r, t = (x[:, 0] + 1) / 2, x[:, 1]
    corner = [r * 1, r * t], [-r, r * t], [r * t, r], [r * t, -r]
    return (np.concatenate([np.stack(c, -1) for c in corner]), np.tile(w * r / 2, 4))


def integrals(body, x, centres, half, rule):
    """Of the kernel, over panels (m, n) for points x (m, 3) as (m, n, 3, 3), and
    over the panels' images by the half turn, joined to an antisymmetric traction.
    centres and half: (n, 2) or (m, n, 2)."""
    offsets, weights = rule
    at = centres[..., None, :] + half[..., None, :] * offsets
    y, area = body.surface(at[..., 0], at[..., 1])
    area = area * weights * np.prod(half, -1)[..., None]
    result = 0
    for image, sign in ((np.eye(3), 1), (HALF_TURN, -1)):
        d = x[:, None, None] - y @ image
        inverse = 1 / np.linalg.norm(d, axis=-1)
        part = np.einsum("mnqa,mnqb->mnab", d * (area * inverse**3)[..., None], d)
        part += np.sum(area * inverse, -1)[..., None, None] * np.eye(3)
        result = result + sign * part @ image
    return result / (8 * np.pi)


def equations(body, centres, half):
    n = len(centres)
    x, area = body.surface(*centres.T)
    area *= 4 * np.prod(half, -1)
    size = np.sqrt(area).max()
    G = np.empty((n, 3, n, 3))
    for start in range(0, n, 20):
        rows = slice(start, min(start + 20, n))
        G[rows] = integrals(body, x[rows], centres, half, square(2)).swapaxes(1, 2)
        apart = np.linalg.norm(x[rows, None] - x, axis=-1)
        i, j = np.nonzero(apart < NEAR * size)
        # pairs: m of them, one panel each
        near = integrals(body, x[rows][i], centres[j, None], half[j, None], square(12))
        G[start + i, :, j] = near[:, 0]
    own = integrals(body, x, centres[:, None], half[:, None], around_centre(16))
    G[np.arange(n), :, np.arange(n)] = own[:, 0]
    return G.reshape(3 * n, 3 * n), x


def resistance(body, around):
    centres, half = body.panels(around)
    G, x = equations(body, centres, half)
    n = len(x)
    motion = np.zeros((n, 3, 3))
    motion[:, 1, 0] = motion[:, 2, 1] = 1
    motion[:, :, 2] = np.cross([0, 0, 1], x)
    traction = np.linalg.solve(G, motion.reshape(3 * n, 3))
    at, weights = square(4)
    at = centres[:, None] + half[:, None] * at
    y, area = body.surface(at[..., 0], at[..., 1])
    area = area * weights * np.prod(half, -1)[:, None]
    load = np.zeros((n, 3, 3))
    load[:, 1, 0] = load[:, 2, 1] = area.sum(1)
    load[:, :, 2] = np.cross([0, 0, 1], np.sum(area[..., None] * y, 1))
    return 2 * load.reshape(3 * n, 3).T @ traction, 2 * n


def measures(R):
    """F = a u + b w, T = b u + c w along the axis, and the advance per angle: only
    along the axis; with the axis held, drifting as it likes."""
    b = 0.5 * (R[1, 2] + R[2, 1])
    free = np.linalg.solve(R[:2, :2], -R[:2, 2])
    values = R[0, 0], R[0, 1], R[0, 2], R[1, 1], b, R[2, 2], -b / R[1, 1], free[1]
    return dict(zip(QUANTITIES, values))


def limit(h, f):
    """Of f = f0 + C h^p through three meshes."""
    ratio = (f[0] - f[1]) / (f[1] - f[2])
    p = np.linspace(1, 6, 5001)
    made = (h[0]**p - h[1]**p) / (h[1]**p - h[2]**p)
    p = p[np.argmin(np.abs(made - ratio))]
    return f[2] - (f[1] - f[2]) * h[2]**p / (h[1]**p - h[2]**p)


def extrapolated(rows):
    """Limits from the last three meshes; the largest relative change from those of
    the three before, nan if there are no more."""
    h = np.array([1 / row["around"] for row in rows])
    last = {q: limit(h[-3:], [row[q] for row in rows[-3:]]) for q in QUANTITIES}
    if len(rows) < 4:
        return last, np.nan
    before = {q: limit(h[-4:-1], [row[q] for row in rows[-4:-1]]) for q in QUANTITIES}
    return last, max(abs(before[q] / last[q] - 1) for q in QUANTITIES)


def mesh(pitch, around):
    R, panels = resistance(Filament(pitch=pitch), around)
    print(f"pitch {pitch}, {panels} panels, asymmetry {np.abs(R - R.T).max():.1e}",
          flush=True)
    return {"pitch": pitch, "around": around, "panels": panels, **measures(R)}


def write(name, rows):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    with open(path, "w") as file:
        file.write("# boundary_integral.py: mu 1, R 1, filament 0.1, 5 turns\n")
        file.write(",".join(rows[0]) + "\n")
        for row in rows:
            file.write(",".join(f"{value:.8g}" for value in row.values()) + "\n")


if __name__ == "__main__":
    meshes, limits = [], []
    for pitch, levels in LEVELS.items():
        rows = [mesh(pitch, around) for around in levels]
        meshes += rows
        values, uncertainty = extrapolated(rows)
        limits.append({"pitch": pitch, **values, "uncertainty": uncertainty})
    write("convergence.csv", meshes)
    write("helix.csv", limits)
