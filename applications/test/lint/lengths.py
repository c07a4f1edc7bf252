# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of libraries that are longer than 60 lines.

    lengths.py FOLDER    a line for each; exit 1 if there is one
"""

import os
import re
import sys

LONGEST = 60
NO_FUNCTION = re.compile(r"^(namespace|class|struct|enum|extern)\b")


def sources(top):
    for folder, folders, names in os.walk(top):
        folders[:] = [f for f in folders if f not in ("lnInclude", "Make")]
        for name in sorted(names):
            if name.endswith((".C", ".H")):
                yield os.path.join(folder, name)


def long_functions(lines):
    """(line, length) of those that begin and end at the margin, as in a .C file."""
    opened = None
    for i, line in enumerate(lines):
        if line == "{":
            opened = i
        elif line == "}" and opened is not None:
            if i - opened - 1 > LONGEST and not NO_FUNCTION.match(lines[opened - 1]):
                yield opened + 1, i - opened - 1
            opened = None


def main():
    found = False
    for path in sources(sys.argv[1]):
        with open(path) as file:
            lines = file.read().split("\n")
        for line, length in long_functions(lines):
            print(f"{path}:{line}: a function of {length} lines, more than {LONGEST}")
            found = True
    return found


if __name__ == "__main__":
    sys.exit(main())
