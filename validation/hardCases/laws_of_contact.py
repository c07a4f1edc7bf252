# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of surfaces that touch: functions of a Run (record.py) that return what is
wrong, or nothing. See laws.py."""

import numpy as np

from record import rotation


def spread(n=4000):
    """Points all over a sphere, 0.06 radii from each other."""
    k = np.arange(n) + 0.5
    z, turn = 1 - 2 * k / n, np.pi * (1 + np.sqrt(5)) * k
    r = np.sqrt(1 - z**2)
    return np.array([r * np.cos(turn), r * np.sin(turn), z]).T


SPREAD = spread()


def described(body):
    """Points of the described surface, body axes; None: of a leukocyte."""
    s = body.shape
    if s["type"] == "sphere":
        return s["radius"] * SPREAD
    if s["type"] == "ellipsoid":
        return np.array(s["semiAxes"]) * SPREAD
    if s["type"] == "capsule":
        return s["radius"] * SPREAD + np.sign(SPREAD[:, 2:]) * [0, 0, s["length"] / 2]
    return None


def inside(body, x):
    """Are these points, body axes, in the described body?"""
    s = body.shape
    if s["type"] == "ellipsoid":
        return (x / np.array(s["semiAxes"]))**2 @ np.ones(3) < 1
    along = np.clip(x[:, 2], -s.get("length", 0) / 2, s.get("length", 0) / 2)
    return np.linalg.norm(x - np.outer(along, [0, 0, 1]), axis=1) < s["radius"]


def overlaps(run):
    """bound: a body in another by 4e-4 of a radius has one of the points inside."""
    low, high = run.scene.flow.low, -run.scene.flow.low
    closed = ~run.scene.flow.open_axes
    for body in run.rigid:
        points = described(body)
        if points is None:
            run.skip("overlaps of leukocytes")
            continue
        others = [b for b in run.rigid if b is not body and described(b) is not None]
        turns = {b.name: rotation(run.vectors(b, "orientation")) for b in [body, *others]}
        for n, (centre, R) in enumerate(zip(run.centre(body), turns[body.name])):
            x = centre + points @ R.T
            if ((x < low) | (x > high))[:, closed].any():
                return f"{body.name} is in a wall"
            for other in others:
                there = (x - run.centre(other)[n]) @ turns[other.name][n]
                if inside(other, there).any():
                    return f"{body.name} is in {other.name}"
    return ""


def contact(run):
    if "contact" not in run.scene.effects:
        return ""
    table = run.history["effects/contact/nearest"]
    gap = run.scene.effects["contact"]["gap"]
    if (table["distance"] <= gap).any():
        return f"surfaces are {table['distance'].min():.3g} apart, less than the gap {gap:.3g}"
    return overlaps(run) or loss(run, table)


def loss(run, table):
    """In a fluid at rest the energy of contact and of the loads, which do not change,
    falls by what the fluid takes.

    bound: Euler's method, of bodies in contact, loses more, as contact's energy is
    convex; BDF2's goes on against the fluid by a third of the way before, with the
    work of the fluid's force. Contact's forces are within 1e-3 of the largest, and
    its parts of triangles within 0.15^2 of the energy."""
    if run.scene.flow.kind != "rest" or not all(b.overdamped for b in run.rigid):
        return ""
    by_loads, by_fluid, roughly = 0, 0, 0
    for body in run.rigid:
        way, turn = run.way(body), run.turn(body)
        for name, step in (("force", way), ("torque", turn)):
            by_loads = by_loads + (run.vectors(body, f"{name}/applied") * step).sum(axis=1)
            by_fluid = by_fluid + (run.vectors(body, f"{name}/fluid") * step).sum(axis=1)
        roughly = roughly + 1e-3 * table["force"] * (
            np.linalg.norm(way, axis=1) + body.R * np.linalg.norm(turn, axis=1))
    energy = table["energy"]
    rise = np.diff(energy) - by_loads[1:]
    allowed = (np.maximum(by_fluid, 0) + roughly)[1:]
    allowed = allowed + 0.15**2 * np.maximum(energy[1:], energy[:-1])
    if (rise > allowed).any():
        n = np.argmax(rise - allowed)
        return f"energy rises by {rise[n]:.3g}, allowed {allowed[n]:.3g}"
    return ""
