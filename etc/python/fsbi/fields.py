# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and vertices of a case that was written with `writeFormat ascii`.

    points = fields.points("runs/bent/constant/polyMesh/points")
    u = fields.internal("runs/bent/1/beam/pointD")
    tip = u[fields.nearest(points, (10, 0.5, 0.5))]
"""

import re

import numpy as np


def _numbers(text, start):
    """The list that begins at the first bracket after start: n rows."""
    count = int(re.search(r"(\d+)\s*$", text[:text.index("(", start)]).group(1))
    first = text.index("(", start)
    last = text.find("\n)", first)
    body = text[first + 1:last if last > 0 else text.rindex(")")]
    values = np.array(body.replace("(", " ").replace(")", " ").split(), float)
    return values.reshape(count, -1)


def points(path):
    with open(path) as file:
        text = file.read()
    return _numbers(text, re.search(r"\n\d+\s*\n?\(", text).start())


def internal(path):
    """Values inside, one row each; one row only if they are all the same."""
    with open(path) as file:
        text = file.read()
    entry = text.index("internalField")
    kind = text[entry:].split()[1]
    if kind == "uniform":
        value = text[entry:text.index(";", entry)].split("uniform")[1]
        return np.array([value.strip(" ()").split()], float)
    start = text.index(">", entry)
    if re.match(r">\s*0", text[start:]):
        return np.zeros((0, 1))
    return _numbers(text, start)


def nearest(points, place):
    return int(np.argmin(np.linalg.norm(points - np.asarray(place), axis=1)))


def at(points, values, place, count=40):
    """Value at a place, where no point need be: of the quadratic polynomial that
    fits the nearest points best."""
    d = points - np.asarray(place)
    near = np.argsort(np.linalg.norm(d, axis=1))[:count]
    x, y, z = d[near].T
    monomials = np.stack([np.ones_like(x), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z], 1)
    return np.linalg.lstsq(monomials, values[near], rcond=None)[0][0]
