# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the check of a validation wants to know of a finished run.

    run = Case("mesh1")
    run.velocity("tumourCell")[-1]          # at the last time
    run.seconds, run.cells, run.iterations
"""

import csv
import glob
import os
import re

import numpy as np

from .history import History


class Case:
    def __init__(self, folder):
        self.folder = folder
        self.history = History(os.path.join(folder, "postProcessing", "history.h5"))
        cost = self.history["cost"]
        self.cells = int(cost["cells"].max())
        self.iterations = cost["iterations"]
        self.seconds = self._seconds("total")
        self.solve_seconds = self._seconds("solve")
        # other programs disturb these less
        self.processor_seconds = self._last(r"^ExecutionTime = ([0-9.]+) s")

    def _seconds(self, part):
        """From the closing table of the log; nan if the run did not end."""
        return self._last(rf"^ *{part} +([0-9.]+) s ")

    def _last(self, pattern):
        """Number in the last line of the log that matches, or nan."""
        with open(os.path.join(self.folder, "log.fsbiFoam"), errors="replace") as log:
            found = re.findall(pattern, log.read(), re.M)
        return float(found[-1]) if found else float("nan")

    def time(self):
        return self.history["cost"]["time"]

    def _vectors(self, body, quantity):
        return self.history[f"bodies/{body}/{quantity}"].array[:, 1:]

    def position(self, body):
        return self._vectors(body, "position")

    def velocity(self, body):
        return self._vectors(body, "velocity")

    def spin(self, body):
        return self._vectors(body, "angularVelocity")

    def force(self, body, source="fluid"):
        return self._vectors(body, f"force/{source}")

    def largest(self, name, region):
        """Times and largest values of the function object fieldMinMax `name`
        of one field."""
        parts = os.path.join(self.folder, "postProcessing", region, name, "*", "*.dat")
        rows = []
        for path in sorted(glob.glob(parts), key=lambda p: float(p.split(os.sep)[-2])):
            with open(path) as file:
                rows += [line.split("\t") for line in file if line[0] != "#"]
        # time, field, smallest, where (and processor), largest, ...
        values = [[float(c) for c in row[2:] if "(" not in c] for row in rows]
        largest = [v[1] if len(v) == 2 else v[2] for v in values]
        return np.array([float(row[0]) for row in rows]), np.array(largest)

    def shape(self, body):
        """Times, Taylor's deformation and the inclination in the x-y plane
        (degrees) of an elastic body in a fluid."""
        table = self.history[f"elasticBodies/{body}/semiAxes"].array
        axis = self.history[f"elasticBodies/{body}/longestAxis"].array
        deformation = (table[:, 1] - table[:, 3]) / (table[:, 1] + table[:, 3])
        angle = np.degrees(np.arctan2(axis[:, 2], axis[:, 1])) % 180
        return table[:, 0], deformation, angle

    def torque(self, body, source="fluid"):
        return self._vectors(body, f"torque/{source}")


def reference(path):
    """The rows of a CSV file as dicts of floats; # starts a comment."""
    with open(path) as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{k: float(v) for k, v in row.items()} for row in rows]


def cases(pattern):
    """Finished runs among folders that match, in the order of their names."""
    return [Case(folder) for folder in sorted(glob.glob(pattern))
            if os.path.isfile(os.path.join(folder, "log.fsbiFoam"))]
