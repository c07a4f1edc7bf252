# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lower libraries know nothing of higher ones: src/layers, from the sources.

    layers.py ROOT              a line for everything that looks upward; exit 1
    layers.py ROOT --picture    the picture of src/README.md
"""

import os
import re
import sys

root = sys.argv[1]
src = os.path.join(root, "src")


def read(path):
    with open(path) as file:
        return file.read()


def libraries():
    return re.sub("#.*", "", read(os.path.join(src, "layers"))).split()


def sources(library):
    for folder, folders, names in os.walk(os.path.join(src, library)):
        folders[:] = [f for f in folders if f not in ("lnInclude", "Make")]
        for name in sorted(names):
            if name.endswith((".C", ".H")):
                yield os.path.join(folder, name)


def declared(library):
    """FSBI_USES of Make/options."""
    options = read(os.path.join(src, library, "Make", "options"))
    found = re.findall(r"^FSBI_USES\s*=(.*)", options, re.M)
    return found[-1].split() if found else []


def code(path):
    """Without comments and texts, but with what is included."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", read(path), flags=re.S)
    included = re.findall(r'#include "([^"]+)"', text)
    return re.sub(r'"(\\.|[^"\\\n])*"', '""', text), included


def namings(text, name):
    """Uses of a class by its name: of a variable of this name there are none."""
    return re.search(
        rf"\b(class|struct) {name};|\b{name}(::|[&*][ )>,])|<(const )?{name}[&*]?>", text)


order = libraries()
home = {os.path.basename(path): library
        for library in order for path in sources(library) if path.endswith(".H")}
faults = []
uses = {library: set() for library in order}
for i, library in enumerate(order):
    below = order[:i]
    for other in declared(library):
        if other not in below:
            faults.append(f"src/{library}/Make/options uses '{other}', which is not below it"
                          " in src/layers")
    for path in sources(library):
        text, included = code(path)
        place = os.path.relpath(path, root)
        for header in included:
            other = home.get(header, library)
            if other != library:
                uses[library].add(other)
            if other != library and other not in below:
                faults.append(f"{place} includes {header} of the higher library '{other}'")
        for header, other in home.items():
            upward = other != library and other not in below
            if upward and header[:-2] in text and namings(text, header[:-2]):
                faults.append(f"{place} names {header[:-2]} of the higher library '{other}'")
missing = set(os.listdir(src)) - set(order) - {"layers", "README.md"}
faults += [f"src/{name} is not in src/layers" for name in sorted(missing)]

if "--picture" in sys.argv:
    width = max(map(len, order))
    for i, library in enumerate(order):
        row = "  ".join("x" if other in uses[library] else "." for other in order[:i])
        print(f"{library:{width}}  {row}{'  ' if i else ''}#".rstrip())
    sys.exit(0)
print("\n".join(faults))
sys.exit(1 if faults else 0)
