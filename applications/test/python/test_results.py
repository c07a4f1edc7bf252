# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
import pytest

from fsbi import results, table

WITHIN = dict(quantity="omega", value=25.1e-6, reference=25e-6, bound=0.01)


def written(*rows):
    r = results.Results("S6")
    for row in rows:
        r.add(**row)
    r.write()
    return r


def test_results_within_their_bounds_pass(scratch):
    r = written(dict(WITHIN, seconds=41, cells=9),
                dict(quantity="drift_abs", value=3e-5, reference=0, bound=5e-4))
    r.at_least("order", 1.97, 1.95)
    r.write()
    assert results.check() == 0


def test_results_are_read_back(scratch):
    written(WITHIN)
    row, = results.read()
    assert row["case"] == "S6" and float(row["error"]) == pytest.approx(0.004, abs=1e-9)


@pytest.mark.parametrize("value", [25.3e-6, 24.7e-6, float("nan")])
def test_result_beyond_its_bound_fails(scratch, value):
    written(dict(WITHIN, value=value))
    assert results.check() == 1


def test_order_too_low_fails(scratch):
    r = results.Results("S2")
    r.at_least("order", 1.9, 1.95)
    r.write()
    assert results.check() == 1


def test_file_without_rows_fails(scratch):
    written()
    assert results.check() == 1


def test_reference_of_zero_needs_abs():
    with pytest.raises(ValueError, match="_abs"):
        results.Results("S6").add("drift", 1e-5, 0, 1e-4)


def test_variants_of_a_quantity_are_one_line_of_the_table(scratch):
    written(dict(WITHIN, variant="mesh1"), dict(WITHIN, value=25.2e-6, variant="mesh2"))
    line, = table.quantity_lines("./results.csv", "./README.md")
    assert "| omega | 2 | 0.008 | 0.01 |" in line
