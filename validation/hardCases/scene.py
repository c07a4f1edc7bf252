# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene as Python objects, and the case folder that it becomes.

    scene = Scene(Flow("shear", rate=5e-5))
    scene.add(Body("cell", "sphere", radius=4, elastic=dict(E=1e-3, nu=0.45)))
    scene.write("runs/soft")

Units are pg, um, us. The domain is a box around the origin; a wall may lie at
its bottom. Kept beside what is written: what a check must know of the scene.
"""

import os
import shutil
import subprocess

import numpy as np


def text(value):
    """As OpenFOAM writes numbers, words, vectors and tables."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "(" + " ".join(text(v) for v in value) + ")"
    return value if isinstance(value, str) else f"{value:.10g}"


def dictionary(entries, indent=0):
    pad = "    " * indent
    lines = []
    for key, value in entries.items():
        if isinstance(value, dict):
            lines += [f"{pad}{key}", f"{pad}{{",
                      dictionary(value, indent + 1), f"{pad}}}"]
        else:
            lines.append(f"{pad}{key} {text(value)};")
    return "\n".join(line for line in lines if line)


def write_dictionary(path, entries, kind="dictionary"):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    head = dict(version=2.0, format="ascii", **{"class": kind},
                object=os.path.basename(path))
    with open(path, "w") as file:
        file.write(f"{dictionary({'FoamFile': head})}\n\n{dictionary(entries)}\n")


