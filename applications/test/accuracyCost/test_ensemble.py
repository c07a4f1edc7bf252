# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""fsbiAccuracyCost --ensemble as a user calls it, of a program of chance whose numbers are
known: X on a level is sqrt(r) Z + sqrt(1 - r) Z', Z of the seed alone, Z' of seed and
level, plus the level's error h^2; stopped and continued; refused input."""

import csv
import os
import signal
import subprocess

import numpy as np
import pytest

TOOL = os.path.join(os.environ["FSBI_DIR"],
                    "applications/utilities/fsbiAccuracyCost/fsbiAccuracyCost")
SIZES = ["0.4", "0.2", "0.1"]
SEEDS = 16
HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
PROGRAM = """#!/usr/bin/python3
import os, re, sys, time
import h5py
import numpy as np
sys.path.insert(0, os.path.join(os.environ["FSBI_DIR"], "applications/test/accuracyCost"))
from test_ensemble import value
with open("constant/effects") as file:
    text = file.read()
seed, size, r = (float(re.search(rf"\\b{w} +([0-9.e-]+);", text)[1]) for w in ("seed", "size", "r"))
end = time.process_time() + 0.02 / size
while time.process_time() < end:
    pass
os.makedirs("postProcessing", exist_ok=True)
with h5py.File("postProcessing/history.h5", "w") as file:
    table = file.create_dataset("bodies/a/velocity", data=np.array([[1.0, value(seed, size, r)]]))
    for name, words in (("columns", ["time", "x"]), ("units", ["L/T"])):
        table.attrs[name] = np.array(words, dtype=h5py.string_dtype())
"""


def value(seed, size, r):
    both = np.random.default_rng(int(seed)).standard_normal()
    own = np.random.default_rng([int(seed), int(1000 * size)]).standard_normal()
    return 3 + size**2 + 0.5 * (np.sqrt(r) * both + np.sqrt(1 - r) * own)


def made(r):
    for name, text in (("system/controlDict", "application chanceFoam; startTime 0; endTime 1; "
                        "deltaT 1;"),
                       ("constant/effects", f"bonds {{ seed 1; size 0.4; r {r}; }}")):
        path = os.path.join("chance", name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(HEADER.format(os.path.basename(name)) + text + "\n")
    os.makedirs("chance/bin", exist_ok=True)
    with open("chance/bin/chanceFoam", "w") as file:
        file.write(PROGRAM)
    os.chmod("chance/bin/chanceFoam", 0o755)


def arguments(*more):
    return ["/usr/bin/python3", "-B", TOOL, "chance", "--ensemble", "--quantity",
            "bodies.a.U.x", "--parameter", "step", "constant/effects:bonds/size", *SIZES, *more]


def environment():
    return {**os.environ, "PATH": os.path.abspath("chance/bin") + ":" + os.environ["PATH"]}


def call(*more):
    return subprocess.run(arguments(*more), capture_output=True, text=True, check=False,
                          env=environment())


def rows():
    with open("chance/accuracyCost/ensemble.csv", newline="") as file:
        return list(csv.DictReader(file))


def test_stopped():
    made(0.9999)
    process = subprocess.Popen(arguments("--seeds", str(SEEDS), "--accuracy", "0.01"),
                               stdout=subprocess.PIPE, text=True, env=environment())
    for line in process.stdout:
        if line.startswith("[2/"):
            break
    process.send_signal(signal.SIGTERM)
    text, _ = process.communicate()
    assert process.returncode == 130
    assert "runs are kept, the same command goes on" in text


def test_goes_on_and_recommends_several():
    done = call("--seeds", str(SEEDS), "--accuracy", "0.01", "--jobs", "2")
    assert done.returncode == 0, done.stderr
    assert "runs are kept from before" in done.stdout
    assert "One level, step 0.1 alone," in done.stdout and "times as long" in done.stdout
    assert os.path.getsize("chance/accuracyCost/ensemble.png") > 5000


def test_table():
    """Of the very numbers of the program, so to their seven digits."""
    found = rows()
    x = np.array([[value(s + 1, float(h), 0.9999) for s in range(SEEDS)] for h in SIZES])
    assert [r["level"] for r in found] == SIZES
    assert [float(r["mean"]) for r in found] == pytest.approx(x.mean(axis=1), rel=1e-5)
    assert [float(r["variance"]) for r in found] == pytest.approx(x.var(axis=1, ddof=1), rel=1e-5)
    for i in (1, 2):
        assert float(found[i]["differenceVariance"]) == pytest.approx(
            (x[i] - x[i - 1]).var(ddof=1), rel=1e-4)
        assert float(found[i]["correlation"]) == pytest.approx(
            np.corrcoef(x[i], x[i - 1])[0, 1], rel=1e-5)
    # bound: 4 standard errors beside the exact h^2, as the tool tells them
    for r in found:
        assert abs(float(r["bias"]) + float(r["level"])**2) < 4 * float(r["biasStandardError"])


def test_nothing_in_common_wants_one_level():
    made(0)
    done = call("--seeds", "8", "--accuracy", "0.05", "--reference", "3", "--jobs", "2")
    assert done.returncode == 0, done.stderr
    assert "One level is the cheapest: paths of the same seeds do not correlate" in done.stdout
    assert sum(int(r["seeds"]) > 0 for r in rows()) == 1


WRONG = {
    "few seeds": ["--seeds", "3"],
    "seeds that are none": ["--seeds", "many"],
    "a seed's entry that is not there": ["--seedEntry", "constant/effects:bonds/sead"],
    "a seed's entry that is none": ["--seedEntry", "seed"],
    "two quantities": ["--quantity", "bodies.a.U.y"],
    "verify": ["--verify"],
    "two parameters": ["--parameter", "b", "constant/effects:bonds/r", "1", "2"],
    "words for levels": ["--parameter", "step", "constant/effects:bonds/r", "a", "b", "c"],
}


@pytest.mark.parametrize("wrong", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(wrong):
    done = call(*wrong)
    assert done.returncode == 1
    text = done.stderr.strip()
    assert text.startswith("fsbiAccuracyCost: ") and "\n" not in text


def test_seeds_belong_to_it():
    done = subprocess.run(["/usr/bin/python3", "-B", TOOL, "chance", "--quantity", "bodies.a.U.x",
                           "--seeds", "8"], capture_output=True, text=True, check=False)
    assert "belong to --ensemble" in done.stderr
