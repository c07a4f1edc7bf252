# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What random scenes have in common: choices of a seed, shapes, and how fast the loads
on a scene's bodies can make them."""

import numpy as np

import theory


class Draw:
    """Random choices of one seed."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def decades(self, low, high):
        return 10 ** self.random.uniform(low, high)

    def chance(self, part):
        return self.random.random() < part

    def one(self, *choices):
        return choices[self.random.integers(len(choices))]

    def direction(self):
        x = self.random.normal(size=3)
        return x / np.linalg.norm(x)


def draw_shape(draw, radius):
    kind = draw.one("sphere", "sphere", "ellipsoid", "capsule", "leukocyte")
    if kind == "sphere":
        return dict(shape=kind, radius=radius, size=radius * draw.one(0.35, 0.45))
    if kind == "ellipsoid":
        return dict(shape=kind, semiAxes=radius * draw.random.uniform(0.5, 1.3, 3))
    if kind == "capsule":
        return dict(shape=kind, radius=0.6 * radius, length=radius, size=0.35 * radius)
    return dict(shape=kind, radius=radius, size=0.4 * radius)


def loads(scene, body):
    """Largest force and torque that may drive a body."""
    def size(key):
        return np.linalg.norm(body.entries.get(key, (0, 0, 0)))
    force, torque = size("force") + size("bodyForce") * 4.2 * body.R**3, size("torque")
    magnets = scene.effects.get("magnetics", {})
    if body.name in magnets.get("bodies", {}):
        # as of a saturated body; A m2, T, and what that is in pg, um and us
        moment = 1e4 * 4.2e-18 * body.R**3 * 1e15
        fields = magnets["fields"]
        torque += moment * max(np.linalg.norm(fields["main"].get("B", 0)),
                               fields["main"].get("magnitude", 0))
        force += moment * fields.get("pull", {}).get("axial", 0) * 1e-6
    return force, torque


def pushed(scene):
    """Speed that the flow, the loads and what is given at most make."""
    mu = scene.flow.viscosity
    speed = theory.speed(mu, [(b.a - b.sag, *loads(scene, b)) for b in scene.bodies],
                         min(b.a - b.sag for b in scene.bodies))
    for body in scene.bodies:
        for key, arm in (("velocity", 1), ("angularVelocity", body.R)):
            for given in (body.constraints, body.entries):
                speed += arm * np.linalg.norm(given.get(key, (0, 0, 0)))
    return speed + scene.flow.fastest
