# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A number out of a finished run.

    [LABEL=]PATH[:REDUCTION]

PATH            of the history, with . or / between its parts and the column last:
                bodies.tumourCell.angularVelocity.y, bodies.bead.force.x,
                bonds.PAIR.COLUMN, cost.iterations; mag for the length of a vector.
                omega, U, x, drag, torque: short for angularVelocity, velocity,
                position, force/fluid, torque/fluid. Of elastic bodies in a flow
                also deformation (Taylor's) and angle (degrees, in the x-y plane).
                bodies.A-B.U.mag: of the difference of two bodies
errors.COLUMN   of the function object exactError
resistance.I.J  of fsbiResistance's matrix, I and J from 1 to 6
regions.REGION.FIELD.max|min|mean   of the magnitude, at the last time
REDUCTION       last (default), first, max, min, sum (of all rows), mean (over
                time), mean=T0,T1, at=T (linear between steps), rms=V (root mean square over time of
                the distance from V; its reference is 0, its --scale V)
"""

import csv
import functools
import glob
import json
import os
import re

import numpy as np

from fsbi.history import History

from . import Refused

SHORT = {"omega": ["angularVelocity"], "U": ["velocity"], "x": ["position"],
         "drag": ["force", "fluid"], "torque": ["torque", "fluid"],
         "force": ["force", "fluid"]}
REDUCTION = re.compile(r"last|first|max|min|sum|mean(=[^,]+,[^,]+)?|(at|rms)=.+")


class Quantity:
    def __init__(self, text):
        self.text = text
        head, _, self.reduction = text.partition(":")
        label, equals, path = head.partition("=")
        self.path = (path if equals else head).strip()
        self.label = label.strip() if equals else self._short_label()
        self.reduction = self.reduction.strip() or "last"
        self.parts = re.split(r"[./]", self.path)
        self._check()

    def _short_label(self):
        return " ".join(re.split(r"[./]", self.path)[1:]) or self.path

    def _check(self):
        if len(self.parts) < 2 or not all(self.parts):
            raise Refused(f"quantity '{self.text}' is not [LABEL=]PATH[:REDUCTION], "
                          "such as bodies.tumourCell.omega.y:mean")
        if not REDUCTION.fullmatch(self.reduction):
            raise Refused(f"quantity '{self.text}': reduction '{self.reduction}' is not "
                          "last, first, max, min, sum, mean, mean=T0,T1, at=T or rms=V")
        try:
            self.numbers = [float(t) for t in self.reduction.partition("=")[2].split(",") if t]
        except ValueError:
            raise Refused(f"quantity '{self.text}': the numbers in "
                          f"'{self.reduction}' are not numbers") from None

    def value(self, folder):
        """Of the run kept in folder; Refused with what there is instead."""
        first = self.parts[0]
        if first == "errors":
            return _from_errors(folder, self.parts[1])
        if first == "resistance":
            return _from_resistance(folder, self.parts[1:])
        if first == "regions":
            return _from_fields(folder, self.parts[1:])
        return reduce(*self._series(folder), self.reduction, self.numbers)

    def _series(self, folder):
        try:
            history = _history(os.path.join(folder, "postProcessing/history.h5"))
        except (FileNotFoundError, OSError) as error:
            raise Refused(f"quantity '{self.text}': {error}") from None
        found = (_derived(history, self.parts) or _column(history, self.parts)
                 or _difference(history, self.parts))
        if found is None:
            raise Refused(f"quantity '{self.text}' is not in the history; there are "
                          + ", ".join(_offered(history)))
        return found


def _history(path):
    about = os.stat(path) if os.path.isfile(path) else None
    return _read(path, about and (about.st_ino, about.st_mtime_ns, about.st_size))


@functools.lru_cache(maxsize=1)     # a study asks one run for all of its quantities
def _read(path, version):
    return History(path)


def _offered(history):
    return [p.replace("/", ".") + ".{" + ",".join(history[p].columns[1:]) + "}"
            for p in history.paths()]


def _spellings(parts):
    """The ways a path may stand in the history."""
    name = "/".join(parts[:2] + [w for p in parts[2:] for w in SHORT.get(p, [p])])
    for spelling in ("/".join(parts), name):
        yield spelling
        yield "effects/" + spelling
        yield re.sub("^bodies/", "elasticBodies/", spelling)


def _column(history, parts):
    for end, column in ((len(parts) - 1, parts[-1]), (len(parts), None)):
        for path in _spellings(parts[:end]):
            if path in history:
                table = history[path]
                values = _of(table.columns[1:], table.array[:, 1:], column)
                if values is not None:
                    return table.array[:, 0], values
    return None


def _of(columns, values, column):
    """One of the columns of a vector, or its length; None if it has no such."""
    if column == "mag" or column is None and len(columns) > 1:
        return np.linalg.norm(values, axis=1)
    if column is None:
        return values[:, 0]
    return values[:, columns.index(column)] if column in columns else None


def _difference(history, parts):
    """Of a vector of two bodies, A-B; a body's name may have dashes itself."""
    words = parts[1].split("-")
    for i in range(1, len(words)):
        a, b = (_table(history, [parts[0], "-".join(name), *parts[2:-1]])
                for name in (words[:i], words[i:]))
        if a and b:
            values = _of(a.columns[1:], a.array[:, 1:] - b.array[:, 1:], parts[-1])
            return None if values is None else (a.array[:, 0], values)
    return None


def _table(history, parts):
    return next((history[p] for p in _spellings(parts) if p in history), None)


def _derived(history, parts):
    """Taylor's deformation and the inclination of an elastic body."""
    path = f"elasticBodies/{parts[1]}/"
    if parts[-1] not in ("deformation", "angle") or path + "semiAxes" not in history:
        return None
    axes, longest = history[path + "semiAxes"].array, history[path + "longestAxis"].array
    if parts[-1] == "angle":
        return axes[:, 0], np.degrees(np.arctan2(longest[:, 2], longest[:, 1])) % 180
    return axes[:, 0], (axes[:, 1] - axes[:, 3]) / (axes[:, 1] + axes[:, 3])


def reduce(time, values, reduction, numbers=()):
    kind = reduction.partition("=")[0]
    if not len(time):                   # a table of events, of which there were none
        return 0.0 if kind == "sum" else np.nan
    if kind in ("last", "first"):
        return float(values[-1 if kind == "last" else 0])
    if kind in ("max", "min", "sum"):
        return float(getattr(np, kind)(values))
    if kind == "at":
        if not time[0] <= numbers[0] <= time[-1] * (1 + 1e-9):
            raise Refused(f"time {numbers[0]:g} is outside the run, {time[0]:g} to {time[-1]:g}")
        return float(np.interp(numbers[0], time, values))
    if kind == "rms":
        return _mean(time, (values - numbers[0]) ** 2, ()) ** 0.5
    return _mean(time, values, numbers)


def _mean(time, values, numbers):
    """Over time, between steps linear."""
    if len(time) == 1:
        return float(values[0])
    low, high = numbers or (time[0], time[-1])
    low, high = max(low, time[0]), min(high, time[-1])
    if not low < high:
        raise Refused(f"the window {numbers[0]:g} to {numbers[1]:g} is outside the run, "
                      f"{time[0]:g} to {time[-1]:g}")
    at = np.concatenate(([low], time[(time > low) & (time < high)], [high]))
    of = np.interp(at, time, values)
    return float(np.sum(0.5 * (of[1:] + of[:-1]) * np.diff(at)) / (high - low))


def _from_errors(folder, column):
    from fsbi import errors
    try:
        return float(errors.read(folder)[column])
    except (FileNotFoundError, KeyError) as error:
        raise Refused(f"quantity 'errors.{column}': {error}") from None


def _from_resistance(folder, indices):
    try:
        with open(os.path.join(folder, "postProcessing/resistance.csv")) as file:
            rows = list(csv.reader(file))
        i, j = (int(n) for n in indices)
        return float(rows[i][1 + j])
    except (OSError, ValueError, IndexError) as error:
        raise Refused(f"quantity 'resistance.{'.'.join(indices)}': {error}") from None


def _from_fields(folder, parts):
    try:
        with open(os.path.join(folder, "fields.json")) as file:
            table = json.load(file)
        return table[".".join(parts[:-1])][parts[-1]]
    except (OSError, KeyError):
        there = ", ".join(f"regions.{k}" for k in table) if "table" in locals() else "none"
        raise Refused(f"quantity 'regions.{'.'.join(parts)}' is not among the fields "
                      f"written at the last time (.max, .min, .mean): {there}") from None


def summarise_fields(case, kept):
    """fields.json: max, min, mean of the magnitude of all cell fields that the
    run wrote at its last time, since its mesh and fields are not kept."""
    times = [d for d in glob.glob(os.path.join(case, "*/"))
             if re.fullmatch(r"[0-9.]+(e[-+]?\d+)?", os.path.basename(d[:-1]))]
    table = {}
    if times:
        last = max(times, key=lambda d: float(os.path.basename(d[:-1])))
        for path in glob.glob(last + "*/*"):
            size = _magnitudes(path)
            if size is not None and len(size):
                region, field = path.split(os.sep)[-2:]
                table[f"{region}.{field}"] = dict(
                    max=float(size.max()), min=float(size.min()), mean=float(size.mean()))
    with open(os.path.join(kept, "fields.json"), "w") as file:
        json.dump(table, file)


def _magnitudes(path):
    """Of a volume field, binary or ascii; None if the file is none."""
    if not os.path.isfile(path):
        return None
    with open(path, "rb") as file:
        data = file.read()
    entry = re.search(rb"internalField\s+nonuniform\s+List<(\w+)>\s*(\d+)\s*\(", data)
    if not entry or not re.search(rb"class\s+vol\w+Field", data[:1000]):
        return None
    width = {b"scalar": 1, b"vector": 3, b"symmTensor": 6, b"tensor": 9}.get(entry[1])
    count = int(entry[2]) * (width or 0)
    if not count:
        return None
    if re.search(rb"format\s+binary", data[:1000]):
        values = np.frombuffer(data, float, count, entry.end())
    else:
        body = data[entry.end():data.index(b"\n)", entry.end())]
        values = np.array(body.replace(b"(", b" ").replace(b")", b" ").split(), float)
    values = values.reshape(-1, width)
    return values[:, 0] if width == 1 else np.linalg.norm(values, axis=1)
