#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stokes flow around spheres of radius 1 in a cube with themselves at its sides.

    array_drag(0.125)           # drag of a simple cubic array over 6 pi mu a U, U: the
                                # mean velocity of fluid and spheres
    crowd_drag(phi, centres)    # the same of several spheres in a cube
    between_walls(5.0)          # stresslet and spin of a free sphere between sliding walls
                                # as far apart as the cube is wide, over those alone

Forces on a sphere within the body, as strong as no slip at points of the surface asks
for by least squares (method of fundamental solutions). Each is one of a lattice of
forces: Hasimoto's (J. Fluid Mech. 5, 1959), summed as Ewald did. Walls: what the
lattice does to them is taken back by flows between two planes, exact for every wave
along the walls. Nothing but Stokes' equations is in common with fsbiFoam. Digits that
do not change with `sources`, `depth` and `waves` are right. Viscosity 1.

    periodic_flow.py            # writes reference.csv
"""

import sys

import numpy as np
from scipy.special import erfc

PHI = (0.027, 0.125, 0.343)
BOXES = (5.0, 7.0, 10.0)


def on_sphere(count):
    """Points evenly spread: a spiral."""
    z = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + np.sqrt(5)) * np.arange(count)
    return np.column_stack([np.sqrt(1 - z * z) * np.cos(turn),
                            np.sqrt(1 - z * z) * np.sin(turn), z])


def near_part(d, xi):
    """What a screened force does: blocks (points, forces, 3, 3)."""
    r2 = np.sum(d * d, axis=-1)[..., None, None]
    r = np.sqrt(r2)
    bell = np.exp(-xi * xi * r2) * xi / np.sqrt(np.pi)
    dyad = d[..., :, None] * d[..., None, :]
    return 2 * (bell / r2 + erfc(xi * r) / (2 * r2 * r)) * (r2 * np.eye(3) + dyad) \
        - 4 * bell * np.eye(3)


def grid_of(reach):
    n = np.arange(-reach, reach + 1)
    return np.stack(np.meshgrid(n, n, n, indexing="ij"), -1).reshape(-1, 3)


def far_part(x, y, box, xi):
    k = 2 * np.pi / box * grid_of(6)
    k = k[np.any(k != 0, axis=1)]
    k2 = np.sum(k * k, axis=1)
    size = (1 + k2 / (4 * xi * xi)) / k2**2 * np.exp(-k2 / (4 * xi * xi))
    blocks = (k2[:, None, None] * np.eye(3) - k[:, :, None] * k[:, None, :]) \
        * size[:, None, None]
    there, here = np.exp(1j * x @ k.T), np.exp(-1j * k @ y.T)
    found = np.empty((len(x), len(y), 3, 3))
    for i in range(3):
        for j in range(3):
            found[:, :, i, j] = ((there * blocks[:, i, j]) @ here).real
    return 8 * np.pi / box**3 * found


def lattice(x, y, box):
    """Velocities at x by forces of one at y and its images: matrix (3x, 3y)."""
    xi = 3.5 / box
    blocks = far_part(x, y, box, xi)
    d = x[:, None] - y[None]
    d -= box * np.round(d / box)
    for image in box * grid_of(1):
        blocks += near_part(d + image, xi)
    return flat(blocks) / (8 * np.pi)


def flat(blocks):
    m, n = blocks.shape[:2]
    return blocks.transpose(0, 2, 1, 3).reshape(3 * m, 3 * n)


def least_squares(matrix, given):
    return np.linalg.lstsq(matrix, given, rcond=1e-13)[0]


def mirrored(x):
    """Places of forces in all octants, and the signs of their components in a flow
    along x: one that turns round when it is seen in a mirror across it."""
    for sign in np.array(np.meshgrid(*[(1, -1)] * 3)).reshape(3, 8).T:
        yield x * sign, np.array([1, sign[0] * sign[1], sign[0] * sign[2]])


def array_drag(phi, sources=1200, depth=0.82):
    box = (4 * np.pi / (3 * phi))**(1 / 3)
    points, forces = (x[np.all(x > 0, axis=1)] for x in
                      (on_sphere(2 * sources), depth * on_sphere(sources)))
    matrix = sum(lattice(points, y, box) * np.tile(sign, len(y)) for y, sign in mirrored(forces))
    given = np.tile([-1.0, 0, 0], len(points))
    strength = least_squares(matrix, given).reshape(-1, 3)
    return -8 * strength[:, 0].sum() / (6 * np.pi)


def crowd_drag(phi, centres, sources=190, depth=0.68):
    """Mean over spheres of the component along the flow."""
    box = (4 * np.pi * len(centres) / (3 * phi))**(1 / 3)
    points, forces = ((centres[:, None] + x).reshape(-1, 3) for x in
                      (on_sphere(2 * sources), depth * on_sphere(sources)))
    given = np.tile([-1.0, 0, 0], len(points))
    strength = least_squares(lattice(points, forces, box), given).reshape(-1, 3)
    return -strength[:, 0].sum() / len(centres) / (6 * np.pi)


class Walls:
    """Flows in -h < z < h by waves along the walls, the same velocity on both:
    u = w + z grad psi, w and psi harmonic, div w = -d psi/dz."""

    def __init__(self, box, waves):
        self.box, self.waves, self.h = box, waves, box / 2
        place = box * np.arange(waves) / waves
        x, y = np.meshgrid(place, place, indexing="ij")
        self.points = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel() + self.h])
        k = 2 * np.pi * np.fft.fftfreq(waves, box / waves)
        self.kx, self.ky = (c.ravel() for c in np.meshgrid(k, k, indexing="ij"))

    def spectrum(self, on_wall):
        """Amplitudes (3, waves^2, columns) of velocities at the points."""
        n = self.waves
        values = on_wall.reshape(n, n, 3, -1)
        return np.moveaxis(np.fft.fft2(values, axes=(0, 1)) / n**2, 2, 0).reshape(3, n * n, -1)

    def inside(self, on_wall, x):
        u = self.spectrum(on_wall)
        k = np.hypot(self.kx, self.ky)
        k[0] = 1
        h, z = self.h, x[:, 2:]
        t = np.tanh(k * h)
        even = np.exp(k * (abs(z) - h)) * (1 + np.exp(-2 * k * abs(z))) / (1 + np.exp(-2 * k * h))
        odd = np.sign(z) * np.exp(k * (abs(z) - h)) * (1 - np.exp(-2 * k * abs(z))) \
            / (1 - np.exp(-2 * k * h))
        column = (slice(None), None)
        along = self.kx[column] * u[0] + self.ky[column] * u[1]
        b = -1j * (t / k)[column] * along / (1 - h * k / t + h * k * t)[column]
        a = -u[2] / (1 - h * k * t + h * k / t)[column]
        wave = np.exp(1j * (x[:, :1] * self.kx + x[:, 1:2] * self.ky))
        even, odd = wave * even, wave * odd
        even[:, 0], odd[:, 0] = 1, 0        # the mean moves with the walls
        found = [even @ (u[i] - 1j * h * (m[column] * b)) + (z * odd) @ (1j * m[column] * b)
                 + (z * even - h * odd) @ (1j * m[column] * a)
                 for i, m in enumerate((self.kx, self.ky))]
        found.append(even @ (u[2] - (h * k * t)[column] * a) + (z * odd) @ ((k * t)[column] * a)
                     + (z * even - h * odd) @ ((k / t)[column] * b))
        return np.stack(found, axis=1).real.reshape(3 * len(x), -1)


def cross(x):
    """Matrices (points, 3, 3) of w -> w cross x."""
    o = 0 * x[:, 0]
    return np.stack([np.stack([o, x[:, 2], -x[:, 1]], -1), np.stack([-x[:, 2], o, x[:, 0]], -1),
                     np.stack([x[:, 1], -x[:, 0], o], -1)], 1)


def between_walls(box, sources=160, depth=0.65, waves=14):
    """In a shear flow z along x."""
    points, forces = on_sphere(2 * sources), depth * on_sphere(sources)
    walls = Walls(box, waves)
    matrix = lattice(points, forces, box) - walls.inside(lattice(walls.points, forces, box), points)
    rigid = np.concatenate([np.tile(np.eye(3), (len(points), 1)), cross(points).reshape(-1, 3)], 1)
    # neither force nor torque
    free = np.concatenate([np.tile(np.eye(3), len(forces)), np.hstack(cross(forces))])
    free = np.concatenate([free, np.zeros((6, 6))], 1)
    shear = np.zeros_like(points)
    shear[:, 0] = -points[:, 2]
    found = least_squares(np.concatenate([np.concatenate([matrix, -rigid], 1), 1e3 * free]),
                          np.concatenate([shear.ravel(), np.zeros(6)]))
    strength = found[:-6].reshape(-1, 3)
    moment = forces.T @ strength
    return -(moment[0, 2] + moment[2, 0]) / 2 / (10 / 3 * np.pi), found[-2] / 0.5


def main():
    rows = [("array", phi, array_drag(phi), np.nan) for phi in PHI]
    rows.append(("crowd", 0.15, crowd_drag(0.15, np.loadtxt("crowd.txt")), np.nan))
    rows += [("walls", box, *between_walls(box)) for box in BOXES]
    with open("reference.csv", "w") as file:
        file.write("# By periodic_flow.py. Arrays, crowd: volume fraction, drag over 6 pi mu a U.\n"
                   "# Walls: width over a, stresslet over (10/3) pi mu a^3 g, spin over g/2\n"
                   "kind,of,value,spin\n")
        file.writelines(f"{kind},{of:g},{value:.7g},{spin:.7g}\n"
                        for kind, of, value, spin in rows)


if __name__ == "__main__":
    sys.exit(main())
