# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Samples of the resistance of a body beside a wall, and their runs."""

import csv
import hashlib
import os
import re
import sys
import time

import numpy as np

from fsbi.studies import Refused, dictionary
from fsbi.studies.runs import Bench, Failed
from fsbi.studies.spread import duration, spread

from . import frames

APPLICATION = "fsbiResistance"
SOLUTION = "system/fluid/fvSolution"
UNSEEN = ("system/controlDict", "constant/bodies", SOLUTION)
# a flow whose loads on the body are that part of those of its motion is none
NO_FLOW = 1e-9


class ResistanceBench(Bench):
    """Samples do not depend on how long a case runs, what acts on its body, or whether
    it is run by the table."""

    def _digest(self):
        sha = hashlib.sha256(self.prepare.encode())
        for name in self.entries.keywords("constant/bodies", ""):
            shape = self.entries.get("constant/bodies", f"{name}/shape")
            sha.update(f"{name} {shape}".encode())
        for file in self.files():
            if file in UNSEEN:
                continue
            with open(self.entries.path(file), "rb") as f:
                sha.update(file.encode() + f.read())
        sha.update(_solution(self.case).encode())
        return sha.hexdigest()


def _solution(case):
    """What of it is part of a sample, however it is written."""
    coupling = dictionary.read(case, SOLUTION).values.get("coupling")
    values = coupling.values if coupling else {}
    return str(sorted((word, str(value)) for word, value in values.items()
                      if word not in ("method", "reduced")))


class Setting:
    """An entry of the body, as a parameter of fsbi.studies.runs."""

    values, base = (None,), 0

    def __init__(self, name, body):
        self.name, self.entry = name, f"{body}/{name}"

    def key(self, value):
        return [["constant/bodies", self.entry, value]]

    def apply(self, entries, value):
        for row in self.key(value) if value is not None else ():
            entries.set(*row)


def _text(vector):
    return "(" + " ".join(f"{x:.10g}" for x in vector) + ")"


class Sample:
    """At a gap and an angle, leaning along the direction `lean` of the wall."""

    def __init__(self, about, gap, angle, lean):
        self.gap, self.angle, self.lean = gap, angle, lean
        body, n = about.body, about.normal
        wanted = gap + body.reach(angle)
        self.centre = about.position + (wanted - (about.position - about.origin) @ n) * n
        axis, turn = frames.rotation(body.axis, frames.leaning(n, lean, angle))
        self.settings = {"position": _text(self.centre)}
        if not body.sphere:
            self.settings["orientation"] = f"({_text(axis)} {turn:.12g})"

    def name(self):
        return f"gap {self.gap:.4g}" + (f", angle {np.degrees(self.angle):.3g}"
                                        if "orientation" in self.settings else "")

    def take(self, folder):
        """R and the flow's loads, laboratory axes."""
        path = os.path.join(folder, "postProcessing", "resistance.csv")
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        names = [n for n in rows[0] if n.startswith("R.")]
        self.R = np.array([[float(row[n]) for n in names] for row in rows])
        self.flow = np.array([float(row["flow"]) for row in rows])
        with open(os.path.join(folder, f"log.{APPLICATION}"), errors="replace") as log:
            found = re.search(r"^Fingerprint: (\S+)", log.read(), re.M)
        self.fingerprint = found[1] if found else ""


class Sampling:
    """Samples along two directions of the wall: that of the flow and across it."""

    def __init__(self, bench, about, jobs=1, out=sys.stdout):
        self.bench, self.about, self.jobs, self.out = bench, about, jobs, out
        self.parameters = [Setting(n, about.name) for n in ("position", "orientation")]
        self.kept, self.took, self.total = 0, [], self._count()

    def _count(self):
        return len(self.about.gaps) * (1 + 2 * (len(self.about.angles) - 1))

    def done(self):
        return self.kept + len(self.took)

    def run(self):
        """Upright ones say where the flow goes, the others lean there and across."""
        about = self.about
        some = frames.along_wall(about.normal)
        upright = [Sample(about, gap, 0.0, some) for gap in about.gaps]
        self._run(upright)
        self.flow = self._direction(upright)
        across = np.cross(about.normal, self.flow)
        leaning = [Sample(about, gap, angle, lean) for angle in about.angles[1:]
                   for lean in (self.flow, across) for gap in about.gaps]
        self._run(leaning)
        self.samples = upright + leaning
        prints = {s.fingerprint for s in self.samples}
        if len(prints) != 1:
            raise Refused("samples are of different cases: remove their folder, "
                          f"{self.bench.kept}")
        self.fingerprint = prints.pop()

    def _direction(self, samples):
        """Of the flow along the wall, by its force on the body where it is largest."""
        n = self.about.normal
        force = max((s.flow[:3] - (s.flow[:3] @ n) * n for s in samples), key=np.linalg.norm)
        size = np.linalg.norm(force)
        scale = samples[-1].R[0, 0] * self.about.body.across
        return force / size if size > NO_FLOW * scale else frames.along_wall(n)

    def _run(self, samples):
        waiting = [s for s in samples if not self._load(s)]
        if waiting and not self.took and self.kept:
            print(f"{self.kept} samples are kept from before", file=self.out)
        begun = {}

        def begin(sample):
            begun[sample] = time.monotonic()
            return lambda: self.bench.run(sample.settings, self.parameters)

        def finished(sample, job):
            try:
                sample.take(job.result()["folder"])
            except Failed as failure:
                raise Refused(f"{sample.name()}: {failure}") from None
            self.took.append(time.monotonic() - begun[sample])
            self._tell(sample)

        spread(waiting, self.jobs, begin, finished, self.bench.stop)

    def _load(self, sample):
        record = self.bench.load(sample.settings, self.parameters)
        if record:
            sample.take(record["folder"])
            self.kept += 1
        return bool(record)

    def _tell(self, sample):
        left = np.mean(self.took) * (self.total - self.done()) / self.jobs
        print(f"[{self.done()}/{self.total}] {sample.name()}; took {duration(self.took[-1])}"
              + (f"; {duration(left)} left" if left > 0 else ""), file=self.out, flush=True)
