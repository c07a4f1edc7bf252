# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/bodies of a collision: two spheres of radii, places and forces
drawn at random, driven together (odd numbers) or both at the wall (even)."""

import sys

import numpy as np

HEADER = """FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      bodies;
}
"""

BODY = """
{name}
{{
    type            rigidBody;
    shape           {{ type sphere; radius {radius:.6g}; size {size:.3g}; }}
    position        {place};
    overdamped      true;
    force           {force};
}}
"""


def drawn(number):
    random = np.random.default_rng(number)
    radii = random.uniform(2.5, 5, 2)
    force = random.uniform(0.1, 1) * radii / radii.mean()
    if number % 2:
        axis = random.normal(size=3)
        axis /= np.linalg.norm(axis)
        apart = radii.sum() + random.uniform(0.8, 2)
        offset = np.cross(axis, random.normal(size=3))
        places = [20 + sign * (axis * apart + 0.3 * offset) / 2 for sign in (-1, 1)]
        forces = [f * axis for f in (force[0], -force[1])]
    else:
        heights = radii + random.uniform(0.8, 2, 2)
        places = [(14, heights[0], 20), (14 + radii.sum() + 0.9, heights[1], 20)]
        forces = [(0.5 * f * random.uniform(-1, 1), -f, 0.2 * f) for f in force]
    return radii, places, forces


def entry(vector):
    return "(" + " ".join(f"{c:.6g}" for c in vector) + ")"


def main(number):
    radii, places, forces = drawn(int(number))
    with open("constant/bodies", "w") as file:
        file.write(HEADER)
        for name, radius, place, force in zip("ab", radii, places, forces):
            file.write(BODY.format(name=name, radius=radius, size=0.25 * radius,
                                   place=entry(place), force=entry(force)))


if __name__ == "__main__":
    main(sys.argv[1])
