# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""system/blockMeshDict of an array of round posts between a floor and a ceiling, 20 um
from post to post and as high: the cell that repeats itself, from -10 to 10 in y and z,
around a post of radius 4 at the origin.

    python3 post_array.py BEGIN         of the cell in x, in which it is 20 long
"""

import sys

RADIUS, HALF = 4, 10
CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
MIDDLES = ((0, -1), (1, 0), (0, 1), (-1, 0))

HEADER = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      blockMeshDict;
}

scale   1;
"""
BLOCKS = """
blocks
(
    hex (0 1 5 4 8 9 13 12) (12 4 8) simpleGrading (1 1 1)
    hex (1 2 6 5 9 10 14 13) (12 4 8) simpleGrading (1 1 1)
    hex (2 3 7 6 10 11 15 14) (12 4 8) simpleGrading (1 1 1)
    hex (3 0 4 7 11 8 12 15) (12 4 8) simpleGrading (1 1 1)
);
"""
PATCHES = """
boundary
(
    left    { type cyclic; neighbourPatch right; faces ((0 8 11 3)); }
    right   { type cyclic; neighbourPatch left; faces ((1 2 10 9)); }
    front   { type cyclic; neighbourPatch back; faces ((0 1 9 8)); }
    back    { type cyclic; neighbourPatch front; faces ((3 11 10 2)); }
    floor   { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }
    ceiling { type wall; faces ((8 9 13 12) (9 10 14 13) (10 11 15 14) (11 8 12 15)); }
    post    { type wall; faces ((4 5 13 12) (5 6 14 13) (6 7 15 14) (7 4 12 15)); }
);
"""


def main(begin):
    on_post = RADIUS / 2**0.5
    points = [(begin + HALF * (1 + i), HALF * j, z) for z in (-HALF, HALF) for i, j in CORNERS]
    post = [(on_post * i, on_post * j, z) for z in (-HALF, HALF) for i, j in CORNERS]
    vertices = points[:4] + post[:4] + points[4:] + post[4:]
    arcs = [f"    arc {level + 4 + k} {level + 4 + (k + 1) % 4} "
            f"({RADIUS * i} {RADIUS * j} {z})"
            for level, z in ((0, -HALF), (8, HALF)) for k, (i, j) in enumerate(MIDDLES)]
    with open("system/blockMeshDict", "w") as file:
        print(HEADER, "vertices", "(", sep="\n", file=file)
        print(*(f"    ({a:.12g} {b:.12g} {c:.12g})" for a, b, c in vertices), ");",
              sep="\n", file=file)
        print(BLOCKS, "edges", "(", *arcs, ");", PATCHES, sep="\n", file=file)


if __name__ == "__main__":
    main(float(sys.argv[1]))
