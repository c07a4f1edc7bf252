# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two patients, two protocols, three doses, as a user calls it: on one core and two,
killed and continued; what the runs get, what comes out."""

import csv
import glob
import math
import os
import signal
import subprocess
import time

import pytest
from binding import PATIENTS, TEXT, call, new

RUNS = 2 * 2 * 3 * 3


def rows(name, table="table"):
    with open(f"{name}/ensemble/{table}.csv", newline="") as file:
        return list(csv.DictReader(file))


def raw(name):
    found = {}
    for table in ("table", "summary", "smallest"):
        with open(f"{name}/ensemble/{table}.csv", "rb") as file:
            found[table] = file.read()
    return found


@pytest.fixture(scope="module")
def one():
    return call(new("one"))


def test_every_run_has_its_patients_receptors_and_the_part_that_the_drug_takes(one):
    assert one.returncode == 0, one.stderr
    found = rows("one")
    assert len(found) == RUNS
    units = dict(once=0.04, twice=0.14)     # from the table, by hand
    for row in found:
        c = float(row["dose"]) * units[row["protocol"]]
        # bound: six digits are written
        assert float(row["part"]) == pytest.approx(c / (c + 0.5), rel=2e-6)
        assert float(row["part"]) == pytest.approx(float(row["blocked"]), rel=1e-9)
        assert float(row["density"]) == dict(A=3, B=1.5)[row["patient"]]


def test_patients_have_dose_curves_and_smallest_doses(one):
    summary, smallest = rows("one", "summary"), rows("one", "smallest")
    assert len(summary) == 3 * RUNS / 3
    assert [(r["patient"], r["protocol"]) for r in smallest] == [
        (p, t) for p in "AB" for t in ("once", "twice")]
    assert all(float(r["low"]) <= float(r["dose"]) <= float(r["high"]) for r in smallest)
    assert "patient B, protocol twice: smallest dose for a probability of bond below 0.4" \
        in one.stdout
    assert os.path.getsize("one/ensemble/ensemble.png") > 5000


def test_two_cores_make_the_same_tables(one):
    assert call(new("two"), "--jobs", "2").returncode == 0
    assert raw("two") == raw("one")


def test_killed_it_goes_on_to_the_same_tables(one):
    new("killed")
    process = subprocess.Popen(["fsbiEnsemble", "killed"], stdout=subprocess.DEVNULL)
    begin = time.monotonic()
    while len(glob.glob("killed/ensemble/runs/*/run.json")) < 5 \
            and process.poll() is None and time.monotonic() - begin < 60:
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    kept = len(glob.glob("killed/ensemble/runs/*/run.json"))
    last = call("killed")
    assert 5 <= kept < RUNS and f"{kept} of {RUNS} runs are kept" in last.stdout
    assert raw("killed") == raw("one")


def test_frequent_enough_is_the_other_side_of_rare_enough(one):
    """Of the contrary, with the same runs."""
    with open("killed/system/ensembleDict", "w") as file:
        none = "none { quantity errors.bond; below 0.5; } bond {"
        file.write(TEXT.replace("bond        {", none)
                   .replace("quantity bond; below 0.4", "quantity none; above 0.6"))
    done = call("killed")
    assert done.returncode == 0 and "took" not in done.stdout
    assert [[r[w] for w in ("dose", "low", "high")] for r in rows("killed", "smallest")] == [
        [r[w] for w in ("dose", "low", "high")] for r in rows("one", "smallest")]


def test_more_patients_and_doses_run_only_what_is_new(one):
    new_text = TEXT.replace("(0 10 40)", "(0 10 40 80)")
    with open("two/system/ensembleDict", "w") as file:
        file.write(new_text)
    with open("two/constant/patients.csv", "w") as file:
        file.write(PATIENTS + "C,2,1,\n")
    lines = call("two", "--list").stdout.splitlines()
    assert len(lines) == 3 * 2 * 4 * 3 - RUNS


def test_with_many_seeds_the_dose_is_that_of_the_law(tmp_path):
    """P = 1 - exp(-3 phi) = 0.4, phi = 1/(1 + dose 0.04/0.5)."""
    text = TEXT.replace("    twice       { given (0 4); encounter 6; }\n", "") \
        .replace("seeds           3", "seeds 40").replace("(0 10 40)", "(0 40 160)")
    case = new(tmp_path / "case", text, PATIENTS.partition("B,")[0])
    done = call(case, "--jobs", "2")
    assert done.returncode == 0, done.stderr
    (row,) = rows(case, "smallest")
    truth = (3 / -math.log(0.6) - 1) * 0.5 / 0.04
    assert float(row["low"]) <= truth <= float(row["high"])     # bound: the interval's


def test_patients_alone_and_a_drug_alone(tmp_path):
    start, drug = TEXT.index("drug"), TEXT.index("seeds")
    alone = TEXT[:start] + TEXT[drug:TEXT.index("smallest")]
    assert call(new(tmp_path / "a", alone)).returncode == 0
    assert [r["patient"] for r in rows(tmp_path / "a")] == ["A", "B"] * 3
    done = call(new(tmp_path / "b", TEXT[:TEXT.index("patients")] + TEXT[start:]))
    assert done.returncode == 0, done.stderr
    assert len(rows(tmp_path / "b")) == 2 * 3 * 3


def test_smallest_of_a_plain_parameter(tmp_path):
    text = TEXT[:TEXT.index("patients")] + """
parameters { part { entry "system/controlDict:blocked"; values (0 0.5 0.9); } }
""" + TEXT[TEXT.index("seeds"):].replace("part        {", "other {") \
        .replace("below 0.4", "parameter part; below 0.5")
    done = call(new(tmp_path / "case", text))
    assert done.returncode == 0, done.stderr
    (row,) = rows(tmp_path / "case", "smallest")
    assert 0 <= float(row["part"]) and "smallest part for a probability" in done.stdout
