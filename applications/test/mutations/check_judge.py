# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge itself: a program that does on demand what is to be found."""

import os
import shutil
import subprocess
import sys

import h5py
import numpy as np

import judge
import program
from mutate import Mutation, misspelt, of_text

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.abspath("runs/doctored")

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

failed = 0


def check(what, good):
    global failed
    failed += not good
    print("ok - " if good else "NOT OK - ", what, sep="")


def doctored():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(f"{FOLDER}/base/constant")
    with open(f"{FOLDER}/base/constant/bodies", "w") as file:
        file.write("same\n")
    subprocess.run(["gcc", "-O1", "-o", f"{FOLDER}/doctored", f"{HERE}/doctored.c"], check=True)
    program.build()
    program.SILENCE, program.BLOCKED, program.MEMORY = 1, 2, 2e5
    judge.Judge.programs = {"fsbiFoam": program.Program(f"{FOLDER}/doctored")}
    return judge.Judge(f"{FOLDER}/base", f"{FOLDER}/case")


def check_verdicts():
    court = doctored()
    for (wish, kind), verdict in EXPECTED.items():
        path = () if kind == "CRLF" else ("body", "entry")
        found = court.judge(Mutation("none", "constant/bodies", path, kind, wish.encode()))
        check(f"a program made to {wish}, {kind}, is judged {verdict}"
              + ("" if found.verdict == verdict else f": {found.verdict} {found.why}"),
              found.verdict == verdict)


def check_history():
    """Two steps count, the cost does not."""
    def tables(name, rows, seconds=1.0):
        with h5py.File(f"{FOLDER}/{name}", "w") as file:
            file["bodies/cell/velocity"] = np.array(rows)
            file["cost/seconds"] = seconds
        return judge.history(f"{FOLDER}/{name}")

    first = tables("a.h5", [0., 1, 2, 3])
    check("histories that differ after two steps are the same",
          tables("b.h5", [0., 1, 2, 4], 2.0) == first)
    check("histories that differ in the second step are not",
          tables("c.h5", [0., 1, 2 + 1e-15 * 4, 3]) != first)


def check_mutations():
    text = "FoamFile { object a; }\nbody { radius 4; /* um; */ list (a { b (1 -2); }); }\n"
    made = {(".".join(m.path), m.kind): m.content for m in of_text("none", "a", text)}
    for entry, kind, must in (
            ("body.radius", "negated", "radius -4;"), ("body.radius", "misspelt", "radus 4;"),
            ("body.list.a.b", "1e300", "b (1e300 1e300);"),
            ("body.list.a.b", "negated", "b (-1 2);"), ("body", "emptied", "body {}\n"),
            ("body.list.a", "deleted", "list (); }"),
            ("body", "comment not closed", "/* body"), ("", "BOM", "\ufeffFoam")):
        content = made[entry, kind].decode()
        check(f"mutated: {entry or 'file'} {kind}", must in content)
    check("a misspelt word is another", misspelt("E") == "Ex" and misspelt("size") == "sie")


def main():
    check_verdicts()
    check_history()
    check_mutations()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
