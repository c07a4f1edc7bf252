# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge itself: a program that does on demand what is to be found."""

import os
import subprocess

import h5py
import numpy as np
import pytest

import judge
import program
from mutate import Mutation, misspelt, of_text

HERE = os.path.dirname(os.path.abspath(__file__))

# what it does, kind of the mutation: the verdict that must be found
EXPECTED = {
    ("crash", "zeroed"): "crash",
    ("crashLater", "zeroed"): "crash",
    ("trace", "zeroed"): "crash",
    ("compute", "zeroed"): "hang",
    ("wait", "zeroed"): "hang",
    ("memory", "zeroed"): "memory",
    ("refuse", "zeroed"): "refused",
    ("refuseLater", "zeroed"): "dryRunMissed",
    ("refuseVaguely", "zeroed"): "unclear",
    ("refuseTwice", "zeroed"): "unclear",
    ("tell", "zeroed"): "told",
    ("writeDry", "zeroed"): "dryRunWrote",
    ("differ", "zeroed"): "different",
    ("differ", "misspelt"): "swallowed",
    ("same", "zeroed"): "silent",
    ("same", "CRLF"): "legitimate",
}


@pytest.fixture(scope="module")
def court(tmp_path_factory):
    """A judge of the program doctored.c."""
    folder = tmp_path_factory.mktemp("doctored")
    (folder / "base/constant").mkdir(parents=True)
    (folder / "base/constant/bodies").write_text("same\n")
    subprocess.run(["gcc", "-O1", "-o", folder / "doctored", f"{HERE}/doctored.c"], check=True)
    program.build()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(program, "SILENCE", 1)
        patch.setattr(program, "BLOCKED", 2)
        patch.setattr(program, "MEMORY", 2e5)
        patch.setattr(judge.Judge, "programs",
                      {"fsbiFoam": program.Program(str(folder / "doctored"))})
        yield judge.Judge(str(folder / "base"), str(folder / "case"))


@pytest.mark.parametrize("wish, kind", EXPECTED)
def test_program_made_to(court, wish, kind):
    path = () if kind == "CRLF" else ("body", "entry")
    found = court.judge(Mutation("none", "constant/bodies", path, kind, wish.encode()))
    assert found.verdict == EXPECTED[wish, kind], found.why


def tables(path, rows, seconds=1.0):
    with h5py.File(path, "w") as file:
        file["bodies/cell/velocity"] = np.array(rows)
        file["cost/seconds"] = seconds
    return judge.history(str(path))


@pytest.mark.parametrize("rows, same", [
    ([0., 1, 2, 4], True), ([0., 1, 2 + 1e-15 * 4, 3], False)], ids=["after", "in"])
def test_histories_differ_if_they_do_in_two_steps_but_not_by_the_cost(tmp_path, rows, same):
    first = tables(tmp_path / "a.h5", [0., 1, 2, 3])
    assert (tables(tmp_path / "b.h5", rows, 2.0) == first) == same


TEXT = "FoamFile { object a; }\nbody { radius 4; /* um; */ list (a { b (1 -2); }); }\n"


@pytest.mark.parametrize("entry, kind, must", [
    ("body.radius", "negated", "radius -4;"), ("body.radius", "misspelt", "radus 4;"),
    ("body.list.a.b", "1e300", "b (1e300 1e300);"),
    ("body.list.a.b", "negated", "b (-1 2);"), ("body", "emptied", "body {}\n"),
    ("body.list.a", "deleted", "list (); }"),
    ("body", "comment not closed", "/* body"), ("", "BOM", "\ufeffFoam")])
def test_mutated(entry, kind, must):
    made = {(".".join(m.path), m.kind): m.content for m in of_text("none", "a", TEXT)}
    assert must in made[entry, kind].decode()


@pytest.mark.parametrize("word, other", [("E", "Ex"), ("size", "sie")])
def test_misspelt_word_is_another(word, other):
    assert misspelt(word) == other
