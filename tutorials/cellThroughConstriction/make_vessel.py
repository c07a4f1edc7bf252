# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A round channel along x with a throat, as an STL file with the solids channel, inlet
and outlet."""

import sys

import numpy as np

from fsbi import stl

HALF = 18.0             # um, length of the channel to both sides
RADIUS, THROAT = 5.5, 3.0
STRAIGHT, END = 2.0, 8.0    # |x| up to which the throat reaches, where it opens fully
AROUND, ALONG = 60, 120


def radius(x):
    t = np.clip((np.abs(x) - STRAIGHT) / (END - STRAIGHT), 0, 1)
    return THROAT + (RADIUS - THROAT) * 0.5 * (1 - np.cos(np.pi * t))


def resistance():
    """Pressure by flow over the viscosity, as if it were straight everywhere [1/um3]."""
    x = np.linspace(-HALF, HALF, 2000)
    return np.trapz(8 / (np.pi * radius(x)**4), x)


def main():
    x = np.linspace(-HALF, HALF, ALONG + 1)
    angle = np.linspace(0, 2 * np.pi, AROUND + 1)
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    circle[-1] = circle[0]
    rings = np.array([np.column_stack([np.full(AROUND + 1, s), radius(s) * circle])
                      for s in x])
    a, b, c, d = rings[:-1, :-1], rings[1:, :-1], rings[1:, 1:], rings[:-1, 1:]
    solids = {"channel": np.concatenate([np.stack([a, b, c], -2), np.stack([a, c, d], -2)])
              .reshape(-1, 3, 3)}
    for name, ring in (("inlet", rings[0]), ("outlet", rings[-1])):
        centre = np.broadcast_to([ring[0, 0], 0, 0], ring[1:].shape)
        solids[name] = np.stack([centre, ring[:-1], ring[1:]], 1)
    stl.write(sys.argv[1], solids)


if __name__ == "__main__":
    main()
