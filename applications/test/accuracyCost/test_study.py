# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""fsbiAccuracyCost as a user calls it, on a tiny case: a study that is stopped and
goes on, with a variant that fails; input that cannot be used. In this order."""

import csv
import glob
import json
import os
import signal
import subprocess
import time
from collections import namedtuple

import pytest

TOOL = os.path.join(os.environ["FSBI_DIR"],
                    "applications/utilities/fsbiAccuracyCost/fsbiAccuracyCost")
OMEGA = "rotation=bodies.tumourCell.omega.y:rms=2.5e-5"
STUDY = ["case", "--quantity", OMEGA, "--reference", "0", "--scale", "2.5e-5",
         "--parameter", "mesh", "1.5", "1.2", "--parameter", "tolerance", "100",
         "--parameter", "method", "system/fluid/fvSolution:coupling/method", "coupled", "nonsense"]
Q = ["--quantity", OMEGA, "--reference", "0", "--scale", "1"]
WRONG = {
    "no case": ["nowhere", *Q],
    "no quantity": ["case"],
    "a path of one word": ["case", "--quantity", "omega"],
    "an unknown reduction": ["case", "--quantity", "bodies.a.U.x:median"],
    "a reference of zero without scale": ["case", "--quantity", OMEGA, "--reference", "0"],
    "more references than quantities": ["case", *Q, "--reference", "1"],
    "an unknown parameter": ["case", *Q, "--parameter", "colour", "red"],
    "a parameter of a file that is not there":
        ["case", *Q, "--parameter", "a", "system/no:a", "1", "2"],
    "an entry that is none": ["case", *Q, "--set", "deltaT=3"],
    "an accuracy of zero": ["case", *Q, "--accuracy", "0"],
    "an unknown option": ["case", *Q, "--fast"],
    "no such application": ["case", *Q, "--application", "noFoam"],
}


def call(*arguments):
    return subprocess.run(["/usr/bin/python3", "-B", TOOL, *arguments],
                          capture_output=True, text=True, check=False)


def kept():
    return sorted(glob.glob("case/accuracyCost/runs/*/run.json"))


@pytest.mark.parametrize("arguments", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(arguments):
    done = call(*arguments)
    assert done.returncode == 1
    text = done.stderr.strip()
    assert text.startswith("fsbiAccuracyCost: ") and "\n" not in text


Stopped = namedtuple("Stopped", "code text kept")


@pytest.fixture(scope="module")
def stopped():
    """By Ctrl-C while the second variant runs."""
    process = subprocess.Popen(["/usr/bin/python3", "-B", TOOL, *STUDY], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    begin = time.monotonic()
    while not kept() and process.poll() is None and time.monotonic() - begin < 300:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    text = process.communicate()[0]
    return Stopped(process.returncode, text, {path: os.path.getmtime(path) for path in kept()})


@pytest.fixture(scope="module")
def done(stopped):
    """The same command again."""
    return call(*STUDY)


@pytest.fixture(scope="module")
def rows(done):
    with open("case/accuracyCost/variants.csv", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def good(rows):
    return {row["variant"]: row for row in rows if row["seconds"]}


def test_study_stops_at_ctrl_c_and_says_how_to_go_on(stopped):
    assert stopped.code == 130 and "the same command goes on" in stopped.text


def test_it_goes_on_with_what_is_kept(stopped, done):
    assert done.returncode == 0
    assert f"{len(stopped.kept)} of 5 variants are kept from before" in done.stdout


def test_without_running_that_again(stopped, done):
    assert stopped.kept
    assert all(os.path.getmtime(path) == stamp for path, stamp in stopped.kept.items())


def test_variant_that_fails_is_reported_with_the_reason_and_ends_nothing(done):
    assert "method nonsense" in done.stdout and "; failed: fsbiFoam stopped" in done.stdout


def test_all_variants_are_in_the_table(rows, good):
    assert len(rows) == 5 and len(good) == 4


def test_with_seconds_and_memory_and_cells(good):
    for row in good.values():
        assert float(row["seconds"]) > 0 and float(row["megabytes"]) > 50
        assert int(row["cells"]) > 500


def test_mesh_parameter_has_changed_the_mesh(good):
    # bound: cells go with the size to the power -2.8, 0.32 for 1.5
    assert int(good["mesh 1.5"]["cells"]) < 0.6 * int(good["as it is"]["cells"])


@pytest.mark.parametrize("name", ["accuracyCost.png", "report.md"])
def test_file_is_made(done, name):
    assert os.path.getsize(f"case/accuracyCost/{name}") > 500


def test_another_quantity_of_what_is_kept_needs_no_run(done):
    before = kept()
    again = call("case", "--quantity", "cells=cost.cells:max", "--quantity",
                 "regions.fluid.U.max", "--parameter", "mesh", "1.5", "1.2")
    assert again.returncode == 0 and "3 of 3 variants are kept" in again.stdout
    assert kept() == before


def test_quantity_that_is_not_there_gives_those_that_are(done):
    again = call("case", "--quantity", "bodies.tumourCell.colour.x", "--parameter", "mesh", "1.5",
                 "1.2")
    assert again.returncode == 1 and "\n" not in again.stderr.strip()
    assert "bodies.tumourCell.position.{x,y,z}" in again.stderr


def test_what_is_not_wholly_kept_is_run_again(done):
    for path in kept():
        os.rename(path, path.replace("run.json", "run.part"))
    again = call(*STUDY[:7], "--parameter", "mesh", "1.5")
    assert "kept from before" not in again.stdout and len(kept()) == 2


def test_so_is_all_of_a_case_that_was_changed(done):
    with open("case/system/remeshDict", "a") as file:
        file.write("\nminSize 0.5;\n")
    again = call(*STUDY[:7], "--parameter", "mesh", "1.5", "--jobs", "2")
    assert "kept from before" not in again.stdout and len(kept()) == 4


def test_runs_beside_each_other_are_marked():
    assert sum(json.load(open(path))["contended"] for path in kept()) >= 2
