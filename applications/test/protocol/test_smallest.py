# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The smallest dose from counts: drawn studies whose dose is known, the regression
against its other definition, ends that are open; the concentration against equations of
motion."""

import math

import numpy as np
import pytest
from binding import TEXT, new
from scipy import integrate

from fsbi.ensemble import smallest
from fsbi.ensemble.dictionary import Description

FULL = 3.0                              # -ln(1 - P) without a drug
PHI = 1 / (1 + np.array([0, 0.5, 1, 2, 4, 8, 16]))      # free at C/K_D
STUDIES = 600


def drawn(random, n, law):
    return (random.random((len(PHI), n)) < law(PHI)[:, None]).sum(axis=1)


def first(phi):
    """One bond is enough."""
    return 1 - np.exp(-FULL * phi)


def third(phi):
    """Three are needed, of a Poisson number: no law that the interpolation knows."""
    x = 2.5 * FULL * phi
    return 1 - np.exp(-x) * (1 + x + x * x / 2)


@pytest.mark.parametrize("law", [first, third])
@pytest.mark.parametrize("n, wanted", [(16, 0.5), (16, 0.2), (64, 0.3)])
def test_interval_has_the_known_place_as_often_as_it_says(law, n, wanted):
    fine = np.linspace(PHI[-1], 1, 100001)
    truth = np.interp(wanted, law(fine), fine)
    random = np.random.default_rng(1)
    inside = []
    for _ in range(STUDIES):
        _, low, high = smallest.smallest(PHI, drawn(random, n, law), [n] * len(PHI), wanted)
        inside.append((low is None or low >= truth) and (high is None or high <= truth))
    # bound: 95 %, but three standard deviations of so many studies
    assert np.mean(inside) >= 0.95 - 3 * math.sqrt(0.95 * 0.05 / STUDIES)


def test_estimate_comes_to_the_known_place():
    n, wanted = 4000, 0.4
    truth = -math.log(1 - wanted) / FULL
    random = np.random.default_rng(2)
    found = [smallest.smallest(PHI, drawn(random, n, first), [n] * len(PHI), wanted).value
             for _ in range(20)]
    # bound: three standard errors of the mean, by what n trials tell of P
    error = math.sqrt(wanted * (1 - wanted) / n) / (FULL * (1 - wanted)) / math.sqrt(len(found))
    assert abs(np.mean(found) - truth) < 3 * error


def test_exact_counts_of_a_first_bond_give_the_exact_place():
    n = 10**9
    found = smallest.smallest(PHI, first(PHI) * n, [n] * len(PHI), 0.37)
    # bound: of rounding, the law is that of the interpolation
    assert found.value == pytest.approx(-math.log(1 - 0.37) / FULL, rel=1e-9)


def test_regression_is_that_of_its_other_definition():
    """Of the means of all blocks around a point."""
    random = np.random.default_rng(3)
    for _ in range(50):
        n = random.integers(1, 20, size=7)
        h = random.binomial(n, 0.5)
        found = smallest.isotonic(h, n)
        wanted = [min(max(h[s:t + 1].sum() / n[s:t + 1].sum() for t in range(i, 7))
                      for s in range(i + 1)) for i in range(7)]
        assert found == pytest.approx(wanted, abs=1e-12)        # bound: rounding


def test_bands_fall_also_with_unlike_numbers_of_runs():
    low, high = smallest.bands([0.9, 0.9, 0.5, 0.5], [8, 40, 6, 60], 0.95)
    assert all(np.diff(low) <= 0) and all(np.diff(high) <= 0)


def test_ends_that_no_dose_reaches_are_open():
    none = smallest.smallest([1, 0.5], [16, 16], [16, 16], 0.5)
    assert none == (None, None, None)
    assert smallest.smallest([1, 0.5], [0, 0], [16, 16], 0.5) == (1, 1, 1)
    assert smallest.smallest([1, 0.5], [1, 0], [1, 1], 0.5).value < 1       # not where all have it
    few = smallest.smallest([1, 0.5], [3, 1], [4, 4], 0.5)
    assert few.low == 1 and 0.5 < few.value < 1 and few.high is None


@pytest.mark.parametrize("kind, absorption", [("intravenous", None), ("oral", 0.7), ("oral", 3.0)])
def test_concentration_is_that_of_the_equations_of_motion(tmp_path, kind, absorption):
    """Doses at 0 and 4, an encounter at 6; from the gut, if it is given by mouth."""
    constants = "volume 12; halfLife 3;" + (
        f" absorptionHalfLife {absorption}; bioavailability 0.8;" if absorption else "")
    text = TEXT.replace('plasma      "constant/plasma.csv";', f"{kind} {{ {constants} }}")
    about = Description(new(tmp_path / "case", text))
    k = math.log(2) / 3
    a = math.log(2) / absorption if absorption else 0

    def change(_, amounts):
        gut, plasma = amounts
        return [-a * gut, a * gut - k * plasma]

    dose = np.array([0.8 * 40, 0]) if absorption else np.array([0, 40])
    until = integrate.solve_ivp(change, (0, 4), dose, rtol=1e-10, atol=1e-12).y[:, -1]
    after = integrate.solve_ivp(change, (0, 2), until + dose, rtol=1e-10, atol=1e-12).y[:, -1]
    found = about.complete(dict(patient="A", protocol="twice", dose="40"))
    # bound: six digits are written
    assert float(found["concentration"]) == pytest.approx(after[1] / 12, rel=1e-5)
    c = after[1] / 12
    assert float(found["blocked"]) == pytest.approx(c / (c + 0.5), rel=1e-5)


def test_table_is_linear_between_its_times_and_doses_add_up(tmp_path):
    about = Description(new(tmp_path / "case"))
    found = about.complete(dict(patient="B", protocol="twice", dose="10"))
    # 6 after the first: between 0.06 at 4 and 0.02 at 8; 2 after the second
    assert float(found["concentration"]) == pytest.approx(10 * (0.04 + 0.1), rel=1e-9)


def test_constants_may_be_those_of_a_patient(tmp_path):
    about = Description(new(tmp_path / "case", TEXT.replace("KD          0.5", "KD KD")))
    part = {p: float(about.complete(dict(patient=p, protocol="once", dose="10"))["blocked"])
            for p in "AB"}
    # bound: six digits; 0.4 in the plasma
    assert part == pytest.approx(dict(A=0.4 / 0.9, B=0.4 / 2.4), rel=1e-5)
