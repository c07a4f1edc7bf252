# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked for is in a picture. Needs a display, as xvfb-run gives.

    check_pictures.py rim|bonds|streamlines|field|film CASE [BODY]
"""

import os
import subprocess
import sys

import numpy as np
import vtk
from PIL import Image, ImageChops
from vtk.util.numpy_support import vtk_to_numpy

from fsbi import cuts, picture, vtk_files
from fsbi.history import History

what, case, body = (sys.argv + ["leukocyte"])[1:4]


def drawn(*arguments):
    """(pixels, bars, time) of the last state."""
    options = picture.options_of("picture").parse_args([
        case, "--bodies", body, "--size", "500", "400", *arguments])
    with vtk_files.VTKFiles(case, "fluid", "U", "latest") as states:
        pixels, bars, _ = picture.drawn(options, states[-1])
        return pixels[:, :, :3].astype(int), bars, states[-1].time


def changed(a, b):
    return int((np.abs(a - b).max(axis=2) > 30).sum())


def rim():
    """Seen from straight before it, the part within a box is a square."""
    pixels, _, _ = drawn("--bodies", "--origin", "20", "14", "20", "--within", "4", "--tilt", "0",
                         "0", "--zoom", "0.5")
    top, bottom, left, right = picture.ink(pixels, 0)
    full = (pixels[top:bottom + 1, left:right + 1] < 250).any(axis=2).mean()
    assert full > 0.995, f"{full:.3f} of the square is filled"
    assert abs((bottom - top) / (right - left) - 1) < 0.02, (top, bottom, left, right)


def bonds():
    look = ("--no-cut", "--no-edges", "--tilt", "10", "2")
    without, _, time = drawn(*look)
    shown, bars, _ = drawn(*look, "--bonds", "--bond-width", "3")
    tension = cuts.largest_tension(vtk_files.saved_drawing(case, time, "bonds.vtk"))
    assert tension > 0 and len(bars) == 1, (tension, bars)
    assert abs(bars[0][1][1] / (1000 * tension) - 1) < 1e-6, (bars, tension)
    assert changed(without, shown) > 50, changed(without, shown)


def streamlines():
    look = ("--flat", "--no-edges")
    lines = changed(drawn(*look)[0], drawn(*look, "--streamlines", "12")[0])
    assert lines > 500, lines


def field():
    """The grid holds the field that the body was in, and arrows show it."""
    history = History(f"{case}/postProcessing/history.h5")
    place = history[f"bodies/{body}/position"].array[-1, 1:]
    B = history[f"effects/magnetics/{body}"].array[-1, 1:4]
    probe = vtk.vtkProbeFilter()
    at = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    points.InsertNextPoint(place)
    at.SetPoints(points)
    probe.SetInputData(at)
    look = ("--within", "10", "--no-edges", "--normal", "0", "-1", "0", "--up", "0", "0", "1")
    without, _, time = drawn(*look)
    probe.SetSourceData(vtk_files.saved_drawing(case, time, "B.vtk"))
    probe.Update()
    found = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("B"))[0]
    # bound: linear between points of a field whose coil is 500 spacings away
    assert np.linalg.norm(found - B) < 1e-4 * np.linalg.norm(B), (found, B)
    shown, _, _ = drawn(*look, "--B")
    red = (shown[:, :, 0] > 180) & (shown[:, :, 1] < 120)
    assert red.sum() > 500 and changed(without, shown) > 500, red.sum()


def film():
    states = [n for n in vtk_files.folders_by_time(case).values() if n != "0.orig"]
    subprocess.run(["fsbiMovie", case, "--bodies", body, "--bonds", "--no-cut", "--size", "400",
                    "300", "--output", f"{case}/film.gif"], check=True)
    images = Image.open(f"{case}/film.gif")
    assert images.n_frames == len(states), (images.n_frames, states)
    images.seek(0)
    first = images.convert("RGB")
    images.seek(images.n_frames - 1)
    assert ImageChops.difference(first, images.convert("RGB")).getbbox(), "nothing moves"
    assert not [n for n in os.listdir(case) if n.startswith("vtk")], "left behind"


{"rim": rim, "bonds": bonds, "streamlines": streamlines, "field": field, "film": film}[what]()
