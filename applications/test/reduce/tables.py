# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What HDF5 files of cases hold.

    tables.py same CASE CASE            tables of resistances, to the last bit
    tables.py without CASE TEXT ...     no table of the history is called so
    tables.py rows CASE NUMBER          so many steps are in the history and the text
"""

import sys

import h5py
import numpy as np


def names(file):
    found = []
    file.visit(found.append)
    return found


def same(one, other):
    with h5py.File(f"{one}/constant/reduced.h5") as a, \
            h5py.File(f"{other}/constant/reduced.h5") as b:
        assert names(a) == names(b) and len(names(a)) == 7
        assert all(np.array_equal(a[n][()], b[n][()]) for n in a)


def without(case, *texts):
    with h5py.File(f"{case}/postProcessing/history.h5", swmr=True) as file:
        found = names(file)
    assert "bodies/a/position" in found, found
    assert not [n for n in found if any(t in n for t in texts)]


def rows(case, number):
    with h5py.File(f"{case}/postProcessing/history.h5", swmr=True) as file:
        assert len(file["bodies/a/position"]) == int(number), len(file["bodies/a/position"])
    with open(f"{case}/postProcessing/bodies/0/a.dat") as text:
        assert len(text.readlines()) == int(number) + 1     # with that of the columns


{"same": same, "without": without, "rows": rows}[sys.argv[1]](*sys.argv[2:])
