# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""All one-change mutations of the dictionaries of a case."""

import hashlib
import os
import random
from dataclasses import dataclass, field

from entries import entries, numbers, tokens

HEADER = "FoamFile"


@dataclass
class Mutation:
    tutorial: str
    file: str           # in the case
    path: tuple         # of the entry, or empty: the file
    kind: str
    content: bytes = field(repr=False)      # None: no file
    line: int = 0
    same: str = ""      # equal for the same change of the same entry or file
    new: str = ""       # word that the keyword or value was changed to

    @property
    def keyword(self):
        return self.path[-1] if self.path else ""

    @property
    def id(self):
        return f"{self.tutorial}:{self.file}:{'.'.join(self.path)}:{self.kind}"


def misspelt(word):
    """A letter lost, or of short words one too much."""
    quote = word.startswith('"')
    plain = word.strip('"')
    middle = len(plain) // 2
    wrong = plain[:middle] + plain[middle + 1:] if len(plain) > 3 else plain + "x"
    return f'"{wrong}"' if quote else wrong


def with_numbers(value, change):
    """The value with every number changed; None if that is the same."""
    new, last = "", 0
    for number in numbers(value):
        new += value[last:number.start] + change(number.text)
        last = number.end
    new += value[last:]
    return new if new != value else None


def negative(number):
    if float(number) == 0:
        return number
    return number[1:] if number[0] == "-" else "-" + number.lstrip("+")


def changed_values(value):
    """(kind, new value); None where the kind makes no sense."""
    words = tokens(value)
    yield "negated", with_numbers(value, negative)
    yield "zeroed", with_numbers(value, lambda n: "0")
    yield "1e300", with_numbers(value, lambda n: "1e300")
    yield "nan", with_numbers(value, lambda n: "nan")
    yield "word", "word" if value != "word" else None
    yield "undefined", "$undefined"
    if len(words) == 1 and not numbers(value):
        yield "value misspelt", misspelt(value)


def of_leaf(text, entry):
    before, after = text[:entry.start], text[entry.end:]
    keyword = text[entry.start:entry.opened]
    value = text[entry.opened:entry.closed]
    yield "deleted", before + after
    if entry.path[0] != HEADER:
        yield "misspelt", before + respelt(text, entry) + after
        for kind, new in changed_values(value):
            if new is not None:
                yield kind, before + keyword + new + ";" + after
        yield "twice", before + 2 * (text[entry.start:entry.end] + "\n") + after
    else:
        yield "word", before + keyword + "word;" + after
    yield "no semicolon", text[:entry.closed] + after


def changed_to(text, entry, kind):
    if kind == "misspelt":
        return misspelt(entry.keyword)
    if kind == "value misspelt":
        return misspelt(text[entry.opened:entry.closed]).strip('"').replace("<case>/", "")
    return kind if kind in ("word", "undefined", "nan", "1e300") else ""


def respelt(text, entry):
    """The entry with its keyword misspelt."""
    rest = text[entry.start:entry.end]
    old = tokens(rest)[0].text
    return misspelt(old) + rest[len(old):]


def of_dictionary(text, entry):
    before, after = text[:entry.start], text[entry.end:]
    yield "deleted", before + after
    yield "misspelt", before + respelt(text, entry) + after
    yield "emptied", text[:entry.opened] + "{}" + after
    yield "word", text[:entry.opened] + "word;" + after
    yield "not opened", text[:entry.opened] + text[entry.opened + 1:]
    yield "not closed", text[:entry.closed] + after
    if entry.path[0] != HEADER:
        yield "twice", before + 2 * (text[entry.start:entry.end] + "\n") + after
    if len(entry.path) == 1:
        yield "comment not closed", before + "/* " + text[entry.start:]


def cut_of(data):
    """Where two thirds of a file end, within an entry."""
    behind = 2 * len(data) // 3
    ends = [i for i in (data.find(b";", behind), data.find(b"}", behind)) if i >= 0]
    return min(ends, default=behind)


def of_file(text):
    """(kind, bytes); None: the file is missing."""
    data = text.encode()
    yield "missing", None
    yield "empty", b""
    yield "UTF-16", text.encode("utf-16")
    yield "BOM", b"\xef\xbb\xbf" + data
    yield "CRLF", data.replace(b"\n", b"\r\n")
    yield "Latin-1 comment", data + "// Zellgröße in µm\n".encode("latin-1")
    yield "cut", data[:cut_of(data)]
    yield "brace too many", data + b"}\n"
    yield "comment not opened", data + b"of the cell */\n"
    yield "quote not closed", data + b'note "of the cell;\n'
    yield "a folder", b"folder"         # see apply()


def of_text(tutorial, file, text):
    """All mutations of a file."""
    def made(path, kind, data, what, line=0, new=""):
        same = hashlib.sha1(" ".join([file, *path, kind, *what.split()]).encode())
        return Mutation(tutorial, file, path, kind, data, line, same.hexdigest(), new)

    for kind, data in of_file(text):
        yield made((), kind, data, text)
    for entry in entries(text):
        change = of_dictionary if entry.dictionary else of_leaf
        line = text.count("\n", 0, entry.start) + 1
        for kind, new in change(text, entry):
            if new != text:
                yield made(entry.path, kind, new.encode(), text[entry.start:entry.end], line,
                           changed_to(text, entry, kind))


def dictionaries(case):
    """The files that a user writes and fsbiFoam or blockMesh reads."""
    found = []
    for top in ("0", "constant", "system"):
        for folder, inner, files in os.walk(os.path.join(case, top)):
            inner[:] = sorted(d for d in inner if d not in ("polyMesh", "fieldDesign"))
            found += [os.path.relpath(os.path.join(folder, f), case) for f in sorted(files)
                      if f not in ("fieldDesignDict", "decomposeParDict")]
    return found


def of_case(tutorial, case):
    for file in dictionaries(case):
        with open(os.path.join(case, file), encoding="utf-8") as opened:
            yield from of_text(tutorial, file, opened.read())


def drawn(mutations, seed=1):
    """In a drawn order: every change of the same entry or file first in the
    first tutorial that has it, then in the others."""
    seen, first, again = set(), [], []
    for mutation in mutations:
        (again if mutation.same in seen else first).append(mutation)
        seen.add(mutation.same)
    for part in (first, again):
        random.Random(seed).shuffle(part)
    return first + again


def apply(mutation, case):
    path = os.path.join(case, mutation.file)
    os.remove(path)
    if mutation.kind == "a folder":
        os.mkdir(path)
    elif mutation.content is not None:
        with open(path, "wb") as file:
            file.write(mutation.content)
