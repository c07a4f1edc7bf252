# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random scenes, each drawn from its seed, run and judged.

    fuzz.py --seeds 1 200       appends to fuzz.csv; seeds it has are left out
    fuzz.py --again VERDICT     runs those of that verdict again
    fuzz.py --only SEED ...     runs these
    fuzz.py --show SEED         only writes the case folder runs/fuzz<seed>
    fuzz.py --pressed ...       scenes of pressed.py, to pressed.csv

Exit code 0: every verdict is `right` or `stopped`.
"""

import argparse
import csv
import os
import shutil
import sys

import numpy as np

import outcome
import pressed as pressed_scenes
from drawing import Draw, draw_shape, loads, pushed
from scene import Body, Flow, Scene

HEADER = ["seed", "verdict", "judged", "seconds", "scene", "may stop", "why"]
GOOD = ("right", "stopped")
SECONDS = 15            # then a Ctrl-C; the run has to end itself, and goes on


def draw_scene(seed):
    draw = Draw(seed)
    viscosity = draw.decades(-1, 1)
    speed = draw.decades(-5, -2)            # um/us, of all that moves
    size = draw.random.uniform(2, 4)        # um, of bodies
    time = size / speed
    flow = Flow(draw.one("rest", "shear", "shear", "uniform", "Poiseuille"),
                half=draw.one((20, 20, 20), (30, 14, 14), (16, 24, 16)),
                floor=draw.chance(0.3), viscosity=viscosity)
    flow.rate = 0 if flow.kind == "rest" else draw.decades(-1, 0.5) * speed / size
    steps = int(draw.random.integers(2, 5))
    scene = Scene(flow, step=draw.decades(-3, 1) * time, steps=steps,
                  adjust=draw.chance(0.4), tolerance=draw.one(1e-6, 1e-7, 1e-8),
                  growth=draw.random.uniform(0.6, 1))
    if draw.chance(0.25):
        scene.remesh["maxTwist"] = 1e-14
    if scene.adjust and draw.chance(0.5):
        scene.controls["maxApproach"] = 0.2
    for n in range(draw.one(1, 1, 2, 2, 3, 6)):
        scene.add(draw_body(draw, scene, f"body{n}", size, speed))
    draw_effects(draw, scene, speed, size)
    scene.faulty = overlap(scene)
    if draw.chance(0.1):
        spoil(draw, scene)
    return scene


def draw_body(draw, scene, name, size, speed):
    mu = scene.flow.viscosity
    radius = size * draw.random.uniform(0.7, 1.3)
    shape = draw_shape(draw, radius)
    elastic = None
    entries = {}
    if draw.chance(0.35):
        nu = draw.one(0.0, 0.3, 0.45, 0.49, 0.499)
        elastic = dict(type=draw.one("neoHookean", "neoHookean", "StVenantKirchhoff",
                                     "MooneyRivlin", "linearElastic"),
                       E=mu * speed / size / draw.decades(-3, 0.3), nu=nu)
        if draw.chance(0.3):
            entries["tether"] = {}
        elif draw.chance(0.2) and shape["shape"] == "sphere":
            force = draw.decades(-1, 0.5) * mu * speed / size**2
            entries["bodyForce"] = force * draw.direction()
    else:
        entries = draw_rigid(draw, mu, radius, speed)
    body = Body(name, position=(0, 0, 0), elastic=elastic, **shape, **entries)
    if draw.chance(0.5):
        body.entries["orientation"] = (draw.direction(), draw.random.uniform(0, 3))
    body.position = draw_place(draw, scene, body)
    return body


def draw_rigid(draw, mu, radius, speed):
    entries = {}
    if draw.chance(0.7):
        entries["overdamped"] = True
    else:
        # from no inertia to hardly any drag within a radius of travel
        entries["density"] = mu / (radius * speed) * draw.decades(-6, 1)
        entries["velocity"] = speed * draw.direction()
    if draw.chance(0.4):
        entries["force"] = draw.decades(-1, 0.5) * 19 * mu * radius * speed * draw.direction()
    if draw.chance(0.3):
        entries["torque"] = draw.decades(-1, 0.5) * 25 * mu * radius**2 * speed \
            * draw.direction()
    if draw.chance(0.2):
        entries["constraints"] = draw.one(
            dict(velocity=(0, 0, 0)), dict(velocity=speed * draw.direction()),
            dict(angularVelocity=speed / radius * draw.direction()),
            dict(velocity=(0, 0, 0), angularVelocity=(0, 0, 0)),
            dict(velocity=(0, 0, 0), velocityAxes="(y)"))
    return entries


def draw_place(draw, scene, body):
    """Mostly clear of the others, at times near one or a wall, now and then
    anywhere."""
    low, high = scene.flow.low, -scene.flow.low
    style = draw.random.random()
    for _ in range(300):
        place = draw.random.uniform(low + 1.2 * body.R, high - 1.2 * body.R)
        if style < 0.1:
            return draw.random.uniform(low, high)
        if style < 0.35:
            gap = draw.decades(-2, -0.5) * body.a
            if scene.bodies and draw.chance(0.6):
                other = scene.bodies[-1]
                place = other.position + (other.R + body.R + gap) * draw.direction()
            else:
                place[1] = low[1] + body.R + gap
            if (place - low < body.R).any() or (high - place < body.R).any():
                continue
        if all(np.linalg.norm(place - b.position) > 1.001 * (b.R + body.R)
               for b in scene.bodies):
            return place
    return place


def draw_effects(draw, scene, speed, size):
    names = [b.name for b in scene.bodies]
    mu = scene.flow.viscosity
    if draw.chance(0.2):
        scene.effects["repulsion"] = dict(
            strength=draw.decades(-2, 1) * mu * speed * size, range=draw.one(0.2, 0.5, 1.0),
            minimumGap=draw.one(0.0, 0.02, 0.2))
    if draw.chance(0.2):
        scene.effects["bonds"] = draw_bonds(draw, names)
    if draw.chance(0.25):
        scene.effects["magnetics"] = draw_magnets(draw, scene, speed, size)


def draw_bonds(draw, names):
    ligands = draw.one("bottom", names[-1] if len(names) > 1 else "bottom")
    law = draw.one(dict(law="Dembo", sts=2), dict(law="Bell", gamma=4e-5))
    return dict(
        temperature=310, seed=int(draw.random.integers(1, 1000)),
        maxStretch=draw.one(1, 4, 1000),
        molecules={names[0]: {"A": dict(density=draw.decades(-1, 0.5))},
                   ligands: {"B": dict(density=draw.decades(0, 2))}},
        pairs={"AB": dict(kinds="(A B)", k0on=draw.decades(-9, -4),
                          k0off=draw.decades(-7, -4), s=draw.one(2, 0.05),
                          **{"lambda": 0.05}, roughness=draw.one(0.2, 1.0, 3.0), **law)})


def draw_magnets(draw, scene, speed, size):
    mu, magnetisation = scene.flow.viscosity, 1e4
    moment = magnetisation * 4.2e-18 * size**3
    field = draw.decades(-1, 3) * 25 * mu * size**2 * speed / (1e15 * moment)
    fields = {"main": draw.one(
        dict(type="uniform", B=field * draw.direction()),
        dict(type="rotating", magnitude=field, axis=(0, 0, 1), start=(1, 0, 0),
             frequency=speed / size * draw.decades(-2, 0.5)))}
    if draw.chance(0.3):
        fields["pull"] = dict(type="gradient", centre=(0, 0, 0), axis=draw.direction(),
                              axial=field / (size * 1e-6) * draw.decades(-1.5, 0))
    bodies = {}
    for body in scene.bodies:
        if draw.chance(0.3) and bodies:
            continue
        bodies[body.name] = draw.one(
            dict(type="permanent", direction=draw.direction(), magnetisation=magnetisation),
            dict(type="saturated", magnetisation=magnetisation),
            dict(type="soft", susceptibility=draw.decades(-2, 3), semiAxes=(1, 1, 2)))
    entries = dict(fields=fields, bodies=bodies)
    if draw.chance(0.4):
        entries["interaction"] = {}
    return entries


def overlap(scene):
    """What must be told: bodies that are partly at the same place."""
    low, high = scene.flow.low, -scene.flow.low
    for i, body in enumerate(scene.bodies):
        r = body.a - body.sag
        if body.shape["type"] == "leukocyte":
            continue
        if (body.position - low < r).any() or (high - body.position < r).any():
            return f"{body.name} crosses a wall"
        for other in scene.bodies[:i]:
            if other.shape["type"] == "leukocyte":
                continue
            if np.linalg.norm(body.position - other.position) < r + other.a - other.sag:
                return f"{body.name} crosses {other.name}"
    return None


def may_stop(scene):
    """Why a run of the scene may end with a message, known before it is run;
    empty: it must reach its end."""
    if scene.faulty:
        return f"bad input: {scene.faulty}"
    near, reach = nearest(scene), scene.end * pushed(scene)
    # a gap of less than a third of a triangle: cells would be thinner than wide
    if near < 0.3 * min(b.size for b in scene.bodies):
        return f"a gap of {near:.2g}"
    for name, entries in scene.effects.items():
        ends = dict(repulsion=lambda e: e["range"] + e["minimumGap"],
                    bonds=lambda e: 2 * e["pairs"]["AB"]["roughness"])
        if name in ends and near < ends[name](entries):
            return f"{name} across a gap of {near:.2g}"
    if reach > near:
        return f"may go {reach:.2g}, has room for {near:.2g}"
    for body in scene.bodies:
        if body.elastic and pressed(scene, body) > 0.2 * body.elastic["E"]:
            return f"{body.name} is pressed by {pressed(scene, body) / body.elastic['E']:.2g} E"
    return ""


def nearest(scene):
    """Smallest distance of balls around the bodies, or from walls."""
    found = [(scene.flow.half - np.abs(b.position)).min() - b.R for b in scene.bodies]
    for i, body in enumerate(scene.bodies):
        found += [np.linalg.norm(body.position - other.position) - body.R - other.R
                  for other in scene.bodies[:i]]
    return min(found)


def pressed(scene, body):
    """Stress on an elastic body: that of the flow around a sphere, 5/2 of its
    own, and of the loads on it."""
    force, torque = loads(scene, body)
    return 2.5 * scene.flow.stress + force / body.a**2 + torque / body.a**3


def spoil(draw, scene):
    """Bad input of one kind."""
    body = draw.one(*scene.bodies)
    nowhere = scene.flow.half * 3

    def entry(key, value):
        return lambda: body.entries.__setitem__(key, value)

    def material(key, value):
        return lambda: (body.elastic if body.elastic else body.entries).__setitem__(key, value)

    kinds = {
        "a negative size": lambda: body.shape.__setitem__("size", -1),
        "a body outside": lambda: setattr(body, "position", nowhere),
        "an unknown keyword": entry("colour", "red"),
        "nu of 0.5, or a keyword nobody knows": material("nu", 0.5),
        "E of minus one, or a keyword nobody knows": material("E", -1),
        "no viscosity": lambda: setattr(scene.flow, "viscosity", 0.0),
        "nan for a viscosity": lambda: scene.changes.append(
            ("constant/fluid/material", lambda t: t.replace("viscosity ", "viscosity nan; //"))),
        "a step of zero": lambda: scene.controls.__setitem__("deltaT", 0),
        "a step that is no number": lambda: scene.controls.__setitem__("deltaT", "nan"),
        "a tolerance of zero": lambda: setattr(scene, "tolerance", 0.0),
        "an effect on nobody": lambda: scene.effects.__setitem__("repulsion", dict(
            strength=1, range=1, between="((nobody bottom))")),
        "a force of 1e300": entry("bodyForce" if body.elastic else "force", (1e300, 0, 0)),
        "a force that is no number": entry(
            "bodyForce" if body.elastic else "force", "(nan 0 0)"),
        "a place that is no number": lambda: setattr(
            body, "position", np.array([np.nan, 0, 0])),
        "a missing brace": lambda: scene.changes.append(
            ("constant/bodies", lambda t: t.rstrip()[:-1])),
        "no end of a file": lambda: scene.changes.append(
            ("constant/bodies", lambda t: t[: 2 * len(t) // 3])),
        "a patch of no name": lambda: scene.changes.append(
            ("0/fluid/U", lambda t: t.replace("upstream", "upsteam"))),
    }
    what = draw.one(*sorted(kinds))
    if body.constraints and "force" in what:
        what = "a body outside"         # held bodies do not heed forces
    kinds[what]()
    scene.faulty = what


def described(scene):
    bodies = ", ".join(("elastic " if b.elastic else "") + b.shape["type"]
                       for b in scene.bodies)
    extra = sorted(scene.effects) + (["remeshed"] if "maxTwist" in scene.remesh else [])
    steps = "chosen steps" if scene.adjust else "fixed steps"
    return "; ".join([scene.flow.kind, bodies, *extra, steps])


def run(seed, family):
    draw, may = family
    folder = f"runs/fuzz{seed}"
    scene = draw(seed)
    ended = outcome.judge(scene, folder, SECONDS)
    if ended.verdict in GOOD:
        shutil.rmtree(folder)
    print(f"{seed}: {ended}", flush=True)
    judged = {"right": "partly" if ended.skipped else "fully"}.get(ended.verdict, "")
    why = ended.why or "; ".join(ended.skipped)
    row = dict(seed=seed, verdict=ended.verdict, judged=judged, seconds=f"{ended.seconds:.1f}",
               scene=described(scene), why=outcome.normal(why)[:300])
    row["may stop"] = may(scene)
    return row


def read(path):
    if not os.path.isfile(path):
        return []
    with open(path) as file:
        return list(csv.DictReader(file))


def write(path, rows):
    with open(path + ".new", "w", newline="") as file:
        writer = csv.DictWriter(file, HEADER, lineterminator="\n")
        writer.writeheader()
        writer.writerows(sorted(rows, key=lambda row: int(row["seed"])))
    os.replace(path + ".new", path)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seeds", nargs=2, type=int, default=(1, 0))
    options.add_argument("--again", nargs="+", default=[])
    options.add_argument("--only", nargs="+", type=int, default=[])
    options.add_argument("--show", type=int)
    options.add_argument("--pressed", action="store_true")
    options.add_argument("--results")
    options.add_argument("--order", type=int, default=2, help="of accuracy")
    chosen = options.parse_args()
    Scene.order = chosen.order
    family = draw_scene, may_stop
    if chosen.pressed:
        family = pressed_scenes.draw_scene, pressed_scenes.may_stop
    chosen.results = chosen.results or ("pressed.csv" if chosen.pressed else "fuzz.csv")
    if chosen.show:
        family[0](chosen.show).write(f"runs/fuzz{chosen.show}")
        return 0
    rows = {int(row["seed"]): row for row in read(chosen.results)}
    seeds = [s for s in range(chosen.seeds[0], chosen.seeds[1] + 1) if s not in rows]
    seeds += [s for s in chosen.only if s not in rows]
    seeds += [s for s, row in rows.items() if row["verdict"] in chosen.again]
    for seed in seeds:
        rows[seed] = run(seed, family)
        write(chosen.results, rows.values())
    return 0 if all(row["verdict"] in GOOD for row in rows.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
