# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A dictionary of OpenFOAM as a tool of Python reads it: typos get one message.

    top = read("case", "system/ensembleDict")
    top.only("seeds", "parameters")             # whatever else is there is refused
    top.numbers("seeds"), top.sections("parameters")
"""

import os
import re

from . import Refused
from .entries import foam_dictionary

TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[{}();]|[^\s{}();"]+')


class Dictionary:
    """Words and their values; what a message calls it is its file and where in it.
    Values: a text, a list of such, or a Dictionary."""

    def __init__(self, name, values):
        self.name, self.values = name, values

    def __contains__(self, word):
        return word in self.values

    def refuse(self, what):
        raise Refused(f"{self.name}: {what}")

    def only(self, *words):
        for word in self.values:
            if word not in words:
                self.refuse(f"unknown keyword '{word}'; there are {', '.join(words)}")

    def one(self, *words):
        """Which of these is there, exactly one of them."""
        found = [word for word in words if word in self]
        if len(found) != 1:
            self.refuse(("has none of " if not found else "has several of ") + ", ".join(words))
        return found[0]

    def get(self, word, default=None):
        """Its text or list of texts."""
        if word not in self and default is None:
            self.refuse(f"'{word}' is missing")
        value = self.values.get(word, default)
        if isinstance(value, Dictionary):
            self.refuse(f"'{word}' is not to be a sub-dictionary")
        return value

    def choice(self, word, choices, default=None):
        value = self.get(word, default)
        if value not in choices:
            self.refuse(f"{word} '{shown(value)}' is not one of {', '.join(choices)}")
        return value

    def list(self, word):
        value = self.get(word)
        if not isinstance(value, list) or not value:
            self.refuse(f"'{word}' is to be a list: {word} (...);")
        return value

    def number(self, word, default=None):
        return self._number(word, self.get(word, default))

    def above(self, word, low, default=None):
        value = self.number(word, default)
        if not value > low:
            self.refuse(f"'{word}' is to be above {low:g}, not {value:g}")
        return value

    def count(self, word):
        value = self.number(word)
        if value != int(value) or value < 1:
            self.refuse(f"'{word}' is to be a whole number above zero, not {value:g}")
        return int(value)

    def pair(self, word):
        if len(self.list(word)) != 2:
            self.refuse(f"'{word}' is to be two numbers: {word} (A B);")
        return self.numbers(word)

    def numbers(self, word):
        return [self._number(word, v) for v in self.list(word)]

    def _number(self, word, value):
        try:
            return float(value)
        except (TypeError, ValueError):
            self.refuse(f"'{word}' is to be a number, not '{shown(value)}'")

    def section(self, word):
        section = self.values.get(word)
        if not isinstance(section, Dictionary):
            self.refuse(f"'{word}' is to be a sub-dictionary: {word} {{ ... }}")
        return section

    def sections(self, word):
        """Its sub-dictionaries by their names."""
        section = self.section(word)
        for name, value in section.values.items():
            if not isinstance(value, Dictionary):
                section.refuse(f"'{name}' is to be a sub-dictionary: {name} {{ ... }}")
        if not section.values:
            section.refuse("is empty")
        return section.values


def shown(value):
    return f"({' '.join(map(shown, value))})" if isinstance(value, list) else str(value)


def read(case, file):
    """As foamDictionary expands it."""
    path = os.path.join(case, file)
    if not os.path.isfile(path):
        raise Refused(f"there is no {file} in {case}")
    done = foam_dictionary(path)
    if done.returncode:
        error = re.search(r"--> FOAM FATAL.*?:\s*\n+(.*?)(\n\n|\Z)", done.stderr, re.S)
        raise Refused(f"{file}: {' '.join((error[1] if error else done.stderr).split())}")
    # what foamDictionary says to a person stands before the header
    text = done.stdout[max(0, done.stdout.find("FoamFile")):]
    tokens = TOKEN.findall(text)[::-1]
    values = _dictionary(file, tokens).values
    values.pop("FoamFile", None)
    return Dictionary(file, values)


def _dictionary(name, tokens):
    """From tokens, the next one last, to the bracket that closes it."""
    values = {}
    while tokens:
        word = tokens.pop()
        if word == "}":
            break
        if tokens[-1] == "{":
            tokens.pop()
            values[word] = _dictionary(f"{name}, {word}", tokens)
            continue
        value = []
        while tokens and tokens[-1] != ";":
            value.append(_value(tokens))
        tokens[-1:] = []
        values[word] = value[0] if len(value) == 1 else " ".join(map(shown, value))
    return Dictionary(name, values)


def _value(tokens):
    token = tokens.pop()
    if token != "(":
        return token.strip('"')
    found = []
    while tokens and tokens[-1] != ")":
        found.append(_value(tokens))
    tokens[-1:] = []
    return found
