# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random scenes of rigid bodies near each other and near walls, which loads press
together and shear drags along, with contact: fuzz.py --pressed. Nothing in them is a
reason to stop."""

import numpy as np

from drawing import Draw, draw_shape, loads, pushed
from scene import Body, Flow, Scene


def draw_scene(seed):
    draw = Draw(seed)
    viscosity = draw.decades(-1, 1)
    speed = draw.decades(-5, -2)            # um/us, of loads that drive a body alone
    size = draw.random.uniform(2, 4)        # um, of bodies
    flow = Flow(draw.one("rest", "rest", "shear", "uniform", "Poiseuille"),
                half=draw.one((16, 16, 16), (24, 12, 16), (24, 16, 12)),
                viscosity=viscosity, walls=True)
    flow.rate = 0 if flow.kind == "rest" else draw.decades(-1, 0.5) * speed / size
    scene = Scene(flow, step=draw.decades(-2, 1) * size / speed,
                  steps=int(draw.random.integers(3, 6)), adjust=draw.chance(0.3),
                  growth=draw.random.uniform(0.7, 1))
    if scene.adjust and draw.chance(0.5):
        scene.controls["maxApproach"] = 0.2
    for n in range(draw.one(1, 1, 2, 2, 2, 3)):
        add_body(draw, scene, f"body{n}", size, speed)
    while not scene.bodies:
        add_body(draw, scene, "body0", size, speed)
    force = max(loads(scene, b)[0] for b in scene.bodies)
    least = min(b.a for b in scene.bodies)
    gap = draw.decades(-2.3, -1.5) * least
    reach = gap * draw.one(0.5, 1, 2)
    scene.effects["contact"] = dict(
        gap=gap, range=reach,
        pressure=draw.decades(-2, 2) * 5 * force / (np.pi * size * reach))
    keep_inside(scene)
    return scene


def add_body(draw, scene, name, size, speed):
    """As near to a wall or to the body before as 0.03 to 0.3 radii, mostly pressed there."""
    radius = size * draw.random.uniform(0.7, 1.3)
    shape = draw_shape(draw, radius)
    if shape["shape"] == "ellipsoid":
        shape["semiAxes"] = radius * draw.random.uniform(0.7, 1.2, 3)
    body = Body(name, overdamped=True, **shape)
    body.shape["size"] = 0.45 * body.a
    if shape["shape"] == "leukocyte":
        body.shape["size"] = 0.4 * radius
    if draw.chance(0.5):
        body.entries["orientation"] = (draw.direction(), draw.random.uniform(0, 3))
    gap = draw.decades(-1.5, -0.5) * body.a
    found = place(draw, scene, body, gap)
    if found is None:
        return                          # others have taken all the room there is
    body.position, towards = found
    if draw.chance(0.3):
        towards = draw.direction()
    mu = scene.flow.viscosity
    body.entries["force"] = draw.decades(-1, 1) * 19 * mu * radius * speed * towards
    if draw.chance(0.3):
        # such as turns a body alone by a radian in a step at most: more is told as not
        # resolved
        most = min(10**0.5 * radius**2 * speed, radius**3 / scene.step)
        body.entries["torque"] = draw.decades(-1.5, 0) * 25 * mu * most * draw.direction()
    scene.add(body)


def place(draw, scene, body, gap):
    """And the direction to what it is near."""
    half = scene.flow.half
    closed = np.flatnonzero(~scene.flow.open_axes)
    for _ in range(1000):
        towards = np.zeros(3)
        if scene.bodies and draw.chance(0.7):
            other = draw.one(*scene.bodies)
            towards = draw.direction()
            at = other.position - (other.R + body.R + gap) * towards
        else:
            at = draw.random.uniform(-half / 2, half / 2)
            axis = draw.one(*closed)
            towards[axis] = draw.one(-1, 1)
            at[axis] = towards[axis] * (half[axis] - body.R - gap)
        room = np.where(scene.flow.open_axes, 2.5 * body.R, body.R + 0.9 * gap)
        if ((half - np.abs(at) > room).all()
                and all(np.linalg.norm(at - b.position) > b.R + body.R + 0.9 * gap
                        for b in scene.bodies)):
            return at, towards
    return None


def keep_inside(scene):
    """Shorten steps so that the flow and all loads cannot bring a body to a side that it
    may leave by."""
    openings = scene.flow.open_axes
    if openings.any():
        room = min((scene.flow.half - np.abs(b.position) - 1.5 * b.R)[openings].min()
                   for b in scene.bodies)
        scene.step = min(scene.step, room / (pushed(scene) * scene.steps))


def may_stop(scene):
    return ""
