# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface files, whose solids are what fsbiDomain makes patches of."""


def write(path, solids):
    """solids: of every name its triangles, an array (n, 3, 3) or lists of points."""
    with open(path, "w") as file:
        for name, triangles in solids.items():
            file.write(f"solid {name}\n")
            for triangle in triangles:
                file.write(" facet normal 0 0 0\n  outer loop\n")
                for x in triangle:
                    file.write("   vertex " + " ".join(f"{c + 0.0:.9g}" for c in x) + "\n")
                file.write("  endloop\n endfacet\n")
            file.write(f"endsolid {name}\n")
