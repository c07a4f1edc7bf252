# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws that hold of every finished run, whatever its scene, checked on the
recorded history with nothing but the scene and mechanics:

- all numbers are finite, the end is reached;
- a free overdamped rigid body: all forces and torques sum to zero; with inertia
  they sum to the rate of change of its momentum;
- a free elastic body: the forces sum to zero;
- a body goes where its velocity says; its orientation is a rotation;
- speeds are bounded by the flow's and by what the loads could do without
  hindrance: walls and other bodies only slow a body down (least dissipation);
- bodies keep clear of each other and of the walls;
- an elastic body keeps its volume as its bulk modulus wants, no cell is
  inside out, its energy is not negative;
- in a fluid at rest energy is only lost; without loads nothing moves.
"""

import re

import numpy as np

from fsbi.history import History

# of the largest force or torque: what the solver may leave. Its tolerance is
# of the residual, which counts whole rows of the system
BALANCE = 1e-3
SLACK = 1.2                 # on bounds of speeds: facets, coarse cells


def broken_laws(scene, folder):
    """(verdict, why)"""
    history = History(f"{folder}/postProcessing/history.h5")
    for path in history.paths():
        if not np.isfinite(history[path].array).all():
            return "nan", path
    with open(f"{folder}/log.fsbiFoam", errors="replace") as log:
        said = log.read()
    interrupted = "Interrupted at" in said
    laws = () if interrupted else (end,)
    if not len(times(history)):
        return ("right", "no step done in the time given") if interrupted else \
            ("silent", "no step recorded")
    for law in (*laws, balance, motion, speeds, clearance, elastic, dissipation):
        wrong = law(scene, history)
        # what the run has told by itself is not silent
        if wrong and not (law is elastic and "linearElastic is for strains" in said):
            return "silent", f"{law.__name__}: {wrong}"
    return "right", ""


def vectors(history, path):
    return history[path].array[:, 1:]


def times(history):
    return history["cost"]["time"]


def end(scene, history):
    reached = times(history)
    if not len(reached) or abs(reached[-1] / scene.end - 1) > 1e-6 and \
            reached[-1] < scene.end:
        return f"ended at {reached[-1] if len(reached) else 0:g} of {scene.end:g}"
    if (np.diff(reached) <= 0).any():
        return "time does not increase"
    return ""


# What the scene asks for

def rigid(scene):
    return [b for b in scene.bodies if not b.elastic]


def soft(scene):
    return [b for b in scene.bodies if b.elastic]


def loads(scene, body):
    """Applied force and torque, constant."""
    return (np.array(body.entries.get("force", (0, 0, 0)), float),
            np.array(body.entries.get("torque", (0, 0, 0)), float))


def magnetic(history, body, kind):
    path = f"effects/magnetics/{body.name}"
    if path not in history:
        return 0.0
    return np.array([history[path][kind + i] for i in "xyz"]).T


def springs(scene):
    """Are there effects that are recorded as no force on a body?"""
    return any(name in scene.effects for name in ("bonds", "repulsion"))


def rate_of_change(time, values):
    """By BDF2 of variable step, the first by BDF1, as the integrator has it."""
    dt = np.diff(time, prepend=0.0)
    rate = np.empty_like(values)
    for i in range(len(time)):
        old = values[i - 1] if i else None
        if i < 2:
            rate[i] = 0 if old is None else (values[i] - old) / dt[i]
            continue
        r = dt[i] / dt[i - 1]
        c = np.array([(1 + 2 * r) / (1 + r), -(1 + r), r * r / (1 + r)])
        rate[i] = (c[0] * values[i] + c[1] * old + c[2] * values[i - 2]) / dt[i]
    return rate


def balance(scene, history):
    if springs(scene):
        return ""
    for body in rigid(scene):
        if body.constraints or not body.overdamped:
            continue
        wrong = rigid_balance(scene, history, body)
        if wrong:
            return wrong
    for body in soft(scene):
        if "held" in body.entries:
            continue
        path = f"elasticBodies/{body.name}/"
        parts = [vectors(history, path + "fluidForce"), vectors(history, path + "tether"),
                 magnetic(history, body, "f"), body_force(body, history)]
        largest = max(np.abs(p).max() for p in parts)
        rest = np.abs(sum(parts)).max()
        least = scale(scene, body, history)
        if rest > tolerated(history, body) * max(largest, least):
            return f"forces on {body.name} sum to {rest:.3g} of {largest:.3g}"
    return ""


def scale(scene, body, history):
    """Forces in the scene that the solver sees beside this body's own."""
    size = 6 * np.pi * scene.flow.viscosity * body.a
    speed = scene.flow.fastest
    for other in scene.bodies:
        force, torque = loads(scene, other)
        size_of = 6 * np.pi * scene.flow.viscosity * other.a
        speed += np.linalg.norm(force) / size_of
        speed += np.linalg.norm(torque) / (size_of * other.a)
        speed += np.abs(magnetic(history, other, "f")).max() / size_of
        speed += np.abs(magnetic(history, other, "t")).max() / (size_of * other.a)
        speed += np.linalg.norm(other.entries.get("bodyForce", (0, 0, 0))) * other.a**3 \
            / size_of
        for key, arm in (("velocity", 1), ("angularVelocity", other.R)):
            speed += arm * np.linalg.norm(other.constraints.get(key, (0, 0, 0)))
            speed += arm * np.linalg.norm(other.entries.get(key, (0, 0, 0)))
    return size * speed


