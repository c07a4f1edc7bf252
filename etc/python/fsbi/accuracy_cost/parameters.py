# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study varies. A parameter has values, from coarse to fine; those that are
numbers have sizes, too (smaller is finer), so that limits can be estimated.

mesh, timeStep, tolerance are there for every case; their values are factors:

mesh        edges on bodies and inside them, far from them, smallest, and their
            growth (so that all edges are multiplied, wherever they are); over
            it: cells of blockMesh and across gaps
timeStep    deltaT; with adjustTimeStep also what bounds a step
tolerance   of the coupled solution, of turns between fluid and bodies, of the
            elastic bodies' solvers
"""

import glob
import os
import re

import numpy as np

from fsbi.studies import Refused

BUILT_IN = {
    "mesh": (2, 1.4, 1, 0.75),
    "timeStep": (4, 2, 1, 0.5),
    "tolerance": (1000, 30, 1, 0.03),
}


class Parameter:
    """values: texts from coarse to fine; sizes: numbers, or None; base: the
    index of the case as it is."""

    def __init__(self, name, values, sizes, base):
        self.name, self.values, self.sizes, self.base = name, values, sizes, base

    def numeric(self):
        return self.sizes is not None

    def size(self, value):
        """Relative to that of the case."""
        return self.sizes[self.values.index(value)] / self.sizes[self.base]

    def key(self, value):
        """What identifies the setting in a hash."""
        return [self.name, value]


class Factor(Parameter):
    """A built-in parameter; any factor is a value."""

    def __init__(self, name, factors=None):
        factors = sorted({1.0, *(factors or BUILT_IN[name])}, reverse=True)
        super().__init__(name, [f"{f:g}" for f in factors], factors, factors.index(1.0))

    def size(self, value):
        return float(value)

    def apply(self, entries, value):
        if float(value) != 1:
            SCALE[self.name](entries, float(value))


class Listed(Parameter):
    """Entries of dictionaries and lists of their values, side by side."""

    def __init__(self, name, columns, entries):
        self.columns = columns          # [(file, entry, [texts])]
        count = {len(c[2]) for c in columns}
        if len(count) > 1:
            raise Refused(f"parameter {name}: its entries have different numbers of values")
        if min(count) < 2 - len([c for c in columns if entries.get(*c[:2]) is not None]):
            raise Refused(f"parameter {name} has too few values")
        values = [" ".join(t) for t in zip(*(c[2] for c in columns))] \
            if len(columns) == 1 else list(columns[0][2])
        if len(set(values)) < len(values):
            raise Refused(f"parameter {name} has a value twice")
        texts = [list(t) for t in zip(*(c[2] for c in columns))]
        base = self._base(entries, texts)
        self.texts = dict(zip(values, texts))
        numeric = _sizes(values)
        if base is None:                # the case has none of them: it is one more
            now = entries.get(*columns[0][:2])
            if now is None and numeric:
                file, entry, _ = columns[0]
                raise Refused(f"parameter {name}: the case has no entry {entry} in {file}; give "
                              f"the number it stands for by --set {file}:{entry}=VALUE")
            extra = now if now is not None and now not in values else "as it is"
            self.texts[extra] = None
            values = _placed(values, extra)
            base = values.index(extra)
        super().__init__(name, values, _sizes(values), base)

    def _base(self, entries, texts):
        now = [entries.get(file, entry) for file, entry, _ in self.columns]
        for i, row in enumerate(texts):
            if all(_same(a, b) for a, b in zip(row, now)):
                return i
        return None

    def key(self, value):
        return [[f, e, t] for (f, e, _), t in zip(self.columns, self.texts[value])]

    def apply(self, entries, value):
        for (file, entry, _), text in zip(self.columns, self.texts[value] or ()):
            entries.set(file, entry, text)


def _number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def _same(text, now):
    if now is None:
        return False
    a, b = _number(text), _number(now)
    return abs(a - b) <= 1e-12 * abs(b) if None not in (a, b) else \
        text.split() == now.split()


def _placed(values, extra):
    """Numbers stay in their order, other texts come first."""
    numbers = [_number(v) for v in (*values, extra)]
    if None in numbers:
        return [extra, *values]
    rising = len(values) > 1 and numbers[1] > numbers[0]
    return sorted((*values, extra), key=float, reverse=not rising)


def _sizes(values):
    """Values from coarse to fine: those that rise are counts."""
    numbers = np.array([_number(v) or 0 for v in values], float)
    if len(numbers) < 2 or not (numbers > 0).all():
        return None
    if (np.diff(numbers) < 0).all():
        return list(numbers)
    if (np.diff(numbers) > 0).all():
        return list(1 / numbers)
    raise Refused("numbers of a parameter must go from coarse to fine: "
                  + " ".join(values))


# How the built-in parameters change a case

DEFAULT_SIZE = {"sphere": ("radius", 5), "ellipsoid": ("semiAxes", 3),
                "capsule": ("radius", 4), "leukocyte": ("radius", 5),
                "helix": ("filamentRadius", 1.5)}


def bodies(entries):
    found = entries.keywords("constant/bodies", "")
    return [name for name in found if not name.startswith(("#", "FoamFile"))]


def _default_size(entries, shape):
    """That of the shape's type, see etc/dictionaries/bodies; None: it has none."""
    kind = entries.get("constant/bodies", f"{shape}/type")
    length, part = DEFAULT_SIZE.get(kind, (None, 1))
    text = entries.get("constant/bodies", f"{shape}/{length}") if length else None
    numbers = [float(n) for n in re.findall(r"[-+.\deE]+", text or "")]
    return min(numbers) / part if numbers else None


