# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""system/reduceDict of a case, checked: see etc/dictionaries/reduceDict."""

import numpy as np

from fsbi.studies import dictionary

from .frames import Body

FILE = "system/reduceDict"
WORDS = ("wall", "gaps", "angles", "tolerance", "prepare")
FEWEST_GAPS, FEWEST_ANGLES = 5, 3       # of cubic splines, one of which may be left out


class Description:
    """What the dictionary says: origin and normal of the wall, gaps and angles of
    samples, tolerance, prepare; and what constant/bodies says of the one body."""

    def __init__(self, case, entries):
        top = dictionary.read(case, FILE)
        top.only(*WORDS)
        self.top, self.entries = top, entries
        self._read_body()
        self._read_wall()
        gaps = top.section("gaps")
        gaps.only("range", "number")
        self.low, self.high = gaps.pair("range")
        if not 0 < self.low < self.high:
            gaps.refuse("a range is (LOW HIGH), LOW above zero and below HIGH")
        self.gaps = np.geomspace(self.low, self.high,
                                 self._least(gaps, "number", FEWEST_GAPS))
        self.angles = np.array([0.0])
        if "angles" in top and self.body.sphere:
            top.refuse(f"'{self.name}' is a sphere: 'angles' is for ellipsoids")
        if not self.body.sphere:
            self.angles = np.linspace(0, np.pi / 2, self._least(top, "angles", FEWEST_ANGLES))
        self.tolerance = top.above("tolerance", 0, "0.01")
        self.prepare = dictionary.shown(top.get("prepare", "blockMesh"))

    def _least(self, given, word, least):
        number = given.count(word)
        if number < least:
            given.refuse(f"'{word}' is to be {least} or more, not {number}")
        return number

    def _read_wall(self):
        wall = self.top.section("wall")
        wall.only("point", "normal")
        self.origin, normal = (self._vector(wall.numbers(w), wall, w)
                               for w in ("point", "normal"))
        if not np.linalg.norm(normal) > 0:
            wall.refuse("'normal' is a direction, into the fluid")
        self.normal = normal / np.linalg.norm(normal)

    def _vector(self, numbers, given, word):
        if len(numbers) != 3:
            given.refuse(f"'{word}' is to be three numbers: {word} (X Y Z);")
        return np.array(numbers)

    def _of_body(self, entry):
        return self.entries.get("constant/bodies", f"{self.name}/{entry}")

    def _numbers(self, entry):
        try:
            return [float(t) for t in self._of_body(entry).strip("()").split()]
        except (AttributeError, ValueError):
            self.top.refuse(f"'{entry}' of '{self.name}' in constant/bodies is no numbers")

    def _read_body(self):
        names = [n for n in self.entries.keywords("constant/bodies", "") if n != "FoamFile"]
        if len(names) != 1:
            self.top.refuse(f"constant/bodies has {len(names)} bodies; a table is of one")
        self.name = names[0]
        kind, shape = self._of_body("type"), self._of_body("shape/type")
        if kind != "rigidBody" or shape not in ("sphere", "ellipsoid"):
            self.top.refuse(f"'{self.name}' of constant/bodies is a {kind} of shape {shape}; "
                            "a table is of a rigidBody, sphere or ellipsoid")
        self.position = np.array(self._numbers("position"))
        if shape == "sphere":
            radius = self._numbers("shape/radius")[0]
            self.body = Body((1, 0, 0), radius, radius)
            return
        sizes = self._numbers("shape/semiAxes")
        for k in range(3):
            others = [sizes[i] for i in range(3) if i != k]
            if others[0] == others[1]:
                self.body = Body(np.eye(3)[k], sizes[k], others[0])
                return
        self.top.refuse(f"'{self.name}' has three different semiAxes; a table is of an "
                        "ellipsoid of revolution")