class Flow:
    """Conditions on the box: rest, shear, uniform, Poiseuille. `fastest` is
    the largest speed on the sides, `stress` the mean one of the undisturbed flow.
    walls: whatever sides can be are walls, around a fluid at rest all."""

    def __init__(self, kind="rest", rate=0.0, half=(20, 20, 20), floor=False,
                 viscosity=1.0, divisions=4, walls=False):
        self.kind, self.rate, self.viscosity = kind, rate, viscosity
        self.half, self.floor, self.walls = np.array(half, float), floor, walls
        self.divisions = divisions
        self.origin = -self.half[1] if floor else 0.0

    @property
    def low(self):
        return -self.half

    @property
    def fastest(self):
        reach = {"shear": 2 if self.floor else 1, "uniform": 1, "Poiseuille": 1,
                 "rest": 0}[self.kind]
        return abs(self.rate) * self.half[1] * reach

    def fastest_between(self, low, high):
        """The largest speed at heights within the box."""
        low, high = max(low, -self.half[1]), min(high, self.half[1])
        if self.kind == "shear":
            return abs(self.rate) * max(abs(low - self.origin), abs(high - self.origin))
        if self.kind == "Poiseuille":
            nearest = min(max(low, 0), high) / self.half[1]
            return abs(self.rate) * self.half[1] * (1 - nearest**2)
        return self.fastest

    @property
    def stress(self):
        return self.viscosity * self.fastest / self.half[1]

    @property
    def largest_rate(self):
        """Of shear, at the walls."""
        return self.stress / self.viscosity * (2 if self.kind == "Poiseuille" else 1)

    @property
    def wall_sides(self):
        if not self.walls:
            return ["bottom"] if self.floor else []
        return ["bottom", "top"] + {"rest": ["front", "back", "upstream", "downstream"],
                                    "uniform": ["front", "back"]}.get(self.kind, [])

    @property
    def open_axes(self):
        """x, y, z: may a body leave along it?"""
        sides = (("upstream", "downstream"), ("bottom", "top"), ("front", "back"))
        return np.array([not set(pair) <= set(self.wall_sides) for pair in sides])

    def conditions(self):
        still = dict(type="fixedValue", value="uniform (0 0 0)")
        free = dict(type="traction")
        sides = ["bottom", "top", "front", "back"]
        if self.kind == "rest":
            return dict({s: still for s in sides + ["upstream"]},
                        downstream=still if self.walls else free)
        if self.kind == "uniform":
            speed = self.rate * self.half[1]
            moved = dict(type="fixedValue", value=f"uniform ({speed:.10g} 0 0)")
            return dict({s: moved for s in sides + ["upstream"]}, downstream=free)
        if self.kind == "Poiseuille":
            parabola = dict(type="Poiseuille", maxVelocity=self.rate * self.half[1],
                            halfWidth=self.half[1], gradientDirection=(0, 1, 0))
            return dict(bottom=still, top=still, front=parabola, back=parabola,
                        upstream=parabola, downstream=free)
        sheared = dict(type="linearShear", shearRate=self.rate,
                       gradientDirection=(0, 1, 0), origin=(0, self.origin, 0))
        pull = self.viscosity * self.rate
        return dict({s: sheared for s in sides},
                    upstream=dict(type="traction", traction=(0, -pull, 0)),
                    downstream=dict(type="traction", traction=(0, pull, 0)))

    def block_mesh(self):
        x, y, z = self.half
        corners = [(-x, -y, -z), (x, -y, -z), (x, y, -z), (-x, y, -z),
                   (-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]
        cells = np.maximum(1, np.rint(self.divisions * self.half / self.half.max()))
        faces = dict(upstream=(0, 4, 7, 3), downstream=(1, 2, 6, 5),
                     bottom=(0, 1, 5, 4), top=(3, 7, 6, 2), back=(0, 3, 2, 1),
                     front=(4, 5, 6, 7))
        patches = " ".join(
            f"{name} {{ type {'wall' if name in self.wall_sides else 'patch'}; "
            f"faces ({text(face)}); }}" for name, face in faces.items())
        return {"scale": 1, "vertices": text(corners),
                "blocks": f"(hex (0 1 2 3 4 5 6 7) {text(cells)} simpleGrading (1 1 1))",
                "boundary": f"({patches})"}


class Body:
    """Rigid, or elastic with `elastic`: entries of its material. Everything
    else is written as it is. a: radius of a ball inside, R: of one around."""

    def __init__(self, name, shape="sphere", position=(0, 0, 0), elastic=None,
                 **entries):
        self.name, self.elastic, self.position = name, elastic, np.array(position, float)
        self.shape = dict(type=shape)
        for key in ("radius", "semiAxes", "length", "size", "pitch",
                    "filamentRadius", "turns", "Ax", "Ay", "By", "file", "scale"):
            if key in entries:
                self.shape[key] = entries.pop(key)
        self.entries = entries
        self.a, self.R = self._balls()

    def _balls(self):
        s = self.shape
        if s["type"] == "sphere":
            return s["radius"], s["radius"]
        if s["type"] == "ellipsoid":
            return min(s["semiAxes"]), max(s["semiAxes"])
        if s["type"] == "capsule":
            return s["radius"], s["radius"] + s["length"] / 2
        if s["type"] == "helix":
            across = s["radius"] + s["filamentRadius"]
            return s["filamentRadius"], np.hypot(across, s["pitch"] * s["turns"] / 2
                                                 + s["filamentRadius"])
        return 0.5 * s["radius"], 1.6 * s["radius"]

    @property
    def size(self):
        return self.shape.get("size", 0.4 * self.a)

    @property
    def sag(self):
        """Of triangles below the surface, at most."""
        return 0.6 * self.size**2 / self.a

    @property
    def overdamped(self):
        return bool(self.entries.get("overdamped"))

    @property
    def constraints(self):
        return self.entries.get("constraints", {})

    def written(self):
        shape = dict(self.shape)
        if shape["type"] not in ("surfaceFile",):
            shape.setdefault("size", self.size)
        return dict(type="elasticBody" if self.elastic else "rigidBody", shape=shape,
                    position=self.position, **self.entries)


class Scene:
    # of accuracy of the fluid, and of elastic bodies in it
    order = 2

    def __init__(self, flow=None, step=1000.0, steps=3, adjust=False, growth=0.8,
                 tolerance=1e-7, effects=None, remesh=None, controls=None):
        self.flow = flow or Flow()
        self.bodies = []
        self.step, self.steps, self.adjust = step, steps, adjust
        self.tolerance, self.effects = tolerance, effects or {}
        self.remesh = dict(growth=growth, **(remesh or {}))
        self.controls = controls or {}
        self.changes = []           # (file, entries) that replace what is written
        self.faulty = None          # what was made wrong on purpose

    def add(self, body):
        self.bodies.append(body)
        return body

    @property
    def end(self):
        return self.step * self.steps

    def controls_written(self):
        entries = dict(startFrom="latestTime", startTime=0, stopAt="endTime",
                       endTime=self.end, deltaT=self.step, adjustTimeStep=self.adjust,
                       writeControl="timeStep", writeInterval=1, writeFormat="binary",
                       timePrecision=12)
        entries.update(self.controls)
        return entries

    def write(self, folder):
        shutil.rmtree(folder, ignore_errors=True)

        def put(path, *rest):
            write_dictionary(os.path.join(folder, path), *rest)

        put("constant/bodies", {b.name: b.written() for b in self.bodies})
        put("constant/fluid/material",
            dict(type="Newtonian", viscosity=self.flow.viscosity))
        if self.effects:
            put("constant/effects", self.effects)
        for body in self.bodies:
            if body.elastic:
                put(f"constant/{body.name}/material", body.elastic)
                put(f"system/{body.name}/fvSolution", {})
                put(f"system/{body.name}/fvSchemes",
                    dict(gradSchemes={}, divSchemes={}, laplacianSchemes={}))
        put("system/controlDict", self.controls_written())
        put("system/remeshDict", self.remesh)
        put("system/blockMeshDict", self.flow.block_mesh())
        put("system/fluid/fvSolution",
            dict(coupling=dict(method="coupled", tolerance=self.tolerance, order=self.order)))
        put("system/fluid/fvSchemes",
            {k: dict(default=v) for k, v in (("gradSchemes", "Gauss linear"),
             ("divSchemes", "none"), ("laplacianSchemes", "Gauss linear corrected"))})
        put("0/fluid/U", dict(dimensions="[0 1 -1 0 0 0 0]",
                              internalField="uniform (0 0 0)",
                              boundaryField=self.flow.conditions()), "volVectorField")
        for path, change in self.changes:
            with open(os.path.join(folder, path)) as file:
                changed = change(file.read())
            with open(os.path.join(folder, path), "w") as file:
                file.write(changed)
        with open(os.path.join(folder, "log.blockMesh"), "w") as log:
            subprocess.run(["blockMesh"], cwd=folder, stdout=log, stderr=log,
                           check=not self.faulty)
