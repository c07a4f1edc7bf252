# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np
import pytest

from fsbi import steps

# by the time a run began at: steps.dat and seconds.dat; the second one was killed
# while it wrote, and went on from before the first one's end
RUNS = {
    "0": ("# time length ...\n"
          "1 1 accepted 9 1 1e-7 0.5 deltaT\n"
          "2 1 rejected 8 2 1e-2 - it failed, alas\n"
          "3 2 accepted 7 1 1e-7 - deltaT\n",
          "# time solve bonds total\n1 0.5 0.25 1\n3 0.75 0.5 2\n"),
    "1": ("# time length ...\n1.5 0.5 accepted 6 1 1e-7 - growth\n2 0.5 acc",
          "# time solve total\n1.5 4 5\n"),
}


@pytest.fixture
def case(scratch):
    for start, (tried, seconds) in RUNS.items():
        folder = scratch / "postProcessing/steps" / start
        folder.mkdir(parents=True)
        (folder / "steps.dat").write_text(tried)
        (folder / "seconds.dat").write_text(seconds)
    return str(scratch)


def test_steps_of_a_continued_run_replace_what_it_went_back_behind(case):
    assert [(s.time, s.iterations) for s in steps.tried(case)] == [(1, 9), (1.5, 6)]


def test_seconds_of_both_runs_add_up_by_part(case):
    parts, seconds = steps.seconds(case)
    assert parts == ["solve", "bonds", "total"]
    assert np.allclose(seconds, [[1, 0.5, 0.25, 1], [1.5, 4.5, 0.25, 6]])
