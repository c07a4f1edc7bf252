# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Read the HDF5 history of a run.

    from fsbi.history import History

    history = History("case/history.h5")
    print(history.paths())
    position = history["bodies/tumourCell/position"]
    plt.plot(position["time"], position["x"])
    position.columns, position.units, position.array
    history.runs["0"]["defaults"]       # of the run that began at time 0
"""

import os

import h5py
import numpy as np


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class Table:
    """One table: the columns by name, or all of them as an array."""

    def __init__(self, dataset):
        self.array = _complete(dataset[()])
        self.columns = [_text(c) for c in dataset.attrs["columns"]]
        self.units = ", ".join(_text(u) for u in dataset.attrs["units"])

    def __getitem__(self, column):
        if column not in self.columns:
            raise KeyError(
                f"no column '{column}'; there are {', '.join(self.columns)}"
            )
        return self.array[:, self.columns.index(column)]

    def __len__(self):
        return len(self.array)


def _complete(array):
    """Without the last row if the run was killed while writing it."""
    back = np.flatnonzero(np.diff(array[:, 0]) < 0)
    return array[: back[0] + 1] if len(back) else array


class History:
    """The tables of a history file, of a finished, killed or running run."""

    def __init__(self, path):
        if not os.path.isfile(path):
            raise FileNotFoundError(f"there is no history file {path}")
        self.path = path
        self._tables = {}
        self.runs = {}
        with h5py.File(path, "r", swmr=True) as file:
            file.visititems(self._read)

    def _read(self, path, node):
        if isinstance(node, h5py.Dataset):
            self._tables[path] = Table(node)
        elif path.startswith("runs/"):
            self.runs[path[len("runs/"):]] = {
                name: [_text(line) for line in lines] for name, lines in node.attrs.items()}

    def paths(self):
        return sorted(self._tables)

    def __contains__(self, path):
        return path in self._tables

    def __getitem__(self, path):
        if path not in self._tables:
            raise KeyError(
                f"no history '{path}' in {self.path}; there are "
                + ", ".join(self.paths())
            )
        return self._tables[path]
