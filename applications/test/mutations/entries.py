# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the entries of an OpenFOAM dictionary stand in its text.

Reads well-formed text only: it is the tutorials' own, before it is mutated.
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(r'\s+|//[^\n]*|/\*.*?\*/|"[^"]*"|#[^\n]*|[{}()\[\];]|[^\s{}()\[\];"]+',
                   re.S)
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


@dataclass
class Token:
    text: str
    start: int

    @property
    def end(self):
        return self.start + len(self.text)


@dataclass
class Entry:
    """`keyword value;` or `keyword { ... }`; offsets in the text."""

    path: tuple
    start: int          # of the keyword
    opened: int         # of the value, or of {
    closed: int         # of the ; or }
    dictionary: bool

    @property
    def keyword(self):
        return self.path[-1]

    @property
    def end(self):
        return self.closed + 1


def tokens(text):
    """Without blanks, comments and directives such as #include."""
    found, at = [], 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"cannot read '{text[at:at + 20]}'")
        piece = match.group()
        if not (piece.isspace() or piece.startswith(("//", "/*", "#"))):
            found.append(Token(piece, at))
        at = match.end()
    return found


def numbers(text):
    """Tokens of a value that are numbers."""
    return [t for t in tokens(text) if NUMBER.fullmatch(t.text)]


def entries(text):
    """All entries, those of sub-dictionaries and of lists of them as well."""
    found = []
    level(tokens(text), 0, (), found)
    return found


def level(words, at, path, found):
    """The entries from words[at] to the end or the closing brace."""
    while at < len(words) and words[at].text != "}":
        if words[at].text in ("(", ")"):        # in a list of dictionaries
            at += 1
            continue
        keyword = words[at]
        here = (*path, keyword.text.strip('"'))
        if at + 1 < len(words) and words[at + 1].text == "{":
            at = sub_dictionary(words, at, here, found)
        else:
            at = leaf(words, at, here, found)
    return at


def sub_dictionary(words, at, path, found):
    entry = Entry(path, words[at].start, words[at + 1].start, 0, True)
    found.append(entry)
    end = level(words, at + 2, path, found)
    entry.closed = words[end].start
    return end + 1


def leaf(words, at, path, found):
    end, depth, inner = at, 0, False
    while end < len(words) and (depth or words[end].text != ";"):
        depth += words[end].text in ("(", "{", "[")
        depth -= words[end].text in (")", "}", "]")
        inner |= words[end].text == "{"
        end += 1
    if end == len(words):           # a list that is the file
        return end
    opened = words[at + 1].start if end > at + 1 else words[end].start
    found.append(Entry(path, words[at].start, opened, words[end].start, False))
    if inner:
        level(words[at + 1:end], 0, path, found)
    return end + 1
