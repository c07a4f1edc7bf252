# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fsbiAccuracyCost predicts and chooses, without a run."""

import os

import h5py
import numpy as np
import pytest

from fsbi.accuracy_cost import parameters
from fsbi.accuracy_cost.predict import Predictor
from fsbi.accuracy_cost.study import front
from fsbi.studies import Refused, quantities

METHODS = parameters.Parameter("method", ["coupled", "SIMPLEC"], None, 0)
BASE = dict(mesh="1", timeStep="1", tolerance="1", method="coupled")


def cost(settings):
    """Seconds of stepping and meshing, megabytes, as of a real run: with a
    start, and a solver whose iterations depend on the tolerance."""
    f, dt, tol = (float(settings[k]) for k in ("mesh", "timeStep", "tolerance"))
    cells = 18000 / f**2.8
    its = (15 - 1.5 * np.log10(tol)) * dt**0.15
    slow = 6 if settings["method"] == "SIMPLEC" else 1
    return (0.2 + 100 / dt * cells**1.15 * its * 2e-7 * slow, 5e-5 * cells * 8,
            150 + 0.006 * cells)


@pytest.fixture
def trained():
    """A predictor after a plan of runs, and its predictions on the way over the
    true seconds."""
    varied = [parameters.Factor(n) for n in parameters.BUILT_IN] + [METHODS]
    plan = [BASE] + [{**BASE, k.name: v} for k in varied[:3] for v in k.values if v != "1"]
    predictor, ratios = Predictor(varied), []
    assert predictor.predict(BASE) is None
    for settings in sorted(plan, key=lambda s: sum(cost(s)[:2])):
        found = predictor.predict(settings)
        if found:
            ratios.append(found[0] / sum(cost(settings)[:2]))
        predictor.add(settings, *cost(settings))
    return predictor, np.array(ratios)


def test_9_of_10_predictions_are_within_a_factor_of_one_and_a_half(trained):
    ratios = trained[1]
    assert len(ratios) == 9
    assert np.mean((1 / 1.5 < ratios) & (ratios < 1.5)) >= 0.9


def test_so_is_a_combination(trained):
    combined = dict(BASE, mesh="1.4", timeStep="2", tolerance="100")
    assert 1 / 1.5 < trained[0].predict(combined)[0] / sum(cost(combined)[:2]) < 1.5


def test_word_never_tried_is_known_to_be_a_guess(trained):
    assert trained[0].predict(dict(BASE, method="SIMPLEC"))[2] > 0.6


def test_best_of_many_are_those_that_none_beats_in_both():
    runs = [(1, 0.1), (2, 0.2), (3, 0.05), (4, 0.05), (5, 0.01), (3, 0.04)]
    assert front(runs, lambda r: r[0], lambda r: r[1]) == [(1, 0.1), (3, 0.04), (5, 0.01)]


@pytest.mark.parametrize("how, window, wanted", [
    ("last", (), 2), ("max", (), 2), ("sum", (), 4), ("mean", (), 5 / 3), ("at=0.5", ([0.5],), 1),
    ("mean=1,3", ([1, 3],), 2)])
def test_series_is_reduced(how, window, wanted):
    t, v = np.array([0.0, 1, 3]), np.array([0.0, 2, 2])
    assert quantities.reduce(t, v, how, *window) == pytest.approx(wanted)


@pytest.mark.parametrize("how, wanted", [("sum", 0), ("first", np.nan), ("mean", np.nan)])
def test_table_without_rows_has_a_sum_of_none_and_nothing_else(how, wanted):
    none = np.zeros(0)
    assert quantities.reduce(none, none, how) == pytest.approx(wanted, nan_ok=True)


@pytest.fixture
def two_bodies(scratch):
    """The velocities of a-b and of c."""
    os.makedirs("postProcessing")
    with h5py.File("postProcessing/history.h5", "w") as file:
        for name, rows in (("a-b", [[0, 1, 2, 3], [1, 4, 5, 6]]),
                           ("c", [[0, 1, 0, 0], [1, 1, 1, 2]])):
            table = file.create_dataset(f"bodies/{name}/velocity", data=np.array(rows, float))
            table.attrs["columns"] = ["time", "x", "y", "z"]
            table.attrs["units"] = ["L/T"]


@pytest.mark.parametrize("path, wanted", [
    ("bodies.a-b-c.U.x:max", 3), ("bodies.c-a-b.U.y", -4), ("bodies.a-b-c.U.mag:last", 41**0.5),
    ("bodies.a-b-c.velocity.mag:first", 13**0.5), ("bodies.a-b.U.x:sum", 5)])
def test_difference_of_two_bodies(two_bodies, path, wanted):
    assert quantities.Quantity(path).value(".") == pytest.approx(wanted)


def test_body_that_is_none_has_no_difference(two_bodies):
    with pytest.raises(Refused):
        quantities.Quantity("bodies.a-b-d.U.x").value(".")
