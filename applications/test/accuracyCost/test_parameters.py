# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the parameters do to a case: that of the Allrun, with some more entries."""

import shutil

import pytest

from fsbi.accuracy_cost import parameters
from fsbi.studies import Refused
from fsbi.studies.entries import Entries

STEP = "system/controlDict:deltaT"
OPTIMISE = "system/remeshDict:optimise"


@pytest.fixture
def scaled(tmp_path):
    folder = tmp_path / "scaled"
    shutil.copytree("case", folder)
    entries = Entries(str(folder))
    entries.set("system/remeshDict", "farSize", "10")
    blocks = folder / "system/blockMeshDict"
    text = blocks.read_text()
    blocks.write_text(text.replace("(8 8 8)", "(8 $n 1)").replace("scale ", "n 12;\nscale "))
    return entries, blocks


def test_mesh_2_doubles_sizes_and_growth_and_halves_blocks_and_cells_per_gap(scaled):
    entries, blocks = scaled
    parameters.Factor("mesh", [2]).apply(entries, "2")
    assert entries.number("constant/bodies", "tumourCell/shape/size") == 4.8
    assert [entries.number("system/remeshDict", e)
            for e in ("growth", "farSize", "cellsPerGap")] == [1.2, 20, 1.5]
    assert entries.number("system/blockMeshDict", "n") == 6
    # also numbers in the blocks, down to one
    assert "(4 $n 1)" in blocks.read_text()


def test_size_that_is_not_given_is_the_defaults_double(scaled):
    entries = scaled[0]
    entries.set("constant/bodies", "tumourCell/shape", "{ type sphere; radius 8; }")
    parameters.Factor("mesh", [2]).apply(entries, "2")
    assert entries.number("constant/bodies", "tumourCell/shape/size") == 3.2


def made(*words, **options):
    return parameters.make([list(words)], Entries("case", **options))[0]


def test_case_as_it_is_is_one_of_a_parameters_values():
    parameter = made("dt", STEP, "6400", "3200", "1600")
    assert parameter.values[parameter.base] == "1600" and parameter.size("6400") == 4


def test_or_is_put_among_them():
    assert made("dt", STEP, "6400", "3200").values == ["6400", "3200", "1600"]


def test_numbers_that_rise_are_counts():
    given = Entries("case", [("system/remeshDict", "optimise", "1")])
    sizes = parameters.make([["n", OPTIMISE, "1", "2", "4"]], given)[0].sizes
    assert sizes[-1] / sizes[0] < 0.5


@pytest.mark.parametrize("words", [
    "mesh x", "mesh -1", "dt", "dt nowhere:a 1 2", f"dt {STEP} 1 3 2", f"dt {STEP} 1 1",
    f"n {OPTIMISE} 1 2"])
def test_wrong_parameter_is_refused_in_one_line(words):
    with pytest.raises(Refused) as refused:
        made(*words.split())
    assert "\n" not in str(refused.value)
