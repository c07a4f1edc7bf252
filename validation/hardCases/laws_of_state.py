# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of energy, volume, bonds and magnets: functions of a Run (record.py)
that return what is wrong, or nothing. See laws.py."""

import numpy as np

import theory
from laws_of_motion import body_force, coarse, left


# Elastic bodies

def stress(run, body):
    """Largest that may press on an elastic body: the flow, and the loads on all
    bodies."""
    flow = run.scene.flow
    found = 6 * flow.stress
    for other in run.scene.bodies:
        force, torque = run.fluid(other)
        pull, turn = run.effects(other)
        found += np.abs(force).max() / other.a**2 + np.abs(pull).max() / other.a**2
        found += (np.abs(torque).max() + np.abs(turn).max()) / other.a**3
    return found


def volume(run):
    for body in run.soft:
        if (run.column(body, "deformation", "minJ") <= 0).any():
            return f"cells of {body.name} are inside out"
        if (run.column(body, "energy", "elastic") < -1e-12).any():
            return f"the energy of {body.name} is negative"
        nu, E = body.elastic["nu"], body.elastic["E"]
        if body.shape["type"] == "sphere" and nu >= 0.45:
            now = run.column(body, "volume", "now")
            spread = np.ptp(now) / now[0]
            # bound: the mean pressure that loads on the surface make, over the
            # bulk modulus; a surface of triangles that turns into an ellipsoid
            # loses half a per cent
            allowed = 5e-3 + 3 * stress(run, body) * 3 * (1 - 2 * nu) / E
            if spread > allowed:
                return f"the volume of {body.name} changes by {spread:.3g}, bound {allowed:.3g}"
    return ""


def unsure(run, body, change):
    """Row by row, error of an elastic body's energy against the work of its loads.

    bound: of the mesh 10 % at 0.45 of the radius for a tethered sphere, falling with
    the size (README: Energy of coarse bodies), twice that beside other bodies; the
    force that the solver leaves, over the way of a step; and of the trapezoidal rule
    force'' strain^3/12 - the modulus changes by less than four times itself with the
    strain, that of the most strained cell taken for all and with its turn - and, of a
    body that turns by th in the step, stress strain (1 - cos th)."""
    stretch = [run.column(body, "deformation", k) for k in ("maxStretch", "minStretch")]
    grown = np.max([np.abs(np.diff(s, prepend=1)) for s in stretch], axis=0)
    strain = np.max([np.abs(s - 1) for s in stretch], axis=0)
    turn = np.minimum(run.dt * run.scene.flow.largest_rate, 2)
    nu, V = body.elastic["nu"], 4 / 3 * np.pi * body.R**3
    stiff = body.elastic["E"] * (max(1, (1 - nu) / (1 + nu) / (1 - 2 * nu)) if nu < 0.45 else 1)
    return (0.2 * body.size / body.a / 0.45 * np.abs(change)
            + left(run, body) * run.typical_speed() * run.dt
            + stiff * V * ((grown + strain * turn)**3 / 3 + strain**2 * (1 - np.cos(turn / 2)) * 2))


def budget(run):
    """Work of an elastic body's loads = change of its energy, step by step."""
    for body in run.soft:
        if run.effects(body)[0].any() or run.magnet(body) is not None:
            run.skip("the work of effects on an elastic body is not resolved or not recorded")
            continue
        energy = run.column(body, "energy", "elastic") + run.column(body, "energy", "kinetic")
        rise = np.diff(energy, prepend=0)
        work = np.diff(run.column(body, "energy", "work"), prepend=0)
        off = np.abs(rise - work)
        allowed = unsure(run, body, np.abs(rise) + np.abs(work)) + 1e-9 * energy.max()
        if "bodyForce" in body.entries:
            allowed[0] = np.inf         # the fluid's force begins from nothing, this does not
        if (off > allowed).any():
            n = np.argmax(off / allowed)
            return (f"the energy of {body.name} rises by {rise[n]:.3g} with the work "
                    f"{work[n]:.3g}, allowed {allowed[n]:.3g}")
    return ""


def decay(run):
    """In a fluid at rest the loads' power is what the fluid takes, at least that of
    theory, and what elastic bodies store."""
    if run.scene.flow.kind != "rest" or not run.soft:
        return ""
    if any(run.magnet(b) is not None or run.effects(b)[0].any() for b in run.soft):
        return ""               # as told by budget
    mu = run.scene.flow.viscosity
    taken, allowed, least = 0.0, 1e-12, 0.0
    for body in run.rigid:
        force, torque = run.fluid(body)
        v, w = run.velocity(body), run.spin(body)
        taken = taken - (force * v).sum(axis=1) - (torque * w).sum(axis=1)
        least = np.maximum(least, theory.power(theory.free(mu, body.a - body.sag), v, w))
    for body in run.soft:
        stored = np.diff(run.column(body, "energy", "elastic"), prepend=0)
        way = np.diff(run.centre(body), axis=0, prepend=body.position[None, :])
        driven = (body_force(run, body) * way).sum(axis=1)
        taken = taken + (driven - stored) / run.dt
        allowed = allowed + unsure(run, body, np.abs(stored) + np.abs(driven)) / run.dt
    if (taken < (1 - coarse(run)) * least - allowed).any():
        n = np.argmin(taken - least + allowed)
        return f"the fluid takes {taken[n]:.3g}, by theory at least {least[n]:.3g}"
    return ""


