# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pytest
from PIL import Image

from fsbi import pictures, plots

SMALL = 150_000                 # bytes


def test_convergence_is_drawn_with_its_order(scratch):
    h = np.array([4.0, 2.0, 1.0])
    orders = plots.convergence("order.png", h, {"u": 0.01 * h**2})
    # bound: rounding
    assert orders["u"] == pytest.approx(2, abs=1e-12)
    assert 0 < (scratch / "order.png").stat().st_size < SMALL


def test_curves_are_drawn(scratch):
    t = np.linspace(0, 60, 300)
    plots.curves("curve.png", [("computed", t, np.sin(t))],
                 theory=[("theory", t, np.sin(t))], xlabel="time (µs)", title="sine")
    assert 0 < (scratch / "curve.png").stat().st_size < SMALL


def test_picture_of_many_colours_becomes_a_small_file(scratch):
    random = np.random.default_rng(1)
    figure, axes = plots.plt.subplots()
    axes.imshow(random.uniform(size=(400, 400, 3)))
    pictures.save(figure, "folder/noise.png", limit=1000)
    with Image.open("folder/noise.png") as image:
        assert image.mode == "P" and not plots.plt.get_fignums()
