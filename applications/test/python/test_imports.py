# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of validations do nothing when they are imported."""

import glob
import os
import runpy
import sys

import pytest

ROOT = os.path.join(os.environ["FSBI_DIR"], "validation")
# Of programs that are compared with; they need not be there
PEERS = "dolfinx", "gmsh", "mpi4py", "petsc4py", "ufl"
SCRIPTS = sorted(glob.glob("*/*.py", root_dir=ROOT) + glob.glob("*.py", root_dir=ROOT))


@pytest.mark.parametrize("script", SCRIPTS)
def test_import_does_nothing(script, scratch, monkeypatch, capsys):
    path = os.path.join(ROOT, script)
    monkeypatch.syspath_prepend(os.path.dirname(path))
    monkeypatch.setattr(sys, "argv", [path])
    known = dict(sys.modules)
    try:
        runpy.run_path(path, run_name="imported")
    except ModuleNotFoundError as error:
        if (error.name or "").split(".")[0] not in PEERS:
            raise
    # those of other validations have the same names
    for name in set(sys.modules) - set(known):
        if os.path.dirname(getattr(sys.modules[name], "__file__", None) or "").startswith(ROOT):
            del sys.modules[name]
    assert capsys.readouterr().out == "" and os.listdir(scratch) == []
