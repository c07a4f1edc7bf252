# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a page tells of a run, as plain numbers and texts."""

import glob
import os
import re

import numpy as np

from .. import steps
from ..history import History
from . import units

MAX_ROWS = 2000         # of a curve; more are thinned, which the page says
MAX_PICTURES = 3e6      # bytes


class Run:
    def __init__(self, case, system):
        self.case = os.path.abspath(case)
        self.system = system
        self.history = History(os.path.join(case, "postProcessing", "history.h5"))
        self.starts = sorted(self.history.runs.items(), key=lambda run: float(run[0]))
        self.steps = steps.tried(case)
        self.parts, self.seconds = steps.seconds(case)

    def unit(self, text):
        return units.named(text, self.system)

    def latest(self, note):
        """Lines of a note of the last start; none in histories of before."""
        return self.starts[-1][1].get(note, []) if self.starts else []

    def bodies(self):
        """(kind, name) of each."""
        return [tuple(line.split(" ", 1)) for line in self.latest("bodies")]

    def defaults(self):
        """(file, entry, value) of each default that was taken."""
        found = []
        for line in self.latest("defaults"):
            where, key, value = line.split(" ", 2)
            file, _, inside = where.partition(".")
            found.append((file, f"{inside}.{key}" if inside else key, value))
        return found

    def tables(self):
        """All that was recorded once a step."""
        return [self._table(path) for path in self.history.paths()
                if not self._of_events(path)]

    def _of_events(self, path):
        """Rows of their own instants, not one a step."""
        return "instant" in self.history[path].columns

    def events(self):
        return {p: len(self.history[p]) for p in self.history.paths() if self._of_events(p)}

    def _table(self, path):
        table = self.history[path]
        rows = thinned(len(table))
        return {
            "path": path,
            "columns": table.columns,
            "units": [self.unit("T")] + [
                self.unit(u) for u in units.of_columns(table.columns[1:], table.units)],
            "rows": table.array[rows],
            "recorded": len(table),
        }

    def end_time(self):
        text = self._read("system/controlDict")
        found = re.search(r"^\s*endTime\s+([^;\s]+)\s*;", text, re.M)
        try:
            return float(found.group(1))
        except (AttributeError, ValueError):
            return None

    def status(self):
        """How far it came, in words."""
        times = self.history["cost"]["time"]
        now = times[-1] if len(times) else 0.0
        end = self.end_time()
        if end is None:
            return f"recorded to {now:g} {self.unit('T')}"
        if now >= end * (1 - 1e-6):
            return f"complete, to {now:g} {self.unit('T')}"
        return f"recorded to {now:g} of {end:g} {self.unit('T')}: running, or stopped early"

    def _read(self, name):
        try:
            with open(os.path.join(self.case, name), errors="replace") as file:
                return file.read()
        except OSError:
            return ""

    def dictionaries(self):
        """(name, text) of what the case's folders hold now."""
        found = []
        for top in ("constant", "system", "0.orig"):
            for folder, inner, files in os.walk(os.path.join(self.case, top)):
                inner[:] = sorted(set(inner) - {"polyMesh", "triSurface"})
                for name in sorted(files):
                    path = os.path.relpath(os.path.join(folder, name), self.case)
                    if os.path.getsize(os.path.join(folder, name)) < 30_000:
                        found.append((path, self._read(path)))
        return found

    def pictures(self):
        """Paths of the pictures in the case's folder, as many as fit."""
        kept, size = [], 0
        for path in sorted(glob.glob(os.path.join(self.case, "*.png"))):
            size += os.path.getsize(path)
            if size < MAX_PICTURES:
                kept.append(path)
        return kept


def thinned(n, most=MAX_ROWS):
    """Rows to show of n: all, or evenly chosen with the first and the last."""
    return np.unique(np.linspace(0, n - 1, min(n, most)).round().astype(int))