def scale_mesh(entries, factor):
    shapes = [f"{b}/shape" for b in bodies(entries)
              if entries.get("constant/bodies", f"{b}/shape") is not None]
    for shape in shapes:
        entries.scale("constant/bodies", f"{shape}/size", factor,
                      _default_size(entries, shape))
    if shapes:
        entries.scale("system/remeshDict", "growth", factor, 0.25)
        entries.scale("system/remeshDict", "cellsPerGap", 1 / factor, 3)
    for file in ["system/remeshDict", *_inside(entries)]:
        for entry in ("farSize", "minSize"):
            entries.scale(file, entry, factor)
    for file in _inside(entries):
        entries.scale(file, "growth", factor)
    blocks = glob.glob(entries.path("system/**/blockMeshDict"), recursive=True)
    for path in blocks:
        scale_blocks(path, factor)
    if not shapes and not blocks:
        raise Refused("parameter mesh: the case has neither shapes nor a blockMeshDict; "
                      "give a parameter of your own")


def _inside(entries):
    found = glob.glob(entries.path("system/*/remeshDict"))
    return [os.path.relpath(p, entries.case) for p in found]


def scale_blocks(path, factor):
    """Cells of the blocks over the factor, at least one; also where they are
    given by $name."""
    with open(path) as file:
        text = file.read()
    names = set()

    def scaled(number):
        return str(max(1, round(int(number) / factor)))

    def block(match):
        words = match[2].split()
        names.update(w[1:] for w in words if w.startswith("$"))
        return match[1] + " ".join(w if w.startswith("$") else scaled(w)
                                   for w in words) + match[3]

    text = re.sub(r"(hex\s*\([^)]*\)\s*\w*\s*\()([^)]*)(\))", block, text)
    for name in names:
        text = re.sub(rf"^(\s*{re.escape(name.strip('{}'))}\s+)(\d+)(\s*;)",
                      lambda m: m[1] + scaled(m[2]) + m[3], text, flags=re.M)
    with open(path, "w") as file:
        file.write(text)


def scale_step(entries, factor):
    control = "system/controlDict"
    if not entries.scale(control, "deltaT", factor):
        raise Refused("parameter timeStep: system/controlDict has no number deltaT")
    for entry in ("maxDeltaT", "minDeltaT", "maxApproach"):
        entries.scale(control, entry, factor)
    if entries.get(control, "adjustTimeStep") in ("yes", "on", "true"):
        for entry in ("maxRotation", "maxTravel"):
            entries.scale(control, entry, factor, 0.2)


def scale_tolerance(entries, factor):
    for path in glob.glob(entries.path("system/*/fvSolution")) \
            + glob.glob(entries.path("system/fvSolution")):
        file = os.path.relpath(path, entries.case)
        there = entries.keywords(file, "")
        if "solid" in there:
            entries.scale(file, "solid/tolerance", factor, 1e-8)
        if "coupling" in there:
            entries.scale(file, "coupling/tolerance", factor, 1e-6)
            if "passes" in entries.keywords(file, "coupling"):
                entries.scale(file, "coupling/passes/tolerance", factor, 1e-6)
        elif file == "system/fluid/fvSolution":
            entries.set(file, "coupling", f"{{ tolerance {1e-6 * factor:g}; }}")


SCALE = {"mesh": scale_mesh, "timeStep": scale_step, "tolerance": scale_tolerance}


def make(given, entries):
    """The parameters of a list of [name, ...] as on the command line."""
    columns, parameters = {}, {}
    for name, *rest in given:
        if name in BUILT_IN and not (rest and ":" in rest[0]):
            try:
                factors = [float(r) for r in rest]
            except ValueError:
                raise Refused(f"parameter {name}: factors are numbers, not "
                              + " ".join(rest)) from None
            if any(f <= 0 for f in factors):
                raise Refused(f"parameter {name}: factors are above zero")
            parameters[name] = Factor(name, factors)
            continue
        file, colon, entry = (rest or [""])[0].partition(":")
        if not colon or len(rest) < 2:
            raise Refused(f"parameter '{' '.join([name, *rest])}' is not "
                          "NAME FILE:ENTRY VALUE VALUE ..., nor one of "
                          + ", ".join(BUILT_IN))
        if not os.path.isfile(entries.path(file)):
            raise Refused(f"parameter {name}: there is no {file} in {entries.case}")
        columns.setdefault(name, []).append((file, entry, rest[1:]))
        parameters[name] = None
    for name, found in columns.items():
        parameters[name] = Listed(name, found, entries)
    return [parameters[name] for name in parameters]
