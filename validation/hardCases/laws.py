# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws that hold of every finished run, whatever its scene, checked on the
recorded history with nothing but the scene and mechanics:

- all numbers are finite, the end is reached;
- rigid bodies: the forces and torques of fluid, loads and effects are the rate
  of change of the momentum (zero without inertia), where nothing is prescribed;
  what is prescribed is kept; elastic bodies: the forces sum to zero;
- a body goes where its velocity says; its orientation is a rotation;
- rigid bodies in a fluid at rest or that flows as one: the power they give to it
  is between what theory allows at least and at most (theory.py); in all scenes
  no speed is above the flow's and what all loads can do without walls;
- an elastic body: the work of its loads is the change of its energy; in a fluid
  at rest energy is only lost;
- what bonds and magnets record of themselves is what acted on the bodies;
- bodies keep clear of each other and of the walls; with contact by its gap at least,
  and in a fluid at rest it only loses energy; an elastic body keeps its
  volume as its bulk modulus wants, no cell is inside out.

What of this a scene does not allow to judge is said: run.skip.
"""

import numpy as np

from laws_of_contact import contact
from laws_of_motion import balance, drag, held, motion, speeds
from laws_of_state import bonds, budget, decay, magnets, volume
from record import Run


def broken_laws(scene, folder, said):
    """(verdict, why, what could not be judged)"""
    run = Run(scene, folder, said)
    for path in run.history.paths():
        if not np.isfinite(run.history[path].array).all():
            return "nan", path, []
    if not len(run.time):
        if "Interrupted at" in said:
            return "right", "", ["no step in the time given"]
        if run.skipped:
            return "right", "", run.skipped
        return "silent", "no step recorded", []
    # an elastic body alone, on a mesh that is given, has a check of its own
    for law in LAWS if scene.bodies else (end,):
        wrong = law(run)
        # what the run has told by itself is not silent
        if wrong and not (law is volume and "linearElastic is for strains" in said):
            return "silent", f"{law.__name__}: {wrong}", run.skipped
    return "right", "", run.skipped


def end(run):
    if (np.diff(run.time) <= 0).any():
        return "time does not increase"
    if run.ended >= run.scene.end * (1 - 1e-6) or "All bodies have left" in run.said:
        return ""
    if "Interrupted at" not in run.said:
        return f"ended at {run.ended:g} of {run.scene.end:g}"
    run.skip("interrupted before the end")
    return ""


def inner(run, body):
    """Radius of a ball about the centre that stays inside the body."""
    if body.shape["type"] in ("helix", "leukocyte"):
        return 0.0
    if body.elastic:
        return 0.8 * run.vectors(body, "semiAxes")[:, 2] - body.sag
    return body.a - body.sag


def clearance(run):
    low, high = run.scene.flow.low, -run.scene.flow.low
    for i, body in enumerate(run.scene.bodies):
        x, r = run.centre(body), inner(run, body)
        room = np.minimum(x - low, high - x)
        if "follow" in run.scene.remesh:
            room = room[:, 1:]
        if (room.min(axis=1) < r).any():
            return f"{body.name} is in a wall"
        for other in run.scene.bodies[:i]:
            apart = np.linalg.norm(x - run.centre(other), axis=1)
            if (apart < r + inner(run, other)).any():
                return f"{body.name} is in {other.name}"
    return ""


LAWS = (end, held, balance, motion, speeds, drag, clearance, volume, budget, decay, bonds,
        magnets, contact)
