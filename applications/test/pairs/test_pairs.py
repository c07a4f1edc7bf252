"""Pairs of what a scene may have. Every run has three steps; its restart goes on from
what is saved after the first one."""
import itertools
import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from fsbi.history import History

HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
END = "30"
SHEAR = 6 * np.pi * 1e-3 * 1.5      # 6 pi mu a times the velocity of the shear there

# By the file that they stand in
PARTS = {
    "bonds": ("effects", """temperature 310; seed 1;
        molecules { a { R { density 20; } } bottomWall { ligand { density 100; } }
                    b { ligand { density 100; } } }
        pairs { p { kinds (R ligand); law Dembo; k0on 1e-2; k0off 1e-6; lambda 0.1;
                    s 1e-3; sts 1e-3; roughness 0.4; } }"""),
    "repulsion": ("effects", "strength 1e-3; range 0.8;"),
    "contact": ("effects", "gap 0.2; range 0.5; pressure 0.01;"),
    "magnetics": ("effects", """
        fields { turning { type rotating; magnitude 5e-3; axis (0 0 1); start (1 0 0);
                           frequency 1e-4; } }
        bodies { a { type permanent; direction (1 1 0); magnetisation 1e4; }
                 b { type saturated; magnetisation 1e4; } }
        interaction {}"""),
    "weight": ("effects", "gravity (0 -9.81e-6 0); fluidDensity 1;"),
    "opticalTweezers": ("effects", """
        left { body a; position (-1 1.5 0.1); stiffness 1e-3; }
        right { body b; position (1.1 1.6 0); stiffness 1e-3; }"""),
    "thermalMotion": ("effects", "temperature 310; seed 1;"),
    "inertia": ("fluid/material", "density 1;"),
    "forces": ("fluid/material", "drive { type uniform; value (1e-5 0 0); }"),
    "gravity": ("fluid/material",
                "g { type gravity; density 1; acceleration (0 -9.81e-6 0); }"),
    "species": ("species",
                "diffusivity 0.1; initial 1; surfaces { a { type release; rate 0.1; } }"),
}
NAMES = {"species": "drug", "gravity": "forces"}
# By the READMEs of thermalMotion, its fluid has no memory, and of weight, gravity would
# count twice
REFUSED = {("thermalMotion", "inertia"): ("inertia", "do not go with"),
           ("weight", "gravity"): ("gravity already", "Remove one of the two")}
PAIRS = [p for p in itertools.combinations(PARTS, 2) if "gravity" not in p or p in REFUSED]
STAND = [p for p in PAIRS if p not in REFUSED]


def scene(pair, folder):
    shutil.copytree("base", folder)
    texts = {}
    for part in pair:
        file, text = PARTS[part]
        texts[file] = texts.get(file, "") + f"{NAMES.get(part, part)} {{ {text} }}\n"
    for file, text in texts.items():
        path = f"{folder}/constant/{file}"
        there = os.path.isfile(path)
        with open(path, "a") as out:
            out.write(text if there else HEADER.format(os.path.basename(file)) + text)


def solve(folder, log="log.fsbiFoam"):
    with open(f"{folder}/{log}", "w") as out:
        return subprocess.run(["fsbiFoam"], cwd=folder, stdout=out, stderr=out,
                              stdin=subprocess.DEVNULL, timeout=100).returncode


def name(pair):
    return "-".join(pair)


def whole_and_parts(pair):
    folder = f"runs/{name(pair)}"
    scene(pair, folder)
    code = solve(folder)
    if code or pair in REFUSED:
        return code
    parts = f"{folder}.parts"
    shutil.copytree(folder, parts)
    for later in ("20", END):
        shutil.rmtree(f"{parts}/{later}")
    return solve(parts, "log.second")


@pytest.fixture(scope="module")
def codes():
    with ThreadPoolExecutor(2) as pool:
        return dict(zip(PAIRS, pool.map(whole_and_parts, PAIRS)))


def last_lines(folder, log="log.fsbiFoam"):
    with open(f"{folder}/{log}") as file:
        return "".join(file.readlines()[-12:])


def files(folder):
    found = {}
    for top, _, names in os.walk(folder):
        for file in names:
            path = os.path.join(top, file)
            with open(path, "rb") as f:
                text = f.read()
            # the checkpoint's first line is the time of the day
            skipped = 1 if file == "checkpoint" else 0
            found[os.path.relpath(path, folder)] = text.split(b"\n", skipped)[-1]
    return found


@pytest.mark.parametrize("pair", STAND, ids=name)
def test_runs_and_continues(codes, pair):
    folder = f"runs/{name(pair)}"
    assert codes[pair] == 0, last_lines(folder)
    whole, parts = (files(f"{f}/{END}") for f in (folder, f"{folder}.parts"))
    assert whole.keys() == parts.keys()
    assert not [f for f in whole if whole[f] != parts[f]]
    history, other = (History(f"{f}/postProcessing/history.h5")
                      for f in (folder, f"{folder}.parts"))
    assert list(history["cost"]["time"]) == [10, 20, 30]
    for path in history.paths():
        assert np.isfinite(history[path].array).all(), path
        if path != "cost":
            assert np.array_equal(history[path].array, other[path].array), path


@pytest.mark.parametrize("pair", STAND, ids=name)
def test_loads_are_balanced(codes, pair):
    # bound: the solver's tolerance of 1e-9 of the shear's forces, in a thousand rows, and
    # of what acts, 1e-3
    history = History(f"runs/{name(pair)}/postProcessing/history.h5")
    for load in ("force", "torque"):
        parts = [[history[path].array[:, 1:] if path in history else np.zeros((3, 3))
                  for path in (f"bodies/{b}/{load}/{of}" for b in "ab")]
                 for of in ("fluid", "effects")]
        fluid, effects = np.array(parts)
        bound = 1e-3 * abs(effects).max() if effects.any() else 1e-6 * SHEAR
        assert abs(fluid + effects).max() < bound, load


@pytest.mark.parametrize("part", [p for p in PARTS if PARTS[p][0] == "effects"])
def test_acts(codes, part):
    history = History(f"runs/{name((part, 'species'))}/postProcessing/history.h5")
    assert all(history[f"bodies/{b}/force/effects"].array[:, 1:].any() for b in "ab")


@pytest.mark.parametrize("pair", REFUSED, ids=name)
def test_is_refused(codes, pair):
    assert codes[pair] != 0
    with open(f"runs/{name(pair)}/log.fsbiFoam") as file:
        text = file.read()
    assert text.count("FOAM FATAL") == 1 and "printStack" not in text
    for words in REFUSED[pair]:
        assert words in text
