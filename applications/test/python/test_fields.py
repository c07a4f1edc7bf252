# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later

import numpy as np
import pytest

from fsbi import fields


def test_value_between_points_is_that_of_a_quadratic_function():
    points = np.random.default_rng(1).uniform(0, 1, (200, 3))

    def function(p):
        return np.array([1 + p[..., 0] * p[..., 1] - p[..., 2]**2,
                         p[..., 0]**2 + 3 * p[..., 1]]).T

    place = np.array([0.9, 0.5, 0.1])
    assert fields.at(points, function(points), place) == pytest.approx(
        function(place), abs=1e-10)
