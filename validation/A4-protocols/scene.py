# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A block held over a wall, with KINDS kinds of receptors that know nothing of each other;
as a program it writes the case's surface, effects and ensembleDict.

The block's bottom is flat, and all of its receptors have the same rate; it comes first in
the file, and 1/DENSITY divides its area, so that it has exactly SIDE^2 DENSITY of them."""

import numpy as np

from fsbi import stl

KINDS = 8               # of receptors: as many first bonds from one run
SET = (1, 5)            # kinds that a study sets the entries of; the next ones follow
SIDE, HEIGHT = 4.0, 2.0     # um
CUTS = 4                # of every edge
GAP = 2.05              # um
STALKS, REST = 2.0, 0.1     # um: roughness and lambda
STIFFNESS = 0.043       # pg/us2
TEMPERATURE = 310.0     # K
RATE = 1e-7             # k0on, 1/us
DENSITY, LIGANDS = 15.0, 100.0      # 1/um2
END = 16000.0           # us; all have bound
AT = 4000.0             # us; when it is asked for bonds

HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"


def face(origin, u, v):
    """Triangles of a rectangle, its normal along u x v."""
    origin, u, v = (np.array(x, float) for x in (origin, u, v))
    for i in range(CUTS):
        for j in range(CUTS):
            a, b, c, d = (origin + (x * u + y * v) / CUTS for x, y in
                          ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            yield from ([a, b, c], [a, c, d])


def block():
    a, h = SIDE / 2, HEIGHT / 2
    x, y, z = (SIDE, 0, 0), (0, HEIGHT, 0), (0, 0, SIDE)
    return [*face((-a, -h, -a), x, z), *face((-a, h, -a), z, x),
            *face((-a, -h, -a), y, x), *face((-a, -h, a), x, y),
            *face((-a, -h, -a), z, y), *face((a, -h, -a), y, z)]


def effects():
    kinds = range(1, KINDS + 1)
    receptors = "\n".join(
        f"R{i} {{ density {DENSITY:g}; blocked 0; }}" if i in SET else f"R{i} {{ $..R{i - 1}; }}"
        for i in kinds)
    pairs = "\n".join(
        f"p{i} {{ kinds (R{i} ligand); law Dembo; k0on {RATE}; k0off 1e-15; lambda {REST};"
        f" s {STIFFNESS}; sts {STIFFNESS}; roughness {STALKS}; }}" for i in kinds)
    return HEADER.format("effects") + f"""
bonds
{{
    temperature {TEMPERATURE:g};
    seed 1;
    molecules
    {{
        block {{ {receptors} }}
        bottomWall {{ ligand {{ density {LIGANDS:g}; }} }}
    }}
    pairs {{ {pairs} }}
}}
"""


def bodies():
    return HEADER.format("bodies") + f"""
block
{{
    type        rigidBody;
    shape       {{ type surfaceFile; file "constant/block.stl"; }}
    position    (20 {GAP + HEIGHT / 2:g} 20);
    overdamped  true;
    constraints {{ velocity (0 0 0); angularVelocity (0 0 0); }}
}}
"""


def study():
    def entries(word):
        return "(" + " ".join(f'"constant/effects:bonds/molecules/block/R{i}/{word}"'
                              for i in SET) + ")"

    quantities = "\n".join(
        f'bond{i} {{ quantity "bonds.p{i}.number:at={AT:g}"; above 0.5; }}'
        for i in range(1, KINDS + 1))
    return HEADER.format("ensembleDict") + f"""
patients {{ table "constant/patients.csv"; entries {{ receptors {entries("density")}; }} }}
drug
{{
    doses (0 10 20 40 80 160 320);
    KD 1;
    blocks {entries("blocked")};
    intravenous {{ volume 10; halfLife 3; }}
}}
protocols {{ once {{ given (0); encounter 3; }} }}
seeds 16;
quantities {{ {quantities} }}
smallest {{ quantity bond1; below 0.5; }}
"""


if __name__ == "__main__":
    stl.write("constant/block.stl", {"block": block()})
    for name, text in (("constant/effects", effects()), ("constant/bodies", bodies()),
                       ("system/ensembleDict", study())):
        with open(name, "w") as file:
            file.write(text)
    with open("constant/patients.csv", "w") as file:
        file.write(f"patient,receptors (1/um2)\nwhole,{DENSITY:g}\nhalf,{DENSITY / 2:g}\n")
