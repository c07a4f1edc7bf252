# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of forces, paths and speeds: functions of a Run (record.py) that return
what is wrong, or nothing. See laws.py."""

import numpy as np

import theory
from record import NONE, rate_of_change, rotation


def largest(*vectors):
    return max(np.abs(v).max(initial=0) for v in vectors)


def given(body, key):
    return np.array(body.entries.get(key, (0, 0, 0)), float)


# Forces and torques

def free(body, key):
    """Which components of a velocity are found by the solution?"""
    if key not in body.constraints:
        return np.ones(3, bool)
    axes = body.constraints.get(key + "Axes", "(x y z)")
    return np.array([axis not in axes for axis in "xyz"])


def held(run):
    """What is prescribed is kept."""
    for body in run.rigid:
        for key, values in (("velocity", run.velocity(body)), ("angularVelocity", run.spin(body))):
            if key in body.constraints:
                wanted = np.array(body.constraints[key], float)
                off = np.abs(values - wanted)[:, ~free(body, key)].max(initial=0)
                # bound: as many digits as the dictionary has
                if off > 1e-9 * max(largest(wanted), run.typical_speed()):
                    return f"the {key} of {body.name} is off what is prescribed by {off:.3g}"
    return ""


def left(run, body):
    """Force that the solver may leave in the balance of a body.

    bound: its tolerance is of the residual's norm over all rows of the system, four
    a cell, of which a body has six; so a body may carry the root of their number times
    the tolerance of what a typical row does. Its rows are velocities by drag and inertia."""
    drag = theory.free(run.scene.flow.viscosity, body.a)[0]
    if not (body.elastic or body.overdamped):
        drag += 2 * run.mass(body)[0] / run.dt.min()
    rows = max(4 * run.history["cost"]["cells"].max(), 1e4)
    return np.sqrt(rows) * run.scene.tolerance * drag * run.typical_speed()


def balance(run):
    for body in run.rigid:
        wrong = rigid_balance(run, body)
        if wrong:
            return wrong
    for body in run.soft:
        forces = [run.fluid(body)[0], run.vectors(body, "tether"), run.effects(body)[0],
                  body_force(run, body)]
        rest = largest(sum(forces))
        if rest > left(run, body) + 100 * run.scene.tolerance * largest(*forces):
            return f"forces on {body.name} sum to {rest:.3g} of {largest(*forces):.3g}"
    return ""


def body_force(run, body):
    """Of spheres, whose triangles have the volume of the true one."""
    return given(body, "bodyForce")[None, :] * 4 / 3 * np.pi * body.R**3


def rigid_balance(run, body):
    loads = zip(("force", "torque"), run.fluid(body), run.effects(body),
                ("velocity", "angularVelocity"), changes_of_momentum(run, body))
    for kind, fluid, effects, key, change in loads:
        forces = [fluid, run.vectors(body, f"{kind}/applied"), effects, -change]
        rest = np.abs(sum(forces)[:, free(body, key)]).max(axis=1, initial=0)
        arm = body.a if kind == "torque" else 1
        bound = arm * left(run, body) + 100 * run.scene.tolerance * largest(*forces)
        if kind == "torque" and not body.overdamped:
            bound += turned_meanwhile(run, body)
        if (rest > bound).any():
            return f"{kind}s on {body.name} sum to {rest.max():.3g} of {largest(*forces):.3g}"
    return ""


def turned_meanwhile(run, body):
    """Change of the angular momentum, over each step, by what the solution turns a body
    on from where extrapolation has put it with its moments of inertia.

    bound: turned by an angle, a tensor changes by that times the difference of its largest
    and least eigenvalue; the weights of BDF2 are at most 2"""
    inertia = np.linalg.eigvalsh(run.mass(body)[1])
    spin = np.vstack([given(body, "angularVelocity"), run.spin(body)])
    dt = run.dt[:, None]
    constant = dt * spin[:-1]
    linear = constant.copy()
    linear[1:] += dt[1:]**2 / 2 * np.diff(spin[:-1], axis=0) / dt[:-1]
    turn = run.turn(body)
    angle = np.linalg.norm(turn - linear, axis=1)
    # the first steps do not extrapolate, or stay
    early = run.anew(body) | np.roll(run.anew(body), 1)
    for other in (turn, turn - constant):
        angle[early] = np.maximum(angle, np.linalg.norm(other, axis=1))[early]
    return 2 * angle / run.dt * np.ptp(inertia) * np.linalg.norm(spin[1:], axis=1)


def changes_of_momentum(run, body):
    if body.overdamped:
        return NONE, NONE
    mass, inertia = run.mass(body)
    R = rotation(run.vectors(body, "orientation"))
    turning = np.einsum("nij,jk,nlk,nl->ni", R, inertia, R, run.spin(body))
    axis, angle = body.entries.get("orientation", ((1, 0, 0), 0))
    first = rotation(np.array([[np.cos(angle / 2), *np.sin(angle / 2) * np.array(axis)]]))[0]
    spin = first @ inertia @ first.T @ given(body, "angularVelocity")
    anew = run.anew(body)
    return (rate_of_change(run.dt, mass * run.velocity(body), mass * given(body, "velocity"), anew),
            rate_of_change(run.dt, turning, spin, anew))


# Paths and speeds

def motion(run):
    for body in run.rigid:
        q = run.vectors(body, "orientation")
        # bound: round-off; it is normalised in every step
        if np.abs(np.linalg.norm(q, axis=1) - 1).max() > 1e-12:
            return f"the quaternion of {body.name} is none"
        x, v = run.centre(body), run.velocity(body)
        mean = np.diff(x, axis=0) / run.dt[1:, None]
        usual = ~(run.anew(body)[1:])
        for n in np.flatnonzero(usual) + 1:
            # bound: a mean of Adams and Bashforth's, or BDF2's with that of the
            # step before: both lie within these differences of the velocity
            r = run.dt[n] / run.dt[n - 1]
            size = np.linalg.norm
            allowed = size(v[n] - v[n - 1]) + (r / 2 * size(v[n - 1] - v[n - 2]) if n > 1 else 0)
            before = mean[n - 2] if n > 1 else v[n - 1]
            allowed = max(allowed, 0.5 * size(v[n] - before), 1e-9 * size(v).max())
            if size(mean[n - 1] - v[n]) > allowed * (1 + 1e-6):
                return f"{body.name} does not go where its velocity says"
    return ""


def all_loads(run):
    """(radius inside, force, torque) of what acts on the fluid by every body:
    of rigid ones all, of elastic ones what holds and drives them."""
    found = []
    for body in run.scene.bodies:
        force, torque = run.fluid(body)
        if body.elastic:
            torque = run.effects(body)[1]
        found.append((body.a - body.sag, np.linalg.norm(force, axis=1),
                      np.linalg.norm(torque, axis=1)))
    return found


def coarse(run):
    """Part by which drags of such triangles may be off.

    bound: validation/B1-fluidForces has 2.2 % at 0.28 of the radius, and falls
    with the square or faster."""
    return max(0.0222 * (b.size / b.a / 0.28)**2 for b in run.scene.bodies)


def speeds(run):
    """bound: a body goes with the flow's fastest where bodies are, and besides
    as loads drive it; that in a flow it is not carried faster is no theorem, but
    bodies between others and walls are only hindered."""
    mu = run.scene.flow.viscosity
    heights = [(run.centre(b)[:, 1] - b.R, run.centre(b)[:, 1] + b.R) for b in run.scene.bodies]
    fastest = run.scene.flow.fastest_between(min(low.min() for low, _ in heights),
                                             max(high.max() for _, high in heights))
    for body in run.scene.bodies:
        inside = body.a - body.sag
        driven = theory.speed(mu, all_loads(run), inside)
        driven[1:] = np.maximum(driven[1:], driven[:-1])    # of an elastic body: in the step
        bound = (1 + coarse(run)) * (fastest + driven) + 1e-12
        for name, speed in (("speed", run.velocity(body)), ("spin", inside * run.spin(body))):
            wrong = np.linalg.norm(speed, axis=1) > bound
            if wrong.any():
                n = np.flatnonzero(wrong)[0]
                return (f"{body.name} has a {name} of {np.linalg.norm(speed[n]):.3g}, "
                        f"bound {bound[n]:.3g}")
    return ""


def drag(run):
    """The power given to a fluid at rest, or that moves as one."""
    flow = run.scene.flow
    if run.soft or flow.kind not in ("rest", "uniform"):
        return ""
    wind = np.array([flow.fastest, 0, 0]) if flow.kind == "uniform" else NONE
    mu, given_off, least, most, left_over = flow.viscosity, 0, 0, 0, 0
    for body, reach in zip(run.rigid, reaches(run)):
        v, w = run.velocity(body) - wind, run.spin(body)
        force, torque = run.fluid(body)
        given_off = given_off - (force * v).sum(axis=1) - (torque * w).sum(axis=1)
        least = np.maximum(least, theory.power(theory.free(mu, body.a - body.sag), v, w))
        shell = [theory.in_shell(mu, body.R, L) if L > body.R else (1e300, 1e300)
                 for L in reach]
        most = most + theory.power(np.array(shell).T, v, w)
        left_over = left_over + left(run, body) * np.sqrt(
            (v**2).sum(axis=1) + body.a**2 * (w**2).sum(axis=1))
    e = coarse(run)
    if (given_off < (1 - e) * least - left_over).any():
        return f"the fluid takes {np.min(given_off / least):.3g} of the least power"
    if (given_off > (1 + e) * most + left_over).any():
        return f"the fluid takes {np.max(given_off / most):.3g} of the largest power"
    return ""


def reaches(run):
    """Row by row, radii of balls about the bodies that touch no wall and not
    each other; walls and gaps are shared out by the bodies' sizes."""
    half = run.scene.flow.half
    for body in run.rigid:
        x = run.centre(body)
        reach = (half - np.abs(x)).min(axis=1)
        for other in run.rigid:
            if other is not body:
                apart = np.linalg.norm(x - run.centre(other), axis=1)
                reach = np.minimum(reach, apart * body.R / (body.R + other.R))
        yield reach
