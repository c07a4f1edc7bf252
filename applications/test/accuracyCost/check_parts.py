# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a study, without a run: sequences of known limit and order, runs
of known cost, the best of many, what the knobs do to a case."""

import os
import shutil

import numpy as np

from checks import check, end
from fsbi.accuracy_cost import Refused, knobs, quantities, richardson
from fsbi.accuracy_cost.predict import Predictor
from fsbi.accuracy_cost.study import front


def check_orders():
    h = np.array([2, 1.4, 1, 0.75])
    for p in (1, 2, 3):
        found = richardson.estimate(h, 7 - 0.3 * h**p)
        check(f"order {p} and its limit are found",
              abs(found.order - p) < 0.01 and abs(found.limit - 7) < 1e-3
              and found.kind == "asymptotic", found)
    same = richardson.estimate(h, 0 * h + 5)
    check("equal values are settled", same.kind == "settled" and same.limit == 5)
    two = richardson.estimate([2, 1], [1.4, 1.1])
    check("two values give no order", np.isnan(two.order) and two.kind == "monotone"
          and abs(two.limit - 1) < 1e-12 and two.uncertainty > 0.2, two)


def check_other_sequences():
    h = np.array([2, 1.4, 1, 0.75])
    turning = richardson.estimate(h, [1.2, 0.9, 1.05, 1.01])
    check("a sequence that turns has no order", turning.kind == "scattered"
          and np.isnan(turning.order) and turning.limit == 1.01)
    check("and an uncertainty as wide as the finest values",
          turning.uncertainty > 0.15, turning)
    apart = richardson.estimate([4, 2, 1], [1, 2, 4])
    check("a sequence that runs away is not asymptotic", apart.kind == "monotone"
          and apart.uncertainty > 2, apart)


def coverage(noise):
    """Part of random sequences whose limit is within the uncertainty."""
    random = np.random.default_rng(3)
    h, hits, trials = np.array([2, 1.4, 1, 0.75]), 0, 300
    for _ in range(trials):
        p = random.choice([1, 2])
        v = 1 + 0.05 * h**p * (1 + random.uniform(-0.2, 0.2) * h)
        found = richardson.estimate(h, v + noise * random.standard_normal(4))
        hits += abs(found.limit - 1) <= found.uncertainty
    return hits / trials


def check_uncertainty():
    for noise in (0, 1e-3, 1e-2):
        part = coverage(noise)
        check(f"limits of 300 random sequences, noise {noise:g}, lie within the "
              "uncertainty at 9 of 10", part >= 0.9, part)


def named(name, values, base=0):
    return knobs.Knob(name, values, None, base)


def cost(settings):
    """Seconds of stepping and meshing, megabytes, as of a real run: with a
    start, and a solver whose iterations depend on the tolerance."""
    f, dt, tol = (float(settings[k]) for k in ("mesh", "timeStep", "tolerance"))
    cells = 18000 / f**2.8
    its = (15 - 1.5 * np.log10(tol)) * dt**0.15
    slow = 6 if settings["method"] == "SIMPLEC" else 1
    return (0.2 + 100 / dt * cells**1.15 * its * 2e-7 * slow, 5e-5 * cells * 8,
            150 + 0.006 * cells)


def check_predictions():
    varied = [knobs.Factor(n) for n in knobs.BUILT_IN] + [named("method", ["coupled", "SIMPLEC"])]
    base = dict(mesh="1", timeStep="1", tolerance="1", method="coupled")
    plan = [base] + [{**base, k.name: v} for k in varied[:3] for v in k.values if v != "1"]
    predictor, good, told = Predictor(varied), 0, 0
    check("nothing is predicted before the first run", predictor.predict(base) is None)
    for settings in sorted(plan, key=lambda s: sum(cost(s)[:2])):
        true, found = cost(settings), predictor.predict(settings)
        if found:
            told += 1
            good += 1 / 1.5 < found[0] / sum(true[:2]) < 1.5
        predictor.add(settings, *true)
    check("9 of 10 predictions are within a factor of 1.5", good >= 0.9 * told == 8.1,
          f"{good} of {told}")
    combined = dict(base, mesh="1.4", timeStep="2", tolerance="100")
    ratio = predictor.predict(combined)[0] / sum(cost(combined)[:2])
    check("so is a combination", 1 / 1.5 < ratio < 1.5, ratio)
    unknown = predictor.predict(dict(base, method="SIMPLEC"))
    check("a word never tried is known to be a guess", unknown[2] > 0.6, unknown)


def check_front():
    runs = [(1, 0.1), (2, 0.2), (3, 0.05), (4, 0.05), (5, 0.01), (3, 0.04)]
    found = front(runs, lambda r: r[0], lambda r: r[1])
    check("the best of many are those that none beats in both",
          found == [(1, 0.1), (3, 0.04), (5, 0.01)], found)


def check_reductions():
    t, v = np.array([0.0, 1, 3]), np.array([0.0, 2, 2])
    r = quantities.reduce
    found = [r(t, v, "last"), r(t, v, "max"), r(t, v, "mean"), r(t, v, "at=0.5", [0.5]),
             r(t, v, "mean=1,3", [1, 3])]
    check("last, max, mean over time, at a time, over a window",
          np.allclose(found, [2, 2, 5 / 3, 1, 2]), found)


def check_mesh_knob():
    """All sizes go along; the case of the Allrun, with some more entries."""
    shutil.copytree("case", "scaled")
    entries = knobs.Entries("scaled")
    entries.set("system/remeshDict", "farSize", "10")
    with open("scaled/system/blockMeshDict") as file:
        text = file.read()
    with open("scaled/system/blockMeshDict", "w") as file:
        file.write(text.replace("(8 8 8)", "(8 $n 1)").replace("scale ", "n 12;\nscale "))
    knobs.Factor("mesh", [2]).apply(entries, "2")
    read = entries.number
    found = [read("constant/bodies", "tumourCell/shape/size"),
             *(read("system/remeshDict", e) for e in ("growth", "farSize", "cellsPerGap")),
             read("system/blockMeshDict", "n")]
    check("mesh 2 doubles sizes and growth, halves blocks and cells per gap",
          found == [4.8, 1.2, 20, 1.5, 6], found)
    with open("scaled/system/blockMeshDict") as file:
        check("also numbers in the blocks, down to one", "(4 $n 1)" in file.read())
    entries.set("constant/bodies", "tumourCell/shape", "{ type sphere; radius 8; }")
    knobs.Factor("mesh", [2]).apply(entries, "2")
    check("a size that is not given is the default's double",
          read("constant/bodies", "tumourCell/shape/size") == 3.2)


def check_listed_knobs():
    entries = knobs.Entries("case")
    step = "system/controlDict:deltaT"
    made = knobs.make([["dt", step, "6400", "3200", "1600"]], entries)[0]
    check("the case as it is is one of a knob's values", made.values[made.base] == "1600"
          and made.size("6400") == 4)
    made = knobs.make([["dt", step, "6400", "3200"]], entries)[0]
    check("or is put among them", made.values == ["6400", "3200", "1600"])
    given = knobs.Entries("case", [("system/remeshDict", "optimise", "1")])
    made = knobs.make([["n", "system/remeshDict:optimise", "1", "2", "4"]], given)[0]
    check("numbers that rise are counts", made.sizes[-1] / made.sizes[0] < 0.5, made.sizes)
    for wrong in (["mesh", "x"], ["mesh", "-1"], ["dt"], ["dt", "nowhere:a", "1", "2"],
                  ["dt", step, "1", "3", "2"], ["dt", step, "1", "1"],
                  ["n", "system/remeshDict:optimise", "1", "2"]):
        try:
            knobs.make([wrong], entries)
            check(f"knob {' '.join(wrong)} is refused", False)
        except Refused as error:
            check(f"knob {' '.join(wrong)} is refused", str(error).count("\n") == 0, error)


check_orders()
check_other_sequences()
check_uncertainty()
check_predictions()
check_front()
check_reductions()
check_mesh_knob()
check_listed_knobs()
end()
