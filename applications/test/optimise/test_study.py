# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A hill with a constraint, as a user calls it: on one core and two, stopped and killed
and continued, and with chance."""

import csv
import glob
import os
import re
import signal
import subprocess
import time

import pytest
from hill import CONTROL, TEXT, call, new

# along the gradient (2 (x - 0.3), 4 (y - 0.7)) = -l (1, 1), x + y = 0.8
X, Y, HEIGHT = 0.3 - 2 / 15, 0.7 - 1 / 15, -(2 / 15) ** 2 - 2 / 15**2
NOISY = TEXT.replace("runs        45", 'seeds 4; seedEntry "system/controlDict:seed";\nruns 92') \
    .replace("0.002", "0.02")
NOISE = 0.02


def table(name):
    with open(f"{name}/optimise/table.csv", newline="") as file:
        return list(csv.DictReader(file))


def raw(name):
    with open(f"{name}/optimise/table.csv", "rb") as file:
        return file.read()


def kept(name):
    return [path for what in ("run", "failed")
            for path in glob.glob(f"{name}/optimise/runs/*/{what}.json")]


@pytest.fixture(scope="module")
def one():
    return call(new("one"))


@pytest.fixture(scope="module")
def noisy():
    return call(new("noisy", NOISY, CONTROL.replace("noise 0", f"noise {NOISE}")), "--jobs", "2")


def best(rows, sign=1):
    met = [r for r in rows if r["met"] == "yes"]
    return max(met, key=lambda r: sign * float(r["value"]))


def test_optimum_is_found_where_it_is(one):
    assert one.returncode == 0, one.stderr
    row = best(table("one"))
    # bound: ten of the tolerance, 0.002; the height by its slopes there, 0.267
    assert abs(float(row["x"]) - X) < 0.02 and abs(float(row["y"]) - Y) < 0.02
    assert 0 <= HEIGHT - float(row["value"]) < 0.267 * 2 * 0.02
    assert float(row["least"]) <= 0.8
    assert len(table("one")) <= 45


def test_best_is_told_and_its_case_kept(one):
    row = best(table("one"))
    assert f"best of {len(table('one'))} points: x {float(row['x']):.5g}, " in one.stdout
    assert re.search(r"least: 0\.\d+, below 0\.8 met", one.stdout)
    with open("one/optimise/best/system/controlDict") as file:
        assert re.search(rf"^x +{re.escape(row['x'])};", file.read(), re.M)
    assert os.path.isfile("one/optimise/best/postProcessing/errors/0/errors.csv")
    done = subprocess.run(["hillOfTest"], cwd="one/optimise/best", check=False)
    assert done.returncode == 0
    assert os.path.getsize("one/optimise/optimise.png") > 2000


def test_progress_says_what_is_left(one):
    lines = [t for t in one.stdout.splitlines() if re.match(r"\[\d+/45\] x ", t)]
    assert len(lines) == len(table("one")) and "left" in lines[0]


def test_point_that_failed_is_in_the_table_with_its_reason(one):
    failed = [r for r in table("one") if r["failed"]]
    assert all(float(r["x"]) > 0.95 and "x is too large" in r["failed"] for r in failed)
    assert failed and f"{len(failed)} of {len(table('one'))} points failed" in one.stdout


def test_two_cores_make_the_same_table(one):
    assert call(new("two"), "--jobs", "2").returncode == 0
    assert raw("two") == raw("one")


def ended(name, number, how):
    """Ended by a signal as soon as so many runs are kept."""
    process = subprocess.Popen(["fsbiOptimise", name], text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT)
    begin = time.monotonic()
    while len(kept(name)) < number and process.poll() is None and time.monotonic() - begin < 60:
        time.sleep(0.02)
    process.send_signal(how)
    return process.communicate(timeout=60)[0], process.returncode


def test_stopped_and_killed_it_goes_on_to_the_same_table(one):
    new("killed")
    text, code = ended("killed", 4, signal.SIGINT)          # among the first points
    assert code == 130 and "the same command goes on" in text and "Traceback" not in text
    text, code = ended("killed", 16, signal.SIGTERM)        # while COBYLA waits for a run
    assert code == 130 and "runs are kept, the same command" in text and "Traceback" not in text
    assert "Call-back" not in text
    ended("killed", 20, signal.SIGKILL)
    before = {path: os.path.getmtime(path) for path in kept("killed")}
    done = call("killed")
    assert done.returncode == 0 and f"{len(before)} runs are kept from before" in done.stdout
    assert 20 <= len(before) < len(table("one"))
    assert all(os.path.getmtime(path) == stamp for path, stamp in before.items())
    assert raw("killed") == raw("one")


def test_nothing_is_run_again_and_another_goal_begins_with_what_is_there(one):
    assert "took" not in call("one").stdout
    with open("two/system/optimiseDict", "w") as file:
        file.write(TEXT.replace('maximise    "height"', 'minimise "(x - 0.2)**2 - height"'))
    done = call("two")
    kept_before = int(re.search(r"(\d+) runs are kept from before", done.stdout)[1])
    assert kept_before >= 10 and "took" in done.stdout
    row = best(table("two"), -1)
    # x: (x - 0.2) + (x - 0.3) - 2 (0.1 - x) = 0 along x + y = 0.8, so 4 x = 0.7
    # bound: ten of the tolerance
    assert abs(float(row["x"]) - 0.175) < 0.02


def test_chance_common_to_all_points_does_not_hide_the_optimum(noisy):
    assert noisy.returncode == 0, noisy.stderr
    row = best(table("noisy"))
    # bound: what is left of the noise in a difference of two points, three standard
    # deviations, is a loss that the search cannot see
    loss = 3 * 0.2 * NOISE * (2 / 4) ** 0.5
    x, y = float(row["x"]), float(row["y"])
    assert HEIGHT + (x - 0.3) ** 2 + 2 * (y - 0.7) ** 2 < loss + 0.267 * 2 * 0.02


def test_best_two_are_not_told_apart_by_less_than_chance(noisy):
    assert re.search(r"the best two, .*, cannot be told apart", noisy.stdout)
    row = best(table("noisy"))
    assert float(row["low"]) < float(row["value"]) < float(row["high"])


def test_best_is_measured_again_with_other_seeds(noisy):
    (again,) = re.findall(r"with other seeds, .*: (\S+) \((\S+) to (\S+)\)", noisy.stdout)
    value, low, high = map(float, again)
    row = best(table("noisy"))
    assert low < value < high and abs(value - float(row["value"])) > 1e-6
    # bound: four standard deviations of a mean of four
    true = -(float(row["x"]) - 0.3) ** 2 - 2 * (float(row["y"]) - 0.7) ** 2
    assert abs(value - true) < 4 * 1.02 * NOISE / 4**0.5
    assert len(kept("noisy")) <= 92
