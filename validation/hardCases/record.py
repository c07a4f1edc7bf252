# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The recorded run of a scene, as its laws want to see it: a row per step.

What no law could judge is noted: run.skip(why)."""

import os
import re

import numpy as np

from fsbi.history import History

NONE = np.zeros((1, 3))


class Run:
    def __init__(self, scene, folder, said):
        self.scene, self.folder, self.said = scene, folder, said
        self.history = History(f"{folder}/postProcessing/history.h5")
        self.skipped = []
        self.ended = self._last("cost")
        self._with_all()
        self.time = self.history["cost"]["time"]
        self.dt = np.diff(self.time, prepend=0.0)
        self.rigid = [b for b in scene.bodies if not b.elastic]
        self.soft = [b for b in scene.bodies if b.elastic]

    def _with_all(self):
        """Only the rows before the first body has left, as the run has told."""
        gone = [b for b in self.scene.bodies
                if f"Body '{b.name}' leaves through patch" in self.said]
        if not gone:
            return
        last = min(self._last(f"{self.path(b)}/{'centre' if b.elastic else 'position'}")
                   for b in gone)
        self.skip("a body leaves: what comes then is not judged")
        for path in self.history.paths():
            table = self.history[path]
            table.array = table.array[table.array[:, 0] <= last]

    def _last(self, path):
        """Time of the last row; before all times if there is none."""
        times = self.history[path]["time"] if path in self.history else []
        return times[-1] if len(times) else -np.inf

    def skip(self, why):
        if why not in self.skipped:
            self.skipped.append(why)

    def vectors(self, body, quantity):
        """Zero if it is not recorded."""
        path = f"{self.path(body)}/{quantity}"
        if path not in self.history:
            return np.zeros((len(self.time), 3))
        return self.history[path].array[:, 1:]

    @staticmethod
    def path(body):
        return f"{'elasticBodies' if body.elastic else 'bodies'}/{body.name}"

    def centre(self, body):
        return self.vectors(body, "centre" if body.elastic else "position")

    def velocity(self, body):
        """Of an elastic body's centre the mean in the step, from the second row
        on; in the first it is left at zero."""
        if not body.elastic:
            return self.vectors(body, "velocity")
        gone = np.diff(self.centre(body), axis=0)
        return np.vstack([NONE, gone / self.dt[1:, None]])

    def spin(self, body):
        return self.vectors(body, "angularVelocity")

    def column(self, body, table, name):
        return self.history[f"{self.path(body)}/{table}"][name]

    def fluid(self, body):
        """Force and torque of the fluid; the torque on an elastic body is not
        recorded, and zero here."""
        if body.elastic:
            return self.vectors(body, "fluidForce"), np.zeros((len(self.time), 3))
        return self.vectors(body, "force/fluid"), self.vectors(body, "torque/fluid")

    def effects(self, body):
        return self.vectors(body, "force/effects"), self.vectors(body, "torque/effects")

    def magnet(self, body):
        """Its table, or None."""
        path = f"effects/magnetics/{body.name}"
        return self.history[path] if path in self.history else None

    def anew(self, body):
        """Rows that the integrator begins anew: the first, and three after a turn
        that changes by more than half a radian from one step to the next."""
        start = np.array(body.entries.get("angularVelocity", (0, 0, 0)), float)
        spin = np.vstack([start, self.spin(body)])
        found, accepted = [], 0
        for dt, change in zip(self.dt, np.diff(spin, axis=0)):
            found.append(accepted <= 0)
            accepted = -2 if np.linalg.norm(dt * change) > 0.5 else accepted + 1
        return np.array(found) | self.straight(body)

    def straight(self, body):
        """Rows in which a body has gone as its last velocity says, as Euler's method has
        it where contact has stopped a body."""
        if "contact" not in self.scene.effects:
            return np.zeros(len(self.dt), bool)
        v = self.velocity(body)
        off = self.way(body) - self.dt[:, None] * v
        return np.linalg.norm(off, axis=1) <= 1e-9 * np.linalg.norm(self.centre(body), axis=1)

    def way(self, body):
        return np.diff(self.centre(body), axis=0, prepend=body.position[None, :])

    def turn(self, body):
        """Rotation vectors of the steps."""
        axis, angle = body.entries.get("orientation", ((1, 0, 0), 0))
        first = np.array([[np.cos(angle / 2), *np.sin(angle / 2) * np.array(axis)]])
        q = np.vstack([first, self.vectors(body, "orientation")])
        a, b = q[:-1], q[1:]
        w = (a * b).sum(axis=1)
        v = (a[:, :1] * b[:, 1:] - b[:, :1] * a[:, 1:] - np.cross(b[:, 1:], a[:, 1:]))
        v *= np.where(w < 0, -1, 1)[:, None]
        size = np.linalg.norm(v, axis=1)
        angle = 2 * np.arctan2(size, np.abs(w))
        return v * (angle / np.maximum(size, 1e-300))[:, None]

    def typical_speed(self):
        """Of all that the solver has to do with: flow, loads, also those of magnets
        before they turned, what is prescribed."""
        mu = self.scene.flow.viscosity
        speed = self.scene.flow.fastest
        for body in self.scene.bodies:
            force, torque = self.fluid(body)
            force = np.linalg.norm(force, axis=1) + np.linalg.norm(
                self.effects(body)[0], axis=1)
            speed += force.max(initial=0) / (6 * np.pi * mu * body.a)
            speed += np.abs(torque).max(initial=0) / (8 * np.pi * mu * body.a**2)
            magnet = self.magnet(body)
            if magnet is not None:
                m, B = (np.linalg.norm([magnet[k + i] for i in "xyz"], axis=0) for k in "mB")
                speed += 1e15 * (m * B).max(initial=0) / (8 * np.pi * mu * body.a**2)
            for key, arm in (("velocity", 1), ("angularVelocity", body.R)):
                for given in (body.constraints, body.entries):
                    speed += arm * np.linalg.norm(given.get(key, (0, 0, 0)))
        return speed

    def mass(self, body):
        """Mass, inertia about the centre in body axes: from the triangles of
        the saved state."""
        points, triangles = surface(self.folder, body.name)
        density = body.entries["density"]
        p, q, r = (points[triangles[:, i]] for i in range(3))
        volume = np.einsum("ij,ij->i", p, np.cross(q, r)) / 6
        second = sum(np.einsum("n,ni,nj->ij", volume, u, v) * (2 if u is v else 1)
                     for u in (p, q, r) for v in (p, q, r)) / 20
        return (density * volume.sum(),
                density * (np.trace(second) * np.eye(3) - second))


def surface(folder, body):
    """Points and triangles of a rigid body, body axes."""
    times = [n for n in os.listdir(folder) if re.fullmatch(r"[0-9.e+-]+", n)]
    with open(os.path.join(folder, max(times, key=float), "uniform", "fsbiState"),
              errors="replace") as file:
        text = file.read()
    mine = re.split(rf"^    {body}$", text, maxsplit=1, flags=re.M)[1]
    points, triangles = (re.search(rf"^ +{name} +\d+ (.*);$", mine, re.M)[1]
                         for name in ("points", "triangles"))
    return (np.array(re.findall(r"[-+0-9.e]+", points), float).reshape(-1, 3),
            np.array(re.findall(r"\d+", triangles), int).reshape(-1, 3))


def rotation(q):
    """Matrices of quaternions (w x y z), body axes to the laboratory's."""
    w, x, y, z = q.T
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
                    ).transpose(2, 0, 1)


def rate_of_change(dt, values, start, anew):
    """By BDF2 of variable step, by BDF1 where the integrator begins anew."""
    values = np.vstack([start, values])
    rate = np.empty_like(values[1:])
    for i, step in enumerate(dt):
        new, old = values[i + 1], values[i]
        if anew[i]:
            rate[i] = (new - old) / step
            continue
        r = step / dt[i - 1]
        rate[i] = ((1 + 2 * r) / (1 + r) * new - (1 + r) * old
                   + r * r / (1 + r) * values[i - 1]) / step
    return rate
