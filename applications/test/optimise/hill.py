# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case of the tests, and fsbiOptimise called as a user does."""

import os
import shutil
import subprocess

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application hillOfTest;
x 0.5;
y 0.5;
noise 0;
seed 1;
seconds 0;
"""
TEXT = """FoamFile { version 2.0; format ascii; class dictionary; object optimiseDict; }
parameters
{
    x   { entry "system/controlDict:x"; range (0 1); }
    y   { entry "system/controlDict:y"; range (0.1 1); }
}
quantities
{
    height  { quantity "errors.height"; }
    both    { quantity "errors.sum"; }
}
maximise    "height";
constraints { least { formula "both"; below 0.8; } }
runs        45;
tolerance   0.002;
"""


def new(name, text=TEXT, control=CONTROL):
    shutil.rmtree(name, ignore_errors=True)
    for folder in ("system", "constant"):
        os.makedirs(os.path.join(name, folder))
    with open(os.path.join(name, "constant/readMe"), "w") as file:
        file.write("nothing\n")
    for path, content in (("system/controlDict", control), ("system/optimiseDict", text)):
        with open(os.path.join(name, path), "w") as file:
            file.write(content)
    return str(name)


def call(*arguments):
    return subprocess.run(["fsbiOptimise", *arguments], capture_output=True, text=True,
                          check=False, timeout=120)
