# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Patients, from a table (.csv) of the case: one a row, a column `patient` with their
names, the others numbers (densities of receptors, K_D, a volume ...)."""

import csv
import math

from fsbi.studies.dictionary import shown

from .sampling import Varied, pairs

NAME = "patient"
WORDS = ("table", "entries")


def read_table(path, file, refuse):
    """(columns, rows: (line, texts by column)). Units in brackets, `dose (mg)`, do not
    belong to a name; empty lines and those that begin with # say nothing."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as lines:
            reader = csv.reader(lines)
            found = [(reader.line_num, [c.strip() for c in row]) for row in reader
                     if any(c.strip() for c in row) and not row[0].lstrip().startswith("#")]
    except (OSError, UnicodeDecodeError) as error:
        refuse(f"no table {file}: {error}")
    if len(found) < 2:
        refuse(f"{file} has no line but its header" if found else f"{file} is empty")
    columns = [c.partition("(")[0].strip() for c in found[0][1]]
    twice = [c for c in columns if columns.count(c) > 1]
    if twice:
        refuse(f"{file} has two columns '{twice[0]}'")
    for line, row in found[1:]:
        if len(row) != len(columns):
            refuse(f"{file}, line {line}: {len(row)} values, but {len(columns)} columns")
    return columns, [(line, dict(zip(columns, row))) for line, row in found[1:]]


def column(rows, name, file, refuse, above=None):
    """Numbers, not below zero, or above a number."""
    found = []
    for line, row in rows:
        where = f"{file}, line {line}: {name}"
        if not row[name]:
            refuse(f"{where} is missing")
        try:
            value = float(row[name])
        except ValueError:
            refuse(f"{where} is '{row[name]}', not a number")
        if not math.isfinite(value) or value < 0 or above is not None and not value > above:
            least = "not below zero" if above is None else f"above {above:g}"
            refuse(f"{where} is to be {least}, not {row[name]}")
        found.append(value)
    return found


class Patients(Varied):
    """A parameter: whoever it is, some entries get the values in its columns."""

    logarithmic = False

    def __init__(self, given, path):
        """path(file): of a file of the case."""
        given.only(*WORDS)
        self.given, self.file = given, shown(given.get("table"))
        self.columns, self.rows = read_table(path(self.file), self.file, given.refuse)
        if NAME not in self.columns:
            given.refuse(f"{self.file} has no column '{NAME}' but {', '.join(self.columns)}")
        self.texts = [row[NAME] for _, row in self.rows]
        for name in self.texts:
            if not name or self.texts.count(name) > 1:
                given.refuse(f"{self.file}: every patient has a name of its own, not '{name}'")
        self.taken = self._taken(given)
        super().__init__(NAME, [pair for pairs in self.taken.values() for pair in pairs])

    def _taken(self, given):
        """Columns and the entries that have their values."""
        if "entries" not in given:
            return {}
        named = given.section("entries")
        for word in named.values:
            self.numbers(word, named.refuse)
        return {word: pairs(named, word) for word in named.values}

    def numbers(self, name, refuse, above=None):
        """By the names of patients."""
        if name == NAME or name not in self.columns:
            others = [c for c in self.columns if c != NAME]
            refuse(f"{self.file} has no column '{name}' but {', '.join(others)}")
        return dict(zip(self.texts, column(self.rows, name, self.file, refuse, above)))

    def listed(self):
        return self.texts

    def _settings(self, patient):
        row = next(row for _, row in self.rows if row[NAME] == patient)
        return [[*pair, row[name]] for name, several in self.taken.items() for pair in several]

    def key(self, value):
        """With the name: two who are alike have runs of their own."""
        return [[NAME, value], *self._settings(value)]

    def apply(self, entries, value):
        for row in self._settings(value) if value is not None else ():
            entries.set(*row)