def body_force(body, history):
    force = np.array(body.entries.get("bodyForce", (0, 0, 0)), float)
    if not force.any():
        return np.zeros((1, 3))
    volume = 4 / 3 * np.pi * body.R**3      # spheres only, of triangles a little less
    return np.broadcast_to(volume * force, (len(times(history)), 3))


def tolerated(history, body):
    """A magnet's load is recorded where bodies are at the end of the step; what
    acted in it is that, by its derivatives, from where they were put first."""
    return 0.05 if f"effects/magnetics/{body.name}" in history else BALANCE


def rigid_balance(scene, history, body):
    path = f"bodies/{body.name}/"
    for kind, short in (("force", "f"), ("torque", "t")):
        parts = [vectors(history, path + f"{kind}/fluid"),
                 vectors(history, path + f"{kind}/applied"), magnetic(history, body, short)]
        largest = max(np.abs(p).max() for p in parts)
        least = scale(scene, body, history) * (body.a if kind == "torque" else 1)
        bound = tolerated(history, body) * max(largest, least)
        rest = np.abs(sum(parts))
        if np.ndim(parts[2]):
            # a magnet's torque is linear in a step: balanced if it turns little
            turn = np.linalg.norm(vectors(history, path + "angularVelocity"), axis=1) \
                * np.diff(times(history), prepend=0.0)
            rest = rest[turn < 0.2]
        rest = rest.max(initial=0)
        if rest > bound:
            return f"{kind}s on {body.name} sum to {rest:.3g} of {largest:.3g}"
    return ""


def motion(scene, history):
    dt = np.diff(times(history), prepend=0.0)[1:, None]
    for body in rigid(scene):
        path = f"bodies/{body.name}/"
        q = vectors(history, path + "orientation")
        if np.abs(np.linalg.norm(q, axis=1) - 1).max() > 1e-9:
            return f"the quaternion of {body.name} is none"
        x, v = vectors(history, path + "position"), vectors(history, path + "velocity")
        if len(x) < 2:
            continue
        gone = np.abs(np.diff(x, axis=0) - dt * v[1:])
        allowed = 4 * dt * (np.abs(np.diff(v, axis=0)).max() + 1e-6 * np.abs(v).max())
        if (gone > allowed + 1e-9 * body.R).any():
            return f"{body.name} does not go where its velocity says"
    return ""


def hindered(scene, history):
    """Largest speed that all loads together could cause."""
    total = 0.0
    mu = scene.flow.viscosity
    for body in scene.bodies:
        force, torque = loads(scene, body)
        f = np.linalg.norm(force) + np.abs(magnetic(history, body, "f")).max() * 2
        t = np.linalg.norm(torque) + np.abs(magnetic(history, body, "t")).max() * 2
        t += np.abs(body_force(body, history)).max() * 0
        f += np.linalg.norm(body_force(body, history)[0])
        total += f / (6 * np.pi * mu * body.a) + t / (8 * np.pi * mu * body.a**2)
        for key, arm in (("velocity", 1), ("angularVelocity", body.R)):
            total += arm * np.linalg.norm(body.constraints.get(key, (0, 0, 0)))
            if not body.overdamped and not body.elastic:
                total += arm * np.linalg.norm(body.entries.get(key, (0, 0, 0)))
    return total


def speeds(scene, history):
    if springs(scene):
        return ""
    bound = SLACK * (scene.flow.fastest + hindered(scene, history))
    if not bound:
        bound = 1e-12
    for body in rigid(scene):
        v = vectors(history, f"bodies/{body.name}/velocity")
        w = vectors(history, f"bodies/{body.name}/angularVelocity")
        fastest = max(np.linalg.norm(v, axis=1).max(),
                      body.a * np.linalg.norm(w, axis=1).max())
        if fastest > bound:
            return f"{body.name} has a speed of {fastest:.3g}, bound {bound:.3g}"
    dt = np.diff(times(history), prepend=0.0)[1:, None]
    for body in soft(scene):
        x = vectors(history, f"elasticBodies/{body.name}/centre")
        if len(x) > 1:
            fastest = np.linalg.norm(np.diff(x, axis=0) / dt, axis=1).max()
            if fastest > 2 * bound:
                return f"{body.name} has a speed of {fastest:.3g}, bound {bound:.3g}"
    return ""


