# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Splines through samples of a resistance, and what is left out of them.

Functions of gap and angle, 18 of them: logarithms of the diagonal of R, its other
entries over the root of both diagonals, loads of a flow along t and of one along s; in
the axes of frames.py. Cubic splines of the logarithm of the gap (not-a-knot) and of the
angle, continued by symmetry: f(-angle) = +-f(angle) by a half turn about the normal, and
f(angle + pi) = f(angle), as an axis has no head.

Error: every sample inside is left out once and found from the others. Largest
difference of R, entry by entry over the root of both diagonals, and of velocities that
the flow gives a free body over the largest at that gap. Between samples as they are
the splines are better: their spacing is half of that.
"""

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from .frames import ACROSS, ALONG, OFF_DIAGONAL, PARITY, axes, into

DEGREE = 3
FEWEST_LEFT = 3     # angles: with fewer none can be left out
SIGNS = np.array([1] * 6 + [PARITY[i] * PARITY[j] for i, j in OFF_DIAGONAL]
                 + [PARITY[i] * PARITY[1] for i in ALONG]
                 + [PARITY[i] * PARITY[2] for i in ACROSS])


def functions(R, along, across):
    """Of R and loads in the axes n, t, s."""
    R = (R + R.T) / 2
    root = np.sqrt(np.diag(R))
    return np.array([*2 * np.log(root), *(R[i, j] / (root[i] * root[j]) for i, j in OFF_DIAGONAL),
                     *along[list(ALONG)], *across[list(ACROSS)]])


def matrices(f):
    """R and the loads of flows along t and s."""
    R = np.diag(np.exp(f[:6]))
    for value, (i, j) in zip(f[6:12], OFF_DIAGONAL):
        R[i, j] = R[j, i] = value * np.sqrt(R[i, i] * R[j, j])
    along, across = np.zeros(6), np.zeros(6)
    along[list(ALONG)], across[list(ACROSS)] = f[12:15], f[15:]
    return R, along, across


def _turned(R, load):
    """A quarter turn about n: what a body that is upright does not notice."""
    Q = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]], float)
    return into(R, Q), into(load, Q)


def grid(study):
    """functions at every gap and angle."""
    about, found = study.about, {}
    for s in study.samples:
        Q = axes(about.normal, s.lean)
        if s.angle == 0:
            Q = axes(about.normal, study.flow)
        key = (s.gap, s.angle)
        found.setdefault(key, []).append((into(s.R, Q), into(s.flow, Q)))
    values = np.empty((len(about.gaps), len(about.angles), len(SIGNS)))
    for i, gap in enumerate(about.gaps):
        for j, angle in enumerate(about.angles):
            rows = found[gap, angle]
            if angle == 0:
                # the same from all sides: the mean of it and of it turned by a quarter
                R, load = rows[0]
                turned, across = _turned(R, load)
                values[i, j] = functions((R + turned) / 2, load, across)
            else:
                # across: the flow goes along -s
                (R, load), (other, across) = rows
                values[i, j] = functions((R + other) / 2, load, -across)
    if len(about.angles) > 1:
        odd = SIGNS < 0
        values[:, 0, odd] = values[:, -1, odd] = 0
    return values


class Surrogate:
    """Of samples: gapKnots, angleKnots, coefficients, error."""

    def __init__(self, study):
        self.about = study.about
        self.values = grid(study)
        self.gapKnots, inGaps = self._gaps(self.about.gaps, self.values)
        self.angleKnots, self.coefficients = self._angles(self.about.angles, inGaps)
        self.errors = {"gaps": self._left_out_gaps()}
        if len(self.about.angles) > FEWEST_LEFT:
            self.errors["angles"] = self._left_out_angles()
        self.error = max(self.errors.values())

    def _gaps(self, gaps, values):
        spline = make_interp_spline(np.log(gaps), values, k=DEGREE, axis=0)
        return spline.t, spline.c

    def _angles(self, angles, values):
        """Along axis 1. A sphere: a function of degree 0."""
        if len(angles) == 1:
            return np.array([0, np.pi / 2]), values
        every = np.concatenate((-angles[:0:-1], angles))
        mirrored = np.concatenate((SIGNS * values[:, :0:-1], values), axis=1)
        spline = make_interp_spline(every, np.moveaxis(mirrored, 1, 0), k=DEGREE,
                                    bc_type="periodic")
        return spline.t, np.moveaxis(spline.c, 0, 1)

    def _difference(self, found, true):
        """Of functions."""
        (A, *loads), (R, *exact) = matrices(found), matrices(true)
        root = np.sqrt(np.diag(R))
        flows = [np.linalg.solve(R, np.array(f)) for f in exact]
        missed = [np.linalg.solve(A, np.array(f)) - u for f, u in zip(loads, flows)]
        length = np.array([1] * 3 + [self.about.body.across] * 3)
        scale = max(np.linalg.norm(length * u) for u in flows)
        ofFlow = max(np.linalg.norm(length * u) for u in missed) / scale if scale > 0 else 0
        return max(np.abs((A - R) / np.outer(root, root)).max(), ofFlow)

    def _left_out_gaps(self):
        gaps, worst = self.about.gaps, 0
        for i in range(1, len(gaps) - 1):
            knots, c = self._gaps(np.delete(gaps, i), np.delete(self.values, i, axis=0))
            found = _at(knots, c, np.log(gaps[i]))
            worst = max([worst] + [self._difference(f, v)
                                   for f, v in zip(found, self.values[i])])
        return worst

    def _left_out_angles(self):
        angles, worst = self.about.angles, 0
        for j in range(1, len(angles) - 1):
            knots, c = self._angles(np.delete(angles, j), np.delete(self.values, j, axis=1))
            found = _at(knots, np.moveaxis(c, 1, 0), angles[j])
            worst = max([worst] + [self._difference(f, v)
                                   for f, v in zip(found, self.values[:, j])])
        return worst


def _at(knots, c, x):
    return BSpline(knots, c, DEGREE)(x)
