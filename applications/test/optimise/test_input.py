# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be used is refused in one line that says where and what there is."""

import os
import re
import shutil

import pytest
from hill import CONTROL, TEXT, call, new

from fsbi.optimise import dictionary

# what is replaced, by what, what the message has
WRONG = {
    "an unknown keyword": ("tolerance ", "tolerence ",
                           "system/optimiseDict: unknown keyword 'tolerence'; there are par"),
    "one in a parameter": ("range (0 1)", "rang (0 1)", "x: unknown keyword 'rang'"),
    "one in a quantity": ('quantity "errors.sum"', 'what "errors.sum"', "both: unknown keyword"),
    "one in a constraint": ("below 0.8", "under 0.8", "least: unknown keyword 'under'"),
    "no bound": ("below 0.8;", "", "has none of above, below"),
    "an entry that is none": ("controlDict:x", "controlDict:z", "no 'z' in it, where application"),
    "a file that is not there": ("system/controlDict:x", "system/control:x",
                                 "no dictionary system/control "),
    "values, which cannot be searched": ("range (0 1)", "values (0 1)", "only a range"),
    "a range that falls": ("range (0 1)", "range (1 0)", "LOW below HIGH"),
    "a logarithmic range with a zero": ("range (0 1)", "range (0 1); spacing logarithmic",
                                        "above zero"),
    "no goal": ('maximise    "height";', "", "has none of maximise, minimise"),
    "two goals": ("runs ", 'minimise "both"; runs ', "has several of maximise, minimise"),
    "a formula of an unknown name": ('"height"', '"hight"', "'hight', which is not known; "
                                     "there are the names x, y, height, both"),
    "a formula that is none": ('formula "both"', 'formula "both +"', "formula 'both +' is none"),
    "few runs": ("45", "6", "6 runs are too few: with 2 parameters and 1 seeds at least 7"),
    "a tolerance of one": ("0.002", "1", "'tolerance', of every range, is below 0.1"),
    "a name twice": ("both    {", "x {", "'x' names two columns"),
    "a name that is none in a formula": ("both    {", "both-of-them {", "cannot stand in a"),
    "a seed that is none": ("runs ", "seeds (1 x); runs ", "whole number"),
    "seeds each": ("runs ", "seeds each; runs ", "a point has a number of seeds"),
    "a half-width": ('"errors.sum"', '"errors.sum"; halfWidth 1', "belongs to fsbiEnsemble"),
}


def one_line(done):
    text = done.stderr.strip()
    assert done.returncode == 1 and text.startswith("fsbiOptimise: ") and "\n" not in text
    return text


@pytest.mark.parametrize("old, new_text, message", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(tmp_path, old, new_text, message):
    assert old in TEXT
    case = new(tmp_path / "case", TEXT.replace(old, new_text))
    assert message in one_line(call(case))
    assert not os.path.isdir(os.path.join(case, "optimise"))


@pytest.mark.parametrize("arguments, message", [
    (["nowhere"], "no folder nowhere"), ([], "required: case"), ([".", "--fast"], "--fast"),
    (["."], "no system/optimiseDict"), ([".", "--jobs", "0"], "--jobs")])
def test_so_on_the_command_line(arguments, message):
    assert message in one_line(call(*arguments))


def test_quantity_that_no_run_has(tmp_path):
    case = new(tmp_path / "case", TEXT.replace("errors.sum", "errors.some"))
    assert "'errors.some'" in one_line(call(case))


def test_case_that_always_fails_says_why(tmp_path):
    case = new(tmp_path / "case", TEXT.replace("range (0 1)", "range (1 2)"), CONTROL)
    assert "first 10 points failed" in (text := one_line(call(case)))
    assert "x is too large" in text


def test_help_has_all_options():
    done = call("-help")
    assert done.returncode == 0 and "\n    --jobs " in done.stdout


MANUAL = os.path.join(os.environ["FSBI_DIR"], "etc/dictionaries/optimiseDict")


def test_manual_is_a_dictionary_that_can_be_used(tmp_path):
    (tmp_path / "system").mkdir()
    shutil.copy(MANUAL, tmp_path / "system")
    about = dictionary.Description(str(tmp_path))
    assert [p.name for p in about.all_parameters()] == ["pitch", "filament", "seed"]


def test_manual_has_every_keyword():
    with open(MANUAL) as file:
        text = file.read()
    words = (*dictionary.WORDS, *dictionary.CONSTRAINT_WORDS)
    assert [w for w in words if not re.search(rf"\b{w}\b", text)] == []