def centres(history, body):
    if body.elastic:
        return vectors(history, f"elasticBodies/{body.name}/centre")
    return vectors(history, f"bodies/{body.name}/position")


def inner(history, body):
    """Radius of a ball about the centre that stays inside the body."""
    if body.shape["type"] in ("helix", "leukocyte"):
        return 0.0
    if body.elastic:
        return 0.8 * vectors(history, f"elasticBodies/{body.name}/semiAxes")[:, 2] - body.sag
    return body.a - body.sag


def clearance(scene, history):
    low, high = scene.flow.low, -scene.flow.low
    follow = "follow" in scene.remesh
    for i, body in enumerate(scene.bodies):
        x, r = centres(history, body), inner(history, body)
        room = np.minimum(x - low, high - x)
        if follow:
            room = room[:, 1:]
        if (room.min(axis=1) < r).any():
            return f"{body.name} is in a wall"
        for other in scene.bodies[:i]:
            apart = np.linalg.norm(x - centres(history, other), axis=1)
            if (apart < r + inner(history, other)).any():
                return f"{body.name} is in {other.name}"
    return ""


def pressure(scene, history):
    """What may press on a body: the flow, and all forces on one patch."""
    found = 6 * scene.flow.stress
    for body in scene.bodies:
        force, torque = loads(scene, body)
        found += (np.linalg.norm(force) / body.a**2 + np.linalg.norm(torque) / body.a**3
                  + np.abs(magnetic(history, body, "f")).max() / body.a**2
                  + np.abs(magnetic(history, body, "t")).max() / body.a**3
                  + np.linalg.norm(body.entries.get("bodyForce", (0, 0, 0))) * body.R)
        for key, length in (("velocity", body.a), ("angularVelocity", 1)):
            found += 10 * scene.flow.viscosity / length * np.linalg.norm(
                body.constraints.get(key, (0, 0, 0)))
    return found


def elastic(scene, history):
    for body in soft(scene):
        path = f"elasticBodies/{body.name}/"
        if (history[path + "deformation"]["minJ"] <= 0).any():
            return f"cells of {body.name} are inside out"
        if (history[path + "energy"]["elastic"] < -1e-12).any():
            return f"the energy of {body.name} is negative"
        nu, E = body.elastic["nu"], body.elastic["E"]
        volume = history[path + "volume"]["now"]
        first = 4 / 3 * np.pi * body.a**3 if body.shape["type"] == "sphere" else volume[0]
        if body.shape["type"] == "sphere" and nu >= 0.45 and not springs(scene):
            # of triangles: less than the sphere by some 2 (size/radius)^2/5
            spread = np.ptp(volume) / first
            bulk = E / (3 * (1 - 2 * nu))
            bound = 5e-3 + 3 * pressure(scene, history) / bulk
            if spread > bound:
                return f"the volume of {body.name} changes by {spread:.3g}, bound {bound:.3g}"
    return ""


def dissipation(scene, history):
    """A fluid at rest: constant loads and steady fields only lose energy."""
    if scene.flow.fastest or springs(scene):
        return ""
    if any(b.constraints or (not b.elastic and not b.overdamped) for b in scene.bodies):
        return ""
    if not steady(scene):
        return ""
    energy, size = 0.0, 0.0
    for body in scene.bodies:
        force, torque = loads(scene, body)
        if torque.any():
            return ""
        force = force + body_force(body, history)[0]
        lost = -centres(history, body) @ force
        if body.elastic:
            lost = lost + history[f"elasticBodies/{body.name}/energy"]["elastic"]
        path = f"effects/magnetics/{body.name}"
        if path in history:
            # SI: 1 J = 1e27 pg um2/us2... T A m2 = J
            part = -sum(history[path]["m" + i] * history[path]["B" + i] for i in "xyz")
            lost = lost + 1e15 * part
        energy, size = energy + lost, size + np.ptp(lost)
    rise = np.diff(energy).max() if np.ndim(energy) and len(energy) > 1 else 0
    if rise > 1e-3 * size + 1e-12:
        return f"energy rises by {rise:.3g} of {size:.3g}"
    return ""


def steady(scene):
    fields = scene.effects.get("magnetics", {}).get("fields", {})
    return not re.search("rotating|table|sine", str(fields))
