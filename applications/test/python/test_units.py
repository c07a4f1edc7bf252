# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
import pytest

from fsbi.report import units


@pytest.mark.parametrize("columns, text, wanted", [
    ("x y", "M L/T^2", ["M L/T^2"] * 2),
    ("step n s", "T, -, s", ["T", "-", "s"]),
    ("smallest", "L; range if larger", ["L"]),
    ("Bx fx lag I.a n", "B: tesla, f: M L/T^2, lag: rad, I: A",
     ["tesla", "M L/T^2", "rad", "A", "-"])])
def test_units_of_columns(columns, text, wanted):
    assert units.of_columns(columns.split(), text) == wanted


@pytest.mark.parametrize("unit, system, name", [
    ("M L/T^2", "microvascular", "nN"), ("L/T", "SI", "m/s"), ("tesla", "SI", "tesla")])
def test_unit_in_a_system(unit, system, name):
    assert units.named(unit, system) == name
