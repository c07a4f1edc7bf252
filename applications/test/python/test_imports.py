# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of validations do nothing when they are imported."""

import glob
import os
import runpy
import sys

import pytest

ROOT = os.path.join(os.environ["FSBI_DIR"], "validation")
SCRIPTS = sorted(glob.glob("*/*.py", root_dir=ROOT) + glob.glob("*.py", root_dir=ROOT))


@pytest.mark.parametrize("script", SCRIPTS)
def test_import_does_nothing(script, scratch, monkeypatch, capsys):
    path = os.path.join(ROOT, script)
    monkeypatch.syspath_prepend(os.path.dirname(path))
    monkeypatch.setattr(sys, "argv", [path])
    known = dict(sys.modules)
    runpy.run_path(path, run_name="imported")
    # those of other validations have the same names
    for name in set(sys.modules) - set(known):
        if os.path.dirname(getattr(sys.modules[name], "__file__", None) or "").startswith(ROOT):
            del sys.modules[name]
    assert capsys.readouterr().out == "" and os.listdir(scratch) == []
