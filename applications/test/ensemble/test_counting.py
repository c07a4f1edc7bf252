# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which runs count, however many ran at a time and in whatever order they ended:
runs of no time, whose values are known."""

import os
import random
import time

import pytest

from fsbi.ensemble import draw, report, statistics
from fsbi.ensemble.dictionary import Description
from fsbi.ensemble.study import LEAST, Ensemble
from fsbi.studies.quantities import Quantity
from fsbi.studies.runs import Failed

HEADER = "FoamFile { version 2.0; format ascii; class dictionary; object ensembleDict; }\n"


class Bench:
    """value(settings) of every run; keeps them as a real one does."""

    def __init__(self, value, slow=0.0):
        self.value, self.slow, self.done, self.ran = value, slow, {}, []

    def load(self, settings, _):
        return self.done.get(str(settings))

    def failure(self, *_):
        return None

    def run(self, settings, _):
        time.sleep(self.slow * random.random())
        self.ran.append(settings)
        value = self.value(settings)
        if value is None:
            raise Failed("it broke")
        self.done[str(settings)] = dict(folder=str(value))
        return self.done[str(settings)]

    def stop(self):
        pass


@pytest.fixture
def study(tmp_path, monkeypatch):
    """Makes an ensemble of a text and a bench."""
    monkeypatch.setattr(Quantity, "value", lambda self, folder: float(folder))

    def make(bench, text):
        os.makedirs(tmp_path / "system", exist_ok=True)
        (tmp_path / "system/ensembleDict").write_text(HEADER + text)
        return Ensemble(bench, Description(str(tmp_path)))

    return make


GRID = """
parameters { a { entry "f:e"; values (1 2); } }
seeds 40;
quantities { happened { quantity "a.b"; above 0.5; halfWidth 0.2; } }
"""
SOBOL = """
parameters { a { entry "f:e"; range (0 1); } b { entry "f:g"; range (0 1); } }
sampling Sobol; samples 8;
quantities { q { quantity "a.b"; } }
"""


def run(ensemble, jobs, folder):
    ensemble.load(ensemble.members)
    with open(os.devnull, "w") as nowhere:
        ensemble.run(jobs, nowhere)
    report.table(ensemble, f"{folder}/table.csv")
    with open(f"{folder}/table.csv") as file:
        return file.read()


def half_or_always(settings):
    """With a 1 every second seed, with a 2 all."""
    return 1.0 if settings["a"] == "2" else float(int(settings["seed"]) % 2)


def test_point_stops_with_the_first_seed_that_is_enough(study, tmp_path):
    ensemble = study(Bench(half_or_always), GRID)
    run(ensemble, 1, tmp_path)
    counts = [g.counts for g in ensemble.groups]

    def half(happened, trials):
        low, high = statistics.proportion(happened, trials)
        return (high - low) / 2

    assert half((counts[0] + 1) // 2, counts[0]) <= 0.2 < half(counts[0] // 2, counts[0] - 1)
    assert counts[1] == 8               # though 6 of 6 would do
    assert len(ensemble.bench.ran) == sum(counts)


@pytest.mark.parametrize("jobs", [2, 5])
def test_table_does_not_depend_on_how_many_ran_at_a_time(study, tmp_path, jobs):
    one = run(study(Bench(half_or_always), GRID), 1, tmp_path)
    assert run(study(Bench(half_or_always, slow=0.01), GRID), jobs, tmp_path) == one


def test_nor_on_what_was_kept_from_before(study, tmp_path):
    first = Bench(half_or_always)
    one = run(study(first, GRID), 1, tmp_path)
    keys = list(first.done)
    random.shuffle(keys)
    again = Bench(half_or_always)
    again.done = {key: first.done[key] for key in keys[:13]}
    assert run(study(again, GRID), 1, tmp_path) == one
    assert len(again.ran) == len(first.ran) - 13


def test_run_that_fails_is_counted_and_not_a_trial(study, tmp_path):
    def value(settings):
        return None if settings["seed"] == "3" else 1.0

    ensemble = study(Bench(value), GRID)
    assert run(ensemble, 1, tmp_path).count("it broke") == 2
    assert [g.counts for g in ensemble.groups] == [LEAST + 1] * 2
    assert [len(values) for _, _, values, _ in ensemble.estimates()] == [LEAST] * 2


def test_without_halfWidth_all_are_run(study, tmp_path):        # noqa: N802
    ensemble = study(Bench(half_or_always), GRID.replace("halfWidth 0.2;", ""))
    assert run(ensemble, 1, tmp_path).count("\n") == 81


def test_sample_with_a_run_that_failed_is_left_out_of_the_sensitivities(study, tmp_path):
    failing = []

    def value(settings):
        failing[:] = failing or [settings["a"]]
        return None if settings["a"] in failing else float(settings["a"])

    ensemble = study(Bench(value), SOBOL)
    run(ensemble, 1, tmp_path)
    found, left = ensemble.blocks()
    assert left == 1 and found.shape == (7, 4, 1)
    # the first parameter is all there is
    first, total = statistics.sensitivities(found[:, :, 0])
    assert first[1] == total[1] == 0 and total[0] > 0.3


def test_mean_of_sobols_samples_is_that_of_what_was_drawn_independently(study, tmp_path):
    ensemble = study(Bench(lambda settings: float(settings["a"])), SOBOL)
    run(ensemble, 1, tmp_path)
    ((_, _, values, _),) = ensemble.estimates()
    assert len(values) == len(set(values)) == 16


EACH = """
parameters
{
    a { entry "f:e"; range (1 9); spacing logarithmic; }
    law { entry "f:g"; values (Bell Dembo); }
}
seeds each;
quantities { yes { quantity "a.b"; above 3; } q { quantity "a.b"; } }
"""
LIST = EACH.replace("range (1 9); spacing", "range (1 9); number 2; spacing").replace("each", "4")


@pytest.mark.parametrize("text, rows", [
    ("sampling random; samples 16;" + EACH, 16),
    ("sampling latinHypercube; samples 12;" + EACH, 12),
    ("sampling Sobol; samples 8;" + EACH, 40), ("sampling list;" + LIST, 8), (LIST, 16)],
    ids=["random", "latinHypercube", "Sobol", "list", "grid"])
def test_every_sampling_has_tables_and_a_picture(study, tmp_path, text, rows):
    ensemble = study(Bench(lambda settings: float(settings["a"])), text)
    ensemble.bench.folder = str(tmp_path)
    ensemble.load(ensemble.members)
    with open(os.devnull, "w") as nowhere:
        ensemble.run(1, nowhere)
    report.write(ensemble)
    draw.draw(ensemble, f"{tmp_path}/ensemble.png")

    def lines(name):
        with open(tmp_path / name) as file:
            return len(file.readlines()) - 1

    assert lines("table.csv") == rows
    assert lines("summary.csv") == 2 * len(ensemble.groups)
    assert os.path.getsize(tmp_path / "ensemble.png") > 5000
    assert "Sobol" not in text or lines("sensitivities.csv") == 6
