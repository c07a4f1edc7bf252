# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A study of three densities of selectin and three seeds, as a user calls it: on one
core, on two, stopped and killed and continued, run by run as a cluster does. One
density is none, and its runs fail."""

import csv
import glob
import os
import re
import shutil
import signal
import subprocess
import time

import h5py
import pytest

TEXT = """FoamFile { version 2.0; format ascii; class dictionary; object ensembleDict; }
parameters
{
    ligands
    {
        entry   "constant/effects:bonds/molecules/bottomWall/P-selectin/density";
        values  (100 800 -5);
    }
}
seeds 3;
quantities
{
    formed  { quantity "bonds.selectin.formed:sum"; }
    bond    { quantity "bonds.selectin.formed:sum"; above 0; }
    speed   { quantity "bodies.leukocyte.U.x:mean"; }
}
"""
TEMPLATE = os.path.join(os.environ["FSBI_DIR"], "etc/slurm/ensemble")


def new(name):
    shutil.rmtree(name, ignore_errors=True)
    shutil.copytree("case", name)
    with open(f"{name}/system/ensembleDict", "w") as file:
        file.write(TEXT)
    return name


def call(*arguments):
    return subprocess.run(["fsbiEnsemble", *arguments], capture_output=True, text=True,
                          check=False)


def results(name):
    """The tables as they are, byte by byte."""
    found = {}
    for file in ("table.csv", "summary.csv"):
        with open(f"{name}/ensemble/{file}", "rb") as read:
            found[file] = read.read()
    return found


def kept(name):
    return glob.glob(f"{name}/ensemble/runs/*/run.json")


@pytest.fixture(scope="module")
def one():
    return call(new("one"))


@pytest.fixture(scope="module")
def rows(one):
    with open("one/ensemble/table.csv", newline="") as file:
        return list(csv.DictReader(file))


def ended(name, number, how):
    """A study ended by a signal as soon as so many runs are kept."""
    process = subprocess.Popen(["fsbiEnsemble", name], text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT)
    begin = time.monotonic()
    while len(kept(name)) < number and process.poll() is None and time.monotonic() - begin < 300:
        time.sleep(0.05)
    process.send_signal(how)
    return process, process.communicate()[0]


@pytest.fixture(scope="module")
def killed():
    """Stopped, killed and continued: what the first said, what was kept, the last."""
    new("killed")
    stopped = ended("killed", 1, signal.SIGINT)
    ended("killed", 3, signal.SIGKILL)
    before = {path: os.path.getmtime(path) for path in kept("killed")}
    return stopped, before, call("killed")


def test_table_has_a_row_a_run(one, rows):
    assert one.returncode == 0
    assert [(r["ligands"], r["seed"]) for r in rows] == [
        (ligands, seed) for seed in "123" for ligands in ("100", "800", "-5")]


def test_run_that_fails_is_told_with_the_reason_and_the_rest_goes_on(one, rows):
    assert "3 of 9 runs failed" in one.stdout and "ligands -5, seed 1" in one.stdout
    failed = [r for r in rows if r["failed"]]
    assert [r["ligands"] for r in failed] == ["-5"] * 3
    assert all("density" in r["failed"] and not r["formed"] for r in failed)


def test_seeds_give_other_bonds_and_more_ligands_more(rows):
    # bound: a rate eight times as large, of events that are rare
    formed = {key: [float(r["formed"]) for r in rows if r["ligands"] == key]
              for key in ("100", "800")}
    assert len(set(formed["800"])) > 1 and sum(formed["800"]) > 2 * sum(formed["100"])


def test_runs_are_those_that_the_program_makes_by_itself(rows, tmp_path):
    folder = tmp_path / "alone"
    shutil.copytree("case", folder)
    shutil.copytree(folder / "0.orig", folder / "0")
    for entry, value in (("bonds/seed", "2"),
                         ("bonds/molecules/bottomWall/P-selectin/density", "800")):
        subprocess.run(["foamDictionary", "-disableFunctionEntries", "-entry", entry, "-set",
                        value, folder / "constant/effects"], check=True, capture_output=True)
    for program in ("blockMesh", "fsbiFoam"):
        subprocess.run([program], cwd=folder, check=True, capture_output=True)
    with h5py.File(folder / "postProcessing/history.h5", "r", swmr=True) as history:
        table = history["effects/bonds/selectin"]
        formed = table[:, [c.decode() for c in table.attrs["columns"]].index("formed")].sum()
    (row,) = [r for r in rows if (r["ligands"], r["seed"]) == ("800", "2")]
    assert formed == float(row["formed"]) > 0


def test_summary_has_probabilities_and_means(one):
    with open("one/ensemble/summary.csv", newline="") as file:
        found = {(r["ligands"], r["quantity"]): r for r in csv.DictReader(file)}
    assert len(found) == 9
    assert found["800", "bond"]["what"] == "probability" and found["800", "bond"]["runs"] == "3"
    # Wilson's of 3 of 3: 3/(3 + 1.96^2)
    assert float(found["800", "bond"]["low"]) == pytest.approx(0.4385, abs=5e-5)
    assert found["-5", "speed"]["failed"] == "3" and found["-5", "speed"]["value"] == "nan"


def test_progress_says_what_is_left(one):
    lines = [t for t in one.stdout.splitlines() if re.match(r"\[\d/9\] ", t)]
    assert len(lines) == 9 and sum(t.endswith(" left") for t in lines) == 8


def test_picture_is_made(one):
    assert os.path.getsize("one/ensemble/ensemble.png") > 2000


def test_two_cores_make_the_same_tables(one):
    assert call(new("two"), "--jobs", "2").returncode == 0
    assert results("two") == results("one")


def test_ctrl_c_says_how_to_go_on(killed):
    (process, text), _, _ = killed
    assert process.returncode == 130 and "the same command goes on" in text


def test_what_was_stopped_and_killed_goes_on_to_the_same_tables(one, killed):
    _, before, last = killed
    assert last.returncode == 0 and "9 runs are kept from before" in last.stdout
    assert results("killed") == results("one")
    assert len(before) >= 3
    assert all(os.path.getmtime(path) == stamp for path, stamp in before.items())


def test_list_of_commands_run_as_an_array_of_slurm_does_too(one):
    lines = call(new("array"), "--list").stdout.splitlines()
    assert lines == [f"fsbiEnsemble array --run {i + 1}" for i in range(9)]
    with open("runs.txt", "w") as file:
        file.write("\n".join(lines) + "\n")
    codes = [subprocess.run(["bash", TEMPLATE], capture_output=True, check=False,
                            env={**os.environ, "SLURM_ARRAY_TASK_ID": str(i + 1)}).returncode
             for i in range(9)]
    os.remove("runs.txt")
    assert codes == [0, 0, 1] * 3 and call("array", "--list").stdout == ""
    assert "9 of 9 runs are kept" in call("array").stdout
    assert results("array") == results("one")


def test_more_seeds_run_only_what_is_new_and_another_quantity_nothing(one):
    with open("two/system/ensembleDict", "w") as file:
        file.write(TEXT.replace("seeds 3", "seeds 2").replace("bodies.leukocyte.U.x:mean",
                                                              "bodies.leukocyte.x.x"))
    fewer = call("two")
    assert "6 of 6 runs are kept" in fewer.stdout and "took" not in fewer.stdout
    with open("two/ensemble/table.csv", newline="") as file:
        assert float(next(csv.DictReader(file))["speed"]) > 20      # it moves along x


def test_changed_case_is_run_again(one):
    with open("two/system/remeshDict", "a") as file:
        file.write("\nminSize 0.5;\n")
    assert len(call("two", "--list").stdout.splitlines()) == 6


def child(parent, name):
    """A program that another has started."""
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path) as file:
                pid, program, _, ppid = file.read().split()[:4]
        except OSError:             # it has ended
            continue
        if program == f"({name})" and int(ppid) == parent:
            return int(pid)
    return None


def test_program_ended_from_outside_is_not_a_run_and_not_a_failure_that_is_kept():
    """As by a batch system, whose SIGTERM fsbiFoam takes for a good end."""
    new("killed")
    subprocess.run(["foamDictionary", "-disableFunctionEntries", "-entry", "endTime", "-set",
                    "4000000", "killed/system/controlDict"], check=True, capture_output=True)
    process = subprocess.Popen(["fsbiEnsemble", "killed", "--run", "1"], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    begin = time.monotonic()
    while not (pid := child(process.pid, "fsbiFoam")) and time.monotonic() - begin < 60:
        time.sleep(0.05)
    time.sleep(3)                   # it meshes, and steps for minutes
    os.kill(pid, signal.SIGTERM)
    text = process.communicate()[0]
    assert process.returncode == 1 and "fsbiFoam: Interrupted at" in text
    assert not glob.glob("killed/ensemble/runs/*/*.json")


def test_program_that_fails_is_kept_as_such(one):
    assert len(glob.glob("one/ensemble/runs/*/failed.json")) == 3
