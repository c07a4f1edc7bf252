# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries of a case's dictionaries, by foamDictionary."""

import os
import subprocess

from . import Refused

HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n"


def foam_dictionary(*arguments):
    """Run it. A PWD that is not where this program is would make it say so among the
    entries."""
    return subprocess.run(["foamDictionary", *arguments], capture_output=True, text=True,
                          env={**os.environ, "PWD": os.getcwd()})


class Entries:
    """The dictionaries of one case, by foamDictionary; of those in fixed,
    (file, entry, value), as they will be."""

    def __init__(self, case, fixed=()):
        self.case = case
        self.fixed = {(f, e): v for f, e, v in fixed}

    def path(self, file):
        return os.path.join(self.case, file)

    def _run(self, file, *arguments):
        return foam_dictionary("-disableFunctionEntries", *arguments, self.path(file))

    def get(self, file, entry):
        """Its text; None if there is none."""
        if (file, entry) in self.fixed:
            return self.fixed[file, entry]
        if not os.path.isfile(self.path(file)):
            return None
        done = self._run(file, "-entry", entry, "-value")
        return None if done.returncode else done.stdout.strip()

    def number(self, file, entry):
        try:
            return float(self.get(file, entry).rstrip(";"))
        except (AttributeError, ValueError):
            return None

    def keywords(self, file, entry):
        done = self._run(file, "-entry", entry, "-keywords") if entry else \
            self._run(file, "-keywords")
        return done.stdout.split() if not done.returncode else []

    def set(self, file, entry, value):
        if not os.path.isdir(os.path.dirname(self.path(file))):
            raise Refused(f"there is no folder for {file} in {self.case}")
        if not os.path.isfile(self.path(file)):
            with open(self.path(file), "w") as new:
                new.write(HEADER % os.path.basename(file))
        done = self._run(file, "-entry", entry, "-set", str(value))
        if done.returncode:
            why = [t for t in done.stderr.splitlines() if t.strip()][:4]
            raise Refused(f"cannot set {file}:{entry} to '{value}': {' '.join(why)}")

    def scale(self, file, entry, factor, default=None):
        """Multiply a number; one that is not there counts as its default."""
        value = self.number(file, entry)
        value = default if value is None else value
        if value is not None:
            self.set(file, entry, f"{value * factor:.10g}")
        return value is not None
