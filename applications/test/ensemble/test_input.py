# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be used is refused in one line that says where and what there is."""

import os
import re
import shutil
import subprocess

import pytest

from fsbi.ensemble import sampling
from fsbi.ensemble.dictionary import RESULT_WORDS, WORDS, Description

TEXT = """FoamFile { version 2.0; format ascii; class dictionary; object ensembleDict; }
parameters
{
    ligands
    {
        entry   "constant/effects:bonds/molecules/bottomWall/P-selectin/density";
        values  (100 800);
    }
}
seeds 2;
quantities { bond { quantity "bonds.selectin.formed:sum"; above 0; } }
"""
# what is replaced, by what, what the message has
WRONG = {
    "an unknown keyword": ("seeds 2", "seed 2", "system/ensembleDict: unknown keyword 'seed'"),
    "one in a parameter": ("values  (", "value (", "ligands: unknown keyword 'value'"),
    "one in a quantity": ("above 0", "over 0", "bond: unknown keyword 'over'"),
    "an entry that is none": ("P-selectin/density", "P-selectin/densty",
                              "no 'densty' in bonds/molecules/bottomWall/P-selectin, where d"),
    "a file that is not there": ("constant/effects:", "constant/effect:",
                                 "no dictionary constant/effect"),
    "an entry without a file": ("constant/effects:", "", '"FILE:ENTRY"'),
    "an unknown sampling": ("seeds 2", "sampling all; seeds 2", "grid, list, random"),
    "no samples": ("seeds 2", "sampling random; seeds each", "random needs it"),
    "samples of a grid": ("seeds 2", "samples 4; seeds 2", "'samples' belongs to"),
    "Sobol's samples": ("seeds 2", "sampling Sobol; samples 12; seeds each", "power of two"),
    "no values": ("values  (100 800);", "", "has none of values, range"),
    "values twice": ("(100 800)", "(100 100)", "100 stands there twice"),
    "a list of other lengths": (
        "    }\n}", "    }\n    b { entry \"constant/bodies:leukocyte/shape/size\"; values (1); }\n"
        "}\nsampling list;", "2 of ligands, 1 of b"),
    "a range that falls": ("values  (100 800)", "range (2 1); number 3", "LOW below HIGH"),
    "a range without a number": ("values  (100 800)", "range (1 2)", "'number' is missing"),
    "a distribution in a grid": ("values  (100 800)", "normal (1 2)",
                                 "normal belongs to random, latinHypercube, Sobol"),
    "a number of a distribution": ("above 0", "above much", "'above' is to be a number"),
    "a seed that is none": ("seeds 2", "seeds (1 x)", "whole number"),
    "seeds each in a grid": ("seeds 2", "seeds each", "seeds each belongs to"),
    "a scene without seeds": ("seeds 2", 'seeds 2; seedEntry "constant/effects:bonds/sead"',
                              "no 'sead' in bonds"),
    "no quantities": ("quantities {", "quantity {", "unknown keyword 'quantity'"),
    "an unknown reduction": ("formed:sum", "formed:median", "reduction 'median'"),
    "a half-width of zero": ("above 0", "halfWidth 0", "'halfWidth' is to be above 0"),
    "a name of two columns": ("bond {", "ligands {", "'ligands' names two columns"),
    "a confidence of 95": ("seeds 2", "confidence 95; seeds 2", "below 1"),
    "a form without a place": ("values  (", 'form "(1 2)"; values (', "has no {}"),
    "a bracket that is missing": ("quantities {", "quantities", "system/ensembleDict"),
}


def call(*arguments, **environment):
    return subprocess.run(["fsbiEnsemble", *arguments], capture_output=True, text=True,
                          check=False, env={**os.environ, **environment})


def one_line(done):
    text = done.stderr.strip()
    assert done.returncode == 1 and text.startswith("fsbiEnsemble: ") and "\n" not in text
    return text


@pytest.fixture
def case(tmp_path):
    folder = tmp_path / "case"
    shutil.copytree("case", folder)
    return folder


@pytest.mark.parametrize("old, new, message", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(case, old, new, message):
    assert old in TEXT
    (case / "system/ensembleDict").write_text(TEXT.replace(old, new))
    assert message in one_line(call(str(case)))


@pytest.mark.parametrize("arguments, message", [
    (["nowhere"], "no folder nowhere"), ([], "required: case"), (["case", "--fast"], "--fast"),
    (["case"], "no system/ensembleDict"), (["case", "--jobs", "0"], "--jobs")])
def test_so_on_the_command_line(arguments, message):
    assert message in one_line(call(*arguments))


def test_run_that_is_none(case):
    (case / "system/ensembleDict").write_text(TEXT)
    assert "no run 5 but 1 to 4" in one_line(call(str(case), "--run", "5"))


def test_quantity_that_no_run_has_ends_the_study_with_those_there_are(case):
    (case / "system/ensembleDict").write_text(TEXT.replace("bonds.selectin.f", "bonds.slectin.f"))
    text = one_line(call(str(case)))
    assert "'bonds.slectin.formed:sum'" in text and "effects.bonds.selectin.{number,formed" in text


def test_environment_of_another_folder_does_no_harm(case):
    (case / "system/ensembleDict").write_text(TEXT)
    done = call(str(case), "--list", PWD="/nowhere")
    assert done.returncode == 0 and done.stdout.count("--run") == 4


def test_help_has_all_options():
    done = call("-help")
    assert done.returncode == 0
    assert all(f"\n    {o} " in done.stdout for o in ("--jobs", "--list", "--run"))


MANUAL = os.path.join(os.environ["FSBI_DIR"], "etc/dictionaries/ensembleDict")


def test_manual_is_a_dictionary_that_can_be_used(tmp_path):
    (tmp_path / "system").mkdir()
    shutil.copy(MANUAL, tmp_path / "system")
    about = Description(str(tmp_path))
    assert [p.name for p in about.all_parameters()] == ["blocked", "density", "height", "seed"]
    assert len(sampling.plan("grid", about.parameters, None)) == 3 * 4 * 2


def test_manual_has_every_keyword():
    with open(MANUAL) as file:
        text = file.read()
    words = (*sampling.WORDS, *sampling.SAMPLINGS, *WORDS, *RESULT_WORDS)
    assert [w for w in words if not re.search(rf"\b{w}\b", text)] == []
