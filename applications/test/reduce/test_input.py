# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fsbiReduce cannot use is refused in one line that says where and what there is."""

import os
import shutil
import subprocess

import pytest

HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object x; }\n"
TEXT = HEADER + """wall { point (0 0 0); normal (0 1 0); }
gaps { range (1 4); number 5; }
"""
BODY = HEADER + """a { type rigidBody; shape { type sphere; radius 4; } overdamped true;
position (20 6 20); }
"""
SOURCE = os.path.join(os.environ["FSBI_DIR"], "validation/S13-approach/case")

# of which file, what is replaced, by what, what the message has
DICT, BODIES = "system/reduceDict", "constant/bodies"
WRONG = {
    "an unknown keyword": (DICT, "gaps", "gabs", "unknown keyword 'gabs'; there are wall"),
    "one in the wall": (DICT, "normal", "normel", "unknown keyword 'normel'"),
    "one in the gaps": (DICT, "number", "numbers", "unknown keyword 'numbers'"),
    "no wall": (DICT, "wall { point (0 0 0); normal (0 1 0); }", "", "'wall' is to be a sub"),
    "a normal of length zero": (DICT, "(0 1 0)", "(0 0 0)", "'normal' is a direction"),
    "a point of two numbers": (DICT, "(0 0 0)", "(0 0)", "to be three numbers"),
    "a range that falls": (DICT, "(1 4)", "(4 1)", "LOW above zero and below HIGH"),
    "a gap of zero": (DICT, "(1 4)", "(0 4)", "LOW above zero"),
    "few gaps": (DICT, "5", "4", "'number' is to be 5 or more, not 4"),
    "angles of a sphere": (DICT, "gaps", "angles 5; gaps", "'angles' is for ellipsoids"),
    "an ellipsoid without angles": (BODIES, "type sphere; radius 4;",
                                    "type ellipsoid; semiAxes (5 3 3);", "'angles' is missing"),
    "three semi-axes": (BODIES, "type sphere; radius 4;",
                        "type ellipsoid; semiAxes (5 4 3);", "ellipsoid of revolution"),
    "another shape": (BODIES, "type sphere; radius 4;", "type helix; radius 1;",
                      "rigidBody of shape helix; a table is of a rigidBody, sphere"),
    "two bodies": (BODIES, "a {", "b { type rigidBody; } a {", "has 2 bodies"),
}


def new(folder, changed=None):
    case = os.path.join(str(folder), "case")
    shutil.copytree(SOURCE, case)
    for name, text in ((DICT, TEXT), (BODIES, BODY)):
        if changed and changed[0] == name:
            assert changed[1] in text
            text = text.replace(changed[1], changed[2], 1)
        with open(os.path.join(case, name), "w") as file:
            file.write(text)
    return case


def refused(*arguments):
    done = subprocess.run(["fsbiReduce", *arguments], capture_output=True, text=True)
    text = done.stderr.strip()
    assert done.returncode == 1 and text.startswith("fsbiReduce: ") and "\n" not in text
    return text


@pytest.mark.parametrize("changed", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(tmp_path, changed):
    case = new(tmp_path, changed)
    assert changed[3] in refused(case)
    assert not os.path.isdir(os.path.join(case, "reduce"))


@pytest.mark.parametrize("arguments, message", [
    (["nowhere"], "no folder nowhere"), ([], "required: case"), ([".", "--fast"], "--fast"),
    ([".", "--jobs", "0"], "--jobs")])
def test_the_command_line(arguments, message):
    assert message in refused(*arguments)


def test_help():
    done = subprocess.run(["fsbiReduce", "-help"], capture_output=True, text=True)
    assert done.returncode == 0 and "method reduced" in done.stdout