# Effects

def guessed(run, body):
    """Row by row, how far the step's guess of the place, by Adams and Bashforth, was
    from where springs and magnets let the body stand in the end, by BDF2: way and
    turn; infinite where the guess cannot be known."""
    found = []
    for v in (run.velocity(body), run.spin(body)):
        off, mean = np.full(len(run.dt), np.inf), v.copy()
        for n in np.flatnonzero(~run.anew(body)):
            r = run.dt[n] / run.dt[n - 1]
            guess = v[n - 1] + (r / 2 * (v[n - 1] - v[n - 2]) if n > 1 else 0)
            mean[n] = ((1 + r) * v[n] + r * mean[n - 1]) / (1 + 2 * r)
            off[n] = run.dt[n] * np.linalg.norm(mean[n] - guess)
        found.append(off)
    return found


def bonds(run):
    if "bonds" not in run.scene.effects:
        return ""
    table = run.history["effects/bonds/AB"]
    events = run.history["effects/bonds/events"]
    number = np.cumsum(table["formed"] - table["broken"])
    if (number != table["number"]).any() or (number < 0).any():
        return "bonds do not add up: number, formed, broken"
    for t, formed, broken in zip(run.time, table["formed"], table["broken"]):
        mine = events["formed"][events["time"] == t]
        if (mine == 1).sum() != formed or (mine == 0).sum() != broken:
            return f"the events at {t:g} are not the bonds formed and broken"
    return bond_forces(run, table)


def bond_forces(run, table):
    """What bonds record of themselves at the end of the step acted in it."""
    entries = run.scene.effects["bonds"]
    first, second = (next((b for b in run.scene.bodies if b.name == name), None)
                     for name in entries["molecules"])
    if not table["number"].any():
        return ""
    if len(run.scene.effects) > 1:
        run.skip("bonds with other effects on the same body")
        return ""
    pull = np.array([table["f" + i] for i in "xyz"]).T
    acted = run.effects(first)[0]
    if second is not None:
        # bound: round-off of opposite forces
        off = np.abs(acted + run.effects(second)[0]).max()
        if off > 1e-9 * np.abs(acted).max(initial=0):
            return f"bonds pull their two bodies with forces that differ by {off:.3g}"
    if first.elastic or (second is not None and second.elastic):
        run.skip("bonds on an elastic body, whose guess is not recorded")
        return ""
    # bound: a bond's force is linear in the step. Of k (length - rest) along the
    # bond the rest of Taylor's series is at most 3/2 k u^2/rest; of a pushed bond the
    # turning is left out, at most k u
    u = sum(way + b.R * turn for b in (first, second) if b is not None
            for way, turn in [guessed(run, b)])
    pair = entries["pairs"]["AB"]
    allowed = pair["s"] * table["number"] * (u + 1.5 * u**2 / pair["lambda"] + 1e-9)
    off = np.linalg.norm(acted - pull, axis=1)
    if (off > allowed).any():
        return f"bonds record a force that is not what acted, by {off.max():.3g}"
    return ""


def magnets(run):
    """The torque in a field that is the same all over."""
    entries = run.scene.effects.get("magnetics")
    if not entries:
        return ""
    if len(run.scene.effects) > 1 or len(entries["fields"]) > 1 or "interaction" in entries:
        run.skip("magnets with other effects, gradients or interaction")
        return ""
    for body in run.rigid:
        table = run.magnet(body)
        if table is None:
            continue
        recorded = np.array([table["t" + i] for i in "xyz"]).T
        off = np.linalg.norm(run.effects(body)[1] - recorded, axis=1)
        m, B = (np.linalg.norm([table[k + i] for i in "xyz"], axis=0) for k in "mB")
        # bound: in the step it falls by a stiffness of about m B, the same for every
        # turn u, that keeps the system positive; the true one is between - m B and m B
        u = guessed(run, body)[1]
        allowed = 1e15 * m * B * (3 * u + 2 * u**2 + 1e-9)
        if (off > allowed).any():
            return f"the torque on magnet {body.name} is not what acted, by {off.max():.3g}"
    return ""
