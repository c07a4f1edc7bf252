# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Force on a sphere that moves towards a plane, over 6 pi mu a U, exactly.

H. Brenner, Chem. Engng Sci. 16 (1961) 242: `wall` (no slip) and `mirror` (no shear:
half of two equal spheres that approach each other). a: radius; gap: in radii.
"""

import numpy as np


def terms(gap):
    alpha = np.arccosh(1 + gap)
    n = np.arange(1, 40 + int(60 / alpha))
    # beyond 300 the brackets are below 1e-200
    n = n[(2 * n + 1) * alpha < 300]
    return alpha, n, n * (n + 1) / ((2 * n - 1) * (2 * n + 3))


def wall(gap):
    alpha, n, factor = terms(gap)
    k = 2 * n + 1
    bracket = (2 * np.sinh(k * alpha) + k * np.sinh(2 * alpha)) \
        / (4 * np.sinh(k * alpha / 2)**2 - (k * np.sinh(alpha))**2) - 1
    return 4 / 3 * np.sinh(alpha) * np.sum(factor * bracket)


def mirror(gap):
    """gap: from the mirror, half of that between the spheres."""
    alpha, n, factor = terms(gap)
    k = 2 * n + 1
    bracket = (4 * np.cosh(k * alpha / 2)**2 + (k * np.sinh(alpha))**2) \
        / (2 * np.sinh(k * alpha) - k * np.sinh(2 * alpha)) - 1
    return 4 / 3 * np.sinh(alpha) * np.sum(factor * bracket)
