# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case of the tests, and fsbiEnsemble called as a user does."""

import os
import shutil
import subprocess

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application bindingOfTest;
receptors 1;
blocked 0;
seed 1;
seconds 0;
"""
TEXT = """FoamFile { version 2.0; format ascii; class dictionary; object ensembleDict; }
patients
{
    table       "constant/patients.csv";
    entries     { receptors "system/controlDict:receptors"; }
}
drug
{
    doses       (0 10 40);
    KD          0.5;
    blocks      "system/controlDict:blocked";
    plasma      "constant/plasma.csv";
}
protocols
{
    once        { given (0); encounter 6; }
    twice       { given (0 4); encounter 6; }
}
seeds           3;
seedEntry       "system/controlDict:seed";
quantities
{
    bond        { quantity "errors.bond"; above 0.5; }
    density     { quantity "errors.receptors"; }
    part        { quantity "errors.blocked"; }
}
smallest        { quantity bond; below 0.4; }
"""
PATIENTS = "patient,receptors (1/um2),KD,remark\nA,3,0.5,first\nB,1.5,2,\n"
PLASMA = "time (h),concentration (mg/l)\n0,0\n2,0.1\n4,0.06\n8,0.02\n"


def new(name, text=TEXT, patients=PATIENTS, plasma=PLASMA, control=CONTROL):
    shutil.rmtree(name, ignore_errors=True)
    for folder in ("system", "constant"):
        os.makedirs(os.path.join(name, folder))
    for path, content in (("system/controlDict", control), ("system/ensembleDict", text),
                          ("constant/patients.csv", patients), ("constant/plasma.csv", plasma)):
        with open(os.path.join(name, path), "w") as file:
            file.write(content)
    return str(name)


def call(*arguments):
    return subprocess.run(["fsbiEnsemble", *arguments], capture_output=True, text=True,
                          check=False, timeout=120)
