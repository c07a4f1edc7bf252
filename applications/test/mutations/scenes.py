# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tutorials in forms that take their first two steps in half a second: the
same files with the same entries, only some numbers of them coarser."""

import os
import re
import shutil
import subprocess

ROOT = os.environ["FSBI_DIR"]
TUTORIALS = os.path.join(ROOT, "tutorials")

# factor of the bodies' triangles, cells of the background; the fastest first
COARSE = {
    "beamSelfWeight": (1, None),
    "tumourCellInUniformFlow": (3, (3, 3, 3)),
    "tumourCellInShear": (3, (4, 4, 4)),
    "rollingLeukocyteShape": (2, (6, 3, 5)),
    "microbeadInGradient": (3, (3, 3, 3)),
    "softCellInShear": (1.8, (4, 4, 4)),
    "rotatingSphere": (2, None),
    "cellInCapillary": (2, None),
    "leukocyteRollingOnEndothelium": (1.5, (4, 2, 3)),
    "beamFlexure": (1, None),
    "microbeadTethered": (2, (6, 3, 5)),
    "softLeukocyteRolling": (2, (6, 3, 5)),
    "magneticTether": (1.6, (6, 3, 5)),
    "microrobotSwarm": (1, (5, 5, 2)),
    "helicalSwimmer": (1.6, (3, 3, 3)),
    "twoCellAggregate": (1.4, (6, 3, 5)),
    "tumourCellPassesLeukocyte": (2, (6, 3, 5)),
}


def edit(path, pattern, replacement):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    new, count = re.subn(pattern, replacement, text, flags=re.M)
    with open(path, "w", encoding="utf-8") as file:
        file.write(new)
    return count


def shell(command, folder):
    done = subprocess.run(command, cwd=folder, shell=True, capture_output=True, text=True,
                          check=False)
    if done.returncode:
        raise RuntimeError(f"{command} in {folder}: {(done.stdout + done.stderr)[-800:]}")


def coarser(factor):
    return lambda m: f"{m[1]}{factor * float(m[2]):.4g}"


def copy(tutorial, case):
    shutil.rmtree(case, ignore_errors=True)
    for part in ("constant", "system"):
        shutil.copytree(os.path.join(TUTORIALS, tutorial, part), os.path.join(case, part))
    shutil.copytree(os.path.join(TUTORIALS, tutorial, "0.orig"), os.path.join(case, "0"))


def prepare(tutorial, case):
    """A case that `fsbiFoam` runs at once, for two steps."""
    copy(tutorial, case)
    factor, cells = COARSE[tutorial]
    controls = os.path.join(case, "system/controlDict")
    for file in ("bodies", "sphere"):
        path = os.path.join(case, "constant", file)
        if os.path.isfile(path):
            edit(path, r"\b(size\s+)([0-9.]+)", coarser(factor))
    edit(os.path.join(case, "constant/bodies"), r"^(\s*turns\s+)\d+", r"\g<1>1")
    if cells:
        size = " ".join(map(str, cells))
        edit(os.path.join(case, "system/blockMeshDict"), r"\(\d+ \d+ \d+\) simpleGrading",
             f"({size}) simpleGrading")
        edit(os.path.join(case, "system/remeshDict"), r"^(growth\s+)[0-9.]+", r"\g<1>1")
    elif tutorial == "cellInCapillary":
        # the rim's cells as many along and around as the core's
        edit(os.path.join(case, "system/blockMeshDict"), r"\(32 16 (16|3)\)",
             lambda m: "(8 6 6)" if m[1] == "16" else "(8 6 1)")
        edit(os.path.join(case, "system/remeshDict"), r"^(growth\s+)[0-9.]+", r"\g<1>1")
    elif tutorial.startswith("beam"):
        # 72 cells
        edit(os.path.join(case, "system/blockMeshDict"), r"^(n\s+)\d+", r"\g<1>3")
        edit(os.path.join(case, "system/blockMeshDict"), r"^(nz\s+)\d+", r"\g<1>8")
    with open(controls, encoding="utf-8") as file:
        step = float(re.search(r"^deltaT\s+([0-9.e]+)", file.read(), re.M)[1])
    for entry in ("endTime", "writeInterval"):
        edit(controls, rf"^({entry}\s+)[0-9.e]+", rf"\g<1>{2 * step:g}")
    if tutorial == "magneticTether":
        currents(case)
    if os.path.isfile(os.path.join(case, "system/blockMeshDict")):
        shell("blockMesh", case)


def currents(case):
    """The coils' currents of magneticTether, from its run with a tether."""
    tethered = os.path.join(case, "tethered")
    shutil.copytree(case, tethered + ".new")
    os.rename(tethered + ".new", tethered)
    os.remove(os.path.join(tethered, "constant/effects"))
    edit(os.path.join(tethered, "constant/bodies"), r"^(\s*deformed)", r"tether {} \1")
    shell("blockMesh", tethered)
    shell("fsbiFoam", tethered)
    shell("fsbiFieldDesign", case)
    shutil.rmtree(tethered)
    shutil.rmtree(os.path.join(case, "postProcessing"), ignore_errors=True)
