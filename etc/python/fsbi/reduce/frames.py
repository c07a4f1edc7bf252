# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A body of revolution beside a plane wall: where it stands at a gap and an angle, and
the axes n (the wall's normal), t (along the wall, where the body's axis leans) and
s = n x t, in which mirror symmetry leaves few entries of its resistance. As
src/reduced/reducedTable.H has them."""

import numpy as np

# entries of R beside its diagonal; loads of a flow along t, and of one along s
OFF_DIAGONAL = ((0, 1), (0, 5), (1, 5), (2, 3), (2, 4), (3, 4))
ALONG, ACROSS = (0, 1, 5), (2, 3, 4)
# a half turn about n: the sign of every component of force and torque
PARITY = np.array([1, -1, -1, 1, -1, -1])


class Body:
    """axis: of revolution, in the body's axes; along it and across: semi-axes."""

    def __init__(self, axis, along, across):
        self.axis, self.along, self.across = np.array(axis, float), along, across

    @property
    def sphere(self):
        return self.along == self.across

    def reach(self, angle):
        """From the centre towards the wall."""
        return np.hypot(self.along * np.cos(angle), self.across * np.sin(angle))


def along_wall(normal):
    """Some direction there."""
    other = np.eye(3)[np.argmin(np.abs(normal))]
    return _unit(other - (other @ normal) * normal)


def axes(normal, lean):
    """Columns n, t, s."""
    return np.array([normal, lean, np.cross(normal, lean)]).T


def leaning(normal, lean, angle):
    """The body's axis."""
    return np.cos(angle) * normal + np.sin(angle) * lean


def rotation(axis, to):
    """(axis, angle) that turns one direction into another."""
    axis = axis if axis @ to >= 0 else -axis
    cross = np.cross(axis, to)
    size = np.linalg.norm(cross)
    if size < 1e-12:
        return np.array([1.0, 0, 0]), 0.0
    return cross / size, np.arctan2(size, axis @ to)


def into(matrix, Q):
    """A 6 x 6 matrix, or a vector of 6, in the axes of Q's columns."""
    both = np.kron(np.eye(2), Q)
    return both.T @ matrix @ both if matrix.ndim == 2 else both.T @ matrix


def _unit(v):
    return v / np.linalg.norm(v)
