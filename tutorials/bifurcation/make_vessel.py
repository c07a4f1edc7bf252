# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A round vessel that parts into two, as an STL file with the solids wall, inlet,
upper and lower. Axes lie in the plane z = 0 and meet in the origin.

Between each two branches runs half a pipe, from the top line of the one, round
the corner, to the end of the other; in the plane of the axes the corner is rounded off,
most of all halfway down. The three halves meet in the branches' top and bottom
lines only."""

import sys

import numpy as np

from fsbi import stl

RADIUS = 6.0            # um, where the branches meet
ROUNDED = 5.0           # um, that a corner takes of a wall halfway down
BRANCHES = {            # direction of the axis, its length, radius at the end
    "inlet": ((-1, 0), 26.0, 6.0),
    "lower": ((np.sqrt(0.5), -np.sqrt(0.5)), 34.0, 4.2),
    "upper": ((np.sqrt(0.5), np.sqrt(0.5)), 34.0, 5.2),
}
AROUND, ALONG, CORNER = 32, 24, 12      # steps of half a pipe


def taper(name, s):
    """Radius of a branch over that in the middle, at a place on its axis."""
    _, length, end = BRANCHES[name]
    t = np.clip((s - 10) / (length - 20), 0, 1)
    return 1 + (end / RADIUS - 1) * t * t * (3 - 2 * t)


def leg(name, offset, corner, start):
    """Places along a wall of a branch, from the corner to the end, and how much
    narrower the branch is there."""
    axis, length, _ = BRANCHES[name]
    s0 = corner @ axis
    s = np.linspace(start + s0, length, ALONG + 1)
    normal = corner - s0 * np.array(axis)
    normal /= np.linalg.norm(normal) + 1e-300
    scale = taper(name, s)
    return np.outer(s, axis) + np.outer(offset * scale, normal), scale


def half_pipe(a, b):
    """Points, ring by ring, from the end of branch a to that of branch b."""
    middle = np.add(BRANCHES[a][0], BRANCHES[b][0])
    middle /= np.linalg.norm(middle)
    sine = np.sqrt(1 - (middle @ BRANCHES[a][0])**2)
    lines = []
    for angle in np.linspace(0, np.pi, AROUND + 1):
        offset, z = RADIUS * np.sin(angle), RADIUS * np.cos(angle)
        corner = middle * offset / sine
        start = ROUNDED * np.sin(angle)
        first, narrow_a = leg(a, offset, corner, start)
        last, narrow_b = leg(b, offset, corner, start)
        t = np.linspace(0, 1, CORNER + 1)[1:-1, None]
        bend = (1 - t)**2 * first[0] + 2 * t * (1 - t) * corner + t**2 * last[0]
        plane = np.vstack([first[::-1], bend, last])
        heights = np.concatenate([narrow_a[::-1], np.ones(len(bend)), narrow_b]) * z
        lines.append(np.column_stack([plane, heights]))
    return np.array(lines).transpose(1, 0, 2)


def between(rings):
    """Two triangles for every quadrilateral between rings."""
    a, b = rings[:-1, :-1], rings[1:, :-1]
    c, d = rings[1:, 1:], rings[:-1, 1:]
    both = np.concatenate([np.stack([a, b, c], -2), np.stack([a, c, d], -2)])
    triangles = both.reshape(-1, 3, 3)
    edges = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2)
    return triangles[edges.min(axis=1) > 1e-6]


def lid(name, left, right):
    """The end of a branch, between its two walls from top to bottom."""
    axis, length, _ = BRANCHES[name]
    centre = np.array([*np.multiply(axis, length), 0])
    ring = np.concatenate([left, right[::-1][1:]])
    return np.stack([np.broadcast_to(centre, ring[1:].shape), ring[:-1], ring[1:]], 1)


def halves():
    names = list(BRANCHES)
    return {(a, b): half_pipe(a, b) for a, b in zip(names, names[1:] + names[:1])}


def outline():
    """The walls in the plane of the axes, line by line."""
    return [rings[:, AROUND // 2, :2] for rings in halves().values()]


def resistance(name):
    """Of a branch to the flow, over 8 mu/pi, as if it were straight."""
    s = np.linspace(0, BRANCHES[name][1], 1000)
    return np.trapz((RADIUS * taper(name, s))**-4.0, s)


def main():
    pipes = halves()
    names = list(BRANCHES)
    solids = {"vessel": np.concatenate([between(rings) for rings in pipes.values()])}
    for i, name in enumerate(names):
        to_next = pipes[name, names[(i + 1) % 3]][0]
        from_last = pipes[names[i - 1], name][-1]
        solids[name] = lid(name, to_next, from_last)
    stl.write(sys.argv[1], solids)


if __name__ == "__main__":
    main()
