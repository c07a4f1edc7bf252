# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One place where the code is broken on purpose, from a file of changes/:

    What is wrong then, in a line

    file    src/bonds/contactRate.C
    tests   bonds                   those that should notice, cheapest first
    quick   yes                     also in the quick form (may be left out)

    -    the line of the file, whole
    +    what stands there instead
"""

import os

KEYS = "file", "tests", "quick"


class Mutant:
    def __init__(self, path):
        self.name = os.path.basename(path)
        with open(path) as file:
            self.text = file.read()
        self.what, entries, *changes = self.text.strip("\n").split("\n\n")
        entries = dict(line.split(None, 1) for line in entries.splitlines())
        if unknown := set(entries) - set(KEYS):
            raise ValueError(f"{path}: {', '.join(unknown)} is none of {', '.join(KEYS)}")
        self.file = entries["file"]
        self.tests = entries["tests"].split()
        self.quick = entries.get("quick") == "yes"
        self.changes = [self._change(path, change) for change in changes]

    @staticmethod
    def _change(path, text):
        """Lines before and after."""
        lines = text.splitlines()
        if not lines or any(line[:1] not in ("-", "+", " ") for line in lines):
            raise ValueError(f"{path}: lines of a change begin with -, + or a space")
        return tuple("".join(line[1:] + "\n" for line in lines if line[0] != sign)
                     for sign in "+-")

    def applied(self, root):
        """The changed text of the file; an error unless every change has its
        place exactly once, so that none is out of date without a word."""
        with open(os.path.join(root, self.file)) as file:
            text = file.read()
        for before, after in self.changes:
            n = ("\n" + text).count("\n" + before)
            if n != 1:
                raise ValueError(
                    f"mutant {self.name}: {self.file} has {n} places of\n{before}"
                    "where one is expected: bring changes/" + self.name + " up to date")
            text = ("\n" + text).replace("\n" + before, "\n" + after)[1:]
        return text


def read(folder):
    """All of a folder, by name; no editor's copies."""
    return {name: Mutant(os.path.join(folder, name))
            for name in sorted(os.listdir(folder)) if name.isalnum()}
