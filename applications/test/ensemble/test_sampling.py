# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which values a dictionary means, and which go together."""

import numpy as np
import pytest

from fsbi.ensemble import sampling
from fsbi.ensemble.dictionary import Seed
from fsbi.studies.dictionary import Dictionary


def parameter(kind="grid", **words):
    return sampling.Parameter("a", Dictionary("a", {"entry": "f:e", **words}), kind)


def drawn(u, **words):
    return float(parameter("random", **words).at(u))


def test_range_is_divided_evenly():
    assert parameter(range=["1", "3"], number="3").listed() == ["1", "2", "3"]


def test_or_in_its_logarithm():
    p = parameter(range=["1", "100"], number="3", spacing="logarithmic")
    assert p.listed() == ["1", "10", "100"]


@pytest.mark.parametrize("u, wanted, words", [
    (0.25, 1.5, dict(range=["1", "3"])),
    (0.5, 10, dict(range=["1", "100"], spacing="logarithmic")),
    (0.975, 10 + 2 * 1.959964, dict(normal=["10", "2"])),
    (0.975, 10 * np.exp(0.2 * 1.959964), dict(logNormal=["10", "0.2"])),
    (0.5, 10, dict(logNormal=["10", "0.2"]))])
def test_quantiles_of_what_is_drawn_are_those_of_its_distribution(u, wanted, words):
    assert drawn(u, **words) == pytest.approx(wanted, rel=1e-6)


def test_values_drawn_are_equally_likely():
    p = parameter("random", values=["a", "b", "c"])
    found = [p.at(u) for u in (np.arange(300) + 0.5) / 300]
    assert [found.count(v) for v in "abc"] == [100] * 3 and p.at(1.0) == "c"


def test_value_stands_in_its_form_in_every_entry():
    p = parameter(entry=["f:e", "g:h"], form="(20.5 {} 21)", values=["1", "2"])
    assert p.key("2") == [["f", "e", "(20.5 2 21)"], ["g", "h", "(20.5 2 21)"]]


def test_grid_has_all_combinations_and_a_list_pairs():
    two = parameter(values=["1", "2"]), parameter(values=["x", "y"])
    assert sampling.plan("grid", two, None) == [["1", "x"], ["1", "y"], ["2", "x"], ["2", "y"]]
    assert sampling.plan("list", two, None) == [["1", "x"], ["2", "y"]]


def test_latin_hypercube_has_one_sample_in_every_slice():
    points = sampling.points("latinHypercube", 3, 40)
    assert (np.sort(np.floor(40 * points), axis=0) == np.arange(40)[:, None]).all()


@pytest.mark.parametrize("kind", sampling.DRAWN)
def test_same_dictionary_is_the_same_plan(kind):
    p = [parameter(kind, range=["1", "3"]), Seed(("f", "seed"))]
    assert sampling.plan(kind, p, 8) == sampling.plan(kind, p, 8)


def test_seeds_drawn_are_all_different_and_those_of_a_sample_go_along():
    p = [parameter("Sobol", range=["1", "3"]), Seed(("f", "seed"))]
    rows = np.array(sampling.plan("Sobol", p, 16)).reshape(16, 4, 2)
    a, b, first, last = (rows[:, i] for i in range(4))
    assert len({*a[:, 1], *b[:, 1]}) == 32
    assert (first[:, 0] == b[:, 0]).all() and (first[:, 1] == a[:, 1]).all()
    assert (last[:, 0] == a[:, 0]).all() and (last[:, 1] == b[:, 1]).all()
