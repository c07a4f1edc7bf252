# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulae have the values of arithmetic, and nothing but arithmetic."""

import math

import pytest

from fsbi.studies import Refused
from fsbi.studies.formula import Formula

VALUES = dict(speed=3.0, torque=-4.0)


@pytest.mark.parametrize("text, value", [
    ("speed", 3), ("-speed + 2*torque", -11), ("speed/sqrt(abs(torque))", 1.5),
    ("max(speed, torque)**2", 9), ("log(exp(speed)) - 1e-1", 2.9), ("(speed - 1)*2", 4)])
def test_values(text, value):
    assert Formula(text, list(VALUES))(VALUES) == pytest.approx(value, rel=1e-15)


def test_what_has_no_value_is_nan():
    for text in ("sqrt(torque)", "speed/(speed - 3)", "torque**0.5", "exp(1000*speed)"):
        assert math.isnan(Formula(text, list(VALUES))(VALUES))


@pytest.mark.parametrize("text, message", [
    ("sped", "'sped', which is not known; there are the names speed, torque"),
    ("speed +", "is none"), ("open(speed)", "function"), ("speed.real", "cannot be used"),
    ("'a'", "cannot be used"), ("__import__('os')", "function"), ("speed > 1", "cannot be used"),
    ("[speed]", "cannot be used"), ("(lambda: 1)()", "function")])
def test_nothing_else_can_be_used(text, message):
    with pytest.raises(Refused, match=message.replace("(", r"\(")):
        Formula(text, list(VALUES))
