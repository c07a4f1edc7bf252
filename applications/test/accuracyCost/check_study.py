# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""fsbiAccuracyCost as a user calls it, on a tiny case: a study that is stopped and
goes on, with a variant that fails; input that cannot be used."""

import csv
import glob
import json
import os
import signal
import subprocess
import time

from checks import check, end

TOOL = os.path.join(os.environ["FSBI_DIR"],
                    "applications/utilities/fsbiAccuracyCost/fsbiAccuracyCost")
OMEGA = "rotation=bodies.tumourCell.omega.y:rms=2.5e-5"
STUDY = ["case", "--quantity", OMEGA, "--reference", "0", "--scale", "2.5e-5",
         "--knob", "mesh", "1.5", "1.2", "--knob", "tolerance", "100",
         "--knob", "method", "system/fluid/fvSolution:coupling/method", "coupled", "nonsense"]


def call(*arguments):
    return subprocess.run(["/usr/bin/python3", "-B", TOOL, *arguments],
                          capture_output=True, text=True)


def kept():
    return sorted(glob.glob("case/accuracyCost/runs/*/run.json"))


def check_bad_input():
    q = ["--quantity", OMEGA, "--reference", "0", "--scale", "1"]
    wrong = {
        "no case": ["nowhere", *q], "no quantity": ["case"],
        "a path of one word": ["case", "--quantity", "omega"],
        "an unknown reduction": ["case", "--quantity", "bodies.a.U.x:median"],
        "a reference of zero without scale": ["case", "--quantity", OMEGA, "--reference", "0"],
        "more references than quantities": ["case", *q, "--reference", "1"],
        "an unknown knob": ["case", *q, "--knob", "colour", "red"],
        "a knob of a file that is not there": ["case", *q, "--knob", "a", "system/no:a", "1", "2"],
        "an entry that is none": ["case", *q, "--set", "deltaT=3"],
        "an accuracy of zero": ["case", *q, "--accuracy", "0"],
        "an unknown option": ["case", *q, "--fast"],
        "no such application": ["case", *q, "--application", "noFoam"],
    }
    for name, arguments in wrong.items():
        done = call(*arguments)
        text = done.stderr.strip()
        check(f"{name}: one line says so", done.returncode == 1 and text.count("\n") == 0
              and text.startswith("fsbiAccuracyCost: "), text[-300:])


def check_stopped():
    """Ctrl-C while the second variant runs."""
    process = subprocess.Popen(["/usr/bin/python3", "-B", TOOL, *STUDY], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    begin = time.monotonic()
    while not kept() and process.poll() is None and time.monotonic() - begin < 300:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    text = process.communicate()[0]
    check("a study stops at Ctrl-C and says how to go on", process.returncode == 130
          and "the same command goes on" in text, text[-300:])
    return len(kept())


def check_goes_on(before):
    stamps = {path: os.path.getmtime(path) for path in kept()}
    done = call(*STUDY)
    check("it goes on with what is kept", done.returncode == 0
          and f"{before} of 5 variants are kept from before" in done.stdout, done.stdout[-500:])
    check("without running that again",
          stamps and all(os.path.getmtime(p) == t for p, t in stamps.items()))
    check("a variant that fails is reported with the reason, and ends nothing",
          "method nonsense" in done.stdout and "; failed: fsbiFoam stopped" in done.stdout)
    with open("case/accuracyCost/variants.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    good = [r for r in rows if r["seconds"]]
    check("all variants are in the table", len(rows) == 5 and len(good) == 4)
    check("with seconds, memory and cells", all(
        float(r["seconds"]) > 0 and float(r["megabytes"]) > 50 and int(r["cells"]) > 500
        for r in good))
    cells = {r["variant"]: int(r["cells"]) for r in good}
    check("the mesh knob has changed the mesh", cells["mesh 1.5"] < 0.6 * cells["as it is"],
          cells)
    for name in ("accuracyCost.png", "report.md"):
        check(f"{name} is made", os.path.getsize(f"case/accuracyCost/{name}") > 500)


def check_other_quantity():
    """What was run answers other questions, too."""
    count = len(kept())
    done = call("case", "--quantity", "cells=cost.cells:max", "--quantity",
                "regions.fluid.U.max", "--knob", "mesh", "1.5", "1.2")
    check("another quantity of what is kept needs no run", done.returncode == 0
          and "3 of 3 variants are kept" in done.stdout and len(kept()) == count,
          done.stdout[-300:] + done.stderr[-300:])
    done = call("case", "--quantity", "bodies.tumourCell.colour.x", "--knob", "mesh", "1.5",
                "1.2")
    check("a quantity that is not there: those that are", done.returncode == 1
          and "bodies.tumourCell.position.{x,y,z}" in done.stderr
          and done.stderr.strip().count("\n") == 0, done.stderr[-300:])


def check_torn():
    """A run that was killed while it was kept, and a case that was changed."""
    for path in kept():
        os.rename(path, path.replace("run.json", "run.part"))
    done = call(*STUDY[:7], "--knob", "mesh", "1.5")
    check("what is not wholly kept is run again", "kept from before" not in done.stdout
          and len(kept()) == 2, done.stdout[-300:])
    with open("case/system/remeshDict", "a") as file:
        file.write("\nminSize 0.5;\n")
    done = call(*STUDY[:7], "--knob", "mesh", "1.5", "--jobs", "2")
    check("so is all of a case that was changed", "kept from before" not in done.stdout
          and len(kept()) == 4, done.stdout[-300:])
    contended = [json.load(open(p))["contended"] for p in kept()]
    check("runs beside each other are marked", sum(contended) >= 2, contended)


check_bad_input()
check_goes_on(check_stopped())
check_other_quantity()
check_torn()
end()
