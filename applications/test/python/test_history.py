# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
import h5py
import numpy as np
import pytest

from fsbi.history import History


@pytest.fixture
def speed(scratch):
    """Of a run that was killed while it wrote its fourth row."""
    rows = np.array([[0, 1.0], [1, 2.0], [2, 4.0], [0, 0]])
    with h5py.File("history.h5", "w", libver="latest") as file:
        table = file.create_dataset("bodies/cell/speed", data=rows)
        table.attrs["columns"] = np.array([b"time", b"u"])
        table.attrs["units"] = np.array([b"um/us"])
    return History("history.h5")["bodies/cell/speed"]


def test_history_is_read_by_names_without_the_torn_row(speed):
    assert list(speed["u"]) == [1, 2, 4] and len(speed) == 3


def test_history_has_its_units(speed):
    assert speed.units == "um/us"


def test_unknown_column_is_refused(speed):
    with pytest.raises(KeyError, match="there are time, u"):
        speed["v"]


def test_unknown_table_is_refused(speed):
    with pytest.raises(KeyError, match="there are bodies/cell/speed"):
        History("history.h5")["bodies/cell/velocity"]
