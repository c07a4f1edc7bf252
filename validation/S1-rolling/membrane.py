# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways of the membrane of a rolling cell from the velocities at the faces of the
fluid's mesh, without knowledge of the map that made them.

    membrane = Membrane(run, "leukocyte", V=1.2e-4)
    membrane.turn, membrane.backward        # time; part of it against V
"""

import glob

import numpy as np

POINTS, FACES = 3600, 16        # of the outline; faces that a point is fitted to


class Membrane:
    def __init__(self, run, body, V):
        sampled = glob.glob(f"{run.folder}/postProcessing/membrane/*/U_{body}.raw")
        x, y, z, *u = np.loadtxt(max(sampled, key=lambda f: float(f.split("/")[-2]))).T
        x, y, z = np.array([x, y, z]) - run.position(body)[-1][:, None]
        self.V, self.run = V, run
        self._outline(x, y, z, u[0] - V, u[1])
        step = np.linalg.norm(np.roll(self.at, -1, 0) - np.roll(self.at, 1, 0), axis=1) / 2
        self.time = step / np.linalg.norm(self.velocity, axis=1)
        self.turn = self.time.sum()
        self.backward = self.time[V + self.velocity[:, 0] < 0].sum() / self.turn
        self.upward = self.time[self.velocity[:, 1] > 0].sum() / self.turn

    def _outline(self, x, y, z, u, v):
        """Places and velocities in the plane z = 0, about the centre and relative to
        it: at each angle a parabola through the nearest faces of the same half (the
        speed jumps at y = 0), even in z."""
        values, around, size = np.column_stack([x, y, u, v]), np.arctan2(y, x), np.ptp(y)
        angles = (np.arange(POINTS) + 0.5) * 2 * np.pi / POINTS
        fitted = np.empty((POINTS, 4))
        for i, angle in enumerate(angles):
            ahead = (around - angle + np.pi) % (2 * np.pi) - np.pi
            far = np.where((y > 0) == (angle < np.pi), np.hypot(size * ahead, z), np.inf)
            n = np.argsort(far)[:FACES]
            basis = np.column_stack([np.ones(FACES), ahead[n], ahead[n]**2, (z[n] / size)**2])
            fitted[i] = np.linalg.lstsq(basis, values[n], rcond=None)[0][0]
        self.at, self.velocity = fitted[:, :2], fitted[:, 2:]

    @property
    def place(self):
        """Angles on the sphere, in degrees: the part of the turn that is left to
        where the outline begins, in front; a cell that rolls along x."""
        return 360 * (np.cumsum(self.time) - self.time / 2) / self.turn

    def path(self, start, times):
        """Ways from an angle (degrees), the centre at the origin at time 0. The
        membrane goes down in front: through the outline backwards."""
        gone = np.cumsum(self.time) - self.time / 2
        now = (start / 360 * self.turn - times) % self.turn
        x, y = (np.interp(now, gone, c, period=self.turn) for c in self.at.T)
        return np.column_stack([x + self.V * times, y])
