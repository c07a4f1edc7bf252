# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Saved states of a case as VTK data, by OpenFOAM's own foamToVTK.

    with VTKFiles(case, "fluid", fields="U", times="latest") as states:
        for state in states:
            state.time, state.mesh(), state.patches(), state.patch("cell")
    saved_drawing(case, state.time, "bonds.vtk")
"""

import json
import os
import re
import shutil
import subprocess
import tempfile

import vtk


class NoStates(Exception):
    """Why there is nothing to show."""


def folders_by_time(folder):
    """Names of time folders by the number they stand for."""
    def number(name):
        return re.fullmatch(r"[0-9.]+(e[-+]?[0-9]+)?", name) and float(name)
    return {number(n): n for n in os.listdir(folder) if number(n) is not None}


def decomposed(case):
    """How many processor folders hold times that the case folder lacks."""
    parts = [n for n in os.listdir(case) if re.fullmatch("processor[0-9]+", n)]
    if not parts:
        return 0

    def newest(folder):
        return max(folders_by_time(folder), default=-1)

    return len(parts) if newest(os.path.join(case, "processor0")) > newest(case) else 0


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


class State:
    def __init__(self, folder, time):
        self.folder = folder
        self.time = time

    def _file(self, name):
        path = os.path.join(self.folder, name)
        if not os.path.isfile(path):
            folder = os.path.dirname(path)
            there = sorted(n.split(".")[0] for n in os.listdir(folder))
            raise NoStates(f"there is no {os.path.basename(path)}; "
                           f"there are {', '.join(there)}")
        return path

    def mesh(self):
        return read(vtk.vtkXMLUnstructuredGridReader(), self._file("internal.vtu"))

    def patches(self):
        folder = os.path.join(self.folder, "boundary")
        there = os.listdir(folder) if os.path.isdir(folder) else []
        return sorted(n[:-len(".vtp")] for n in there if n.endswith(".vtp"))

    def patch(self, name):
        return read(vtk.vtkXMLPolyDataReader(), self._file(f"boundary/{name}.vtp"))


class VTKFiles:
    """States of one region, in the order of their times, while the `with` lasts."""

    def __init__(self, case, region="fluid", fields="U", times="latest", internal=True):
        self.scratch = tempfile.mkdtemp(prefix="vtk", dir=case)
        self.series = os.path.join(self.scratch, region)
        command = ["foamToVTK", "-case", case, "-fields", f"({fields})",
                   "-name", os.path.basename(self.scratch)]
        command += ["-region", region] if region else []
        command += [] if internal else ["-no-internal"]
        command += {"latest": ["-latestTime"], "all": []}.get(times, ["-time", times])
        processors = decomposed(case)
        if processors:
            command = ["mpirun", "-np", str(processors)] + command + ["-parallel"]
        self.command = command

    def __enter__(self):
        try:
            self._convert()
            return self._states()
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_):
        shutil.rmtree(self.scratch, ignore_errors=True)

    def _convert(self):
        if "WM_PROJECT_DIR" not in os.environ:
            raise NoStates("source fsbiFoam's etc/bashrc first")
        run = subprocess.run(self.command, capture_output=True, text=True)
        if run.returncode:
            raise NoStates("foamToVTK failed:\n" + (run.stdout + run.stderr)[-1500:])

    def _states(self):
        names = os.listdir(self.series) if os.path.isdir(self.series) else []
        names = [n for n in names if n.endswith(".vtm.series")]
        if not names:
            raise NoStates("foamToVTK found no saved state of that region")
        with open(os.path.join(self.series, names[0])) as file:
            entries = json.load(file)["files"]
        found = [State(os.path.join(self.series, e["name"][:-len(".vtm")]), e["time"])
                 for e in entries]
        return sorted(found, key=lambda state: state.time)


def saved_drawing(case, time, name):
    """What an effect drew of a saved state, as bonds.vtk and B.vtk; None if it did
    not."""
    root = os.path.join(case, "processor0") if decomposed(case) else case
    there = folders_by_time(root)
    nearest = min(there, key=lambda t: abs(t - time), default=None)
    if nearest is None or abs(nearest - time) > 1e-6 * abs(time):
        return None
    path = os.path.join(root, there[nearest], "uniform", name)
    if not os.path.isfile(path):
        return None
    reader = vtk.vtkGenericDataObjectReader()
    reader.ReadAllScalarsOn()
    return read(reader, path)
