# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shape of a rolling leukocyte and the paths of its material.

    cell = Leukocyte(radius=4, Ax=1, Ay=0.1, By=0.4)
    x = cell.path(history, "leukocyte", angle=0.5)      # of a material point
    part = cell.part_backward(V=1.2e-4, omega=3e-5)     # exact, of a turn
"""

import numpy as np
from scipy.optimize import brentq


class Leukocyte:
    def __init__(self, radius, Ax, Ay, By):
        self.radius, self.Ax, self.Ay, self.By = radius, Ax, Ay, By

    def image(self, p):
        """Of points (n, 3) of the sphere about the origin [3.12-3.14]."""
        x, y, z = np.asarray(p).T
        squeeze = np.where(y < 0, self.By * np.cos(np.pi * x / (8 * self.radius)), self.Ay)
        return np.stack([x + self.Ax * np.cos(np.pi * x / (2 * self.radius)),
                         (1 - squeeze) * y, z], axis=1)

    def circle(self, angles):
        """Points of the sphere in the middle plane."""
        angles = np.atleast_1d(angles)
        return self.radius * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)

    def path(self, history, body, angle):
        """Places of the material point that starts at this angle in the middle
        plane, at the times of the history; the shape is not turned."""
        centre = history[f"bodies/{body}/position"].array[:, 1:]
        q = history[f"bodies/{body}/orientation"].array[:, 1:]
        p = self.circle(angle)
        w, v = q[:, :1], q[:, 1:]
        turned = p + 2 * np.cross(v, np.cross(v, p) + w * p)
        return centre + self.image(turned)

    def velocity(self, angle, V, omega):
        """Along x of a material point now at this angle, V and omega given;
        omega > 0 carries the top along x."""
        k = np.pi / (2 * self.radius)
        x, y, _ = self.circle(angle).T
        return V + omega * y * (1 - k * self.Ax * np.sin(k * x))

    def part_backward(self, V, omega):
        """Part of the time for which the point moves against x: between the
        roots of its velocity; the angle runs at a constant rate."""
        angles = np.linspace(0, 2 * np.pi, 3601) + 1e-4
        positive = self.velocity(angles, V, omega) > 0
        part = np.sum(np.diff(angles)[~positive[:-1] & ~positive[1:]])
        for i in np.nonzero(positive[:-1] != positive[1:])[0]:
            root = brentq(lambda a: self.velocity(a, V, omega)[0], *angles[i:i + 2], xtol=1e-15)
            part += angles[i + 1] - root if positive[i] else root - angles[i]
        return part / (2 * np.pi)
