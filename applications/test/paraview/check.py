# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What ParaView's reader sees of a case against the history of the run.

    check.py regions CASE REGION ...    these have a mesh and fields, always
    check.py fields CASE [decomposed]   U on rigid bodies, D of elastic ones
    check.py newMesh CASE               the fluid's mesh is not always the same
    check.py drawn CASE PICTURE         a picture of all regions, not empty
"""

import os
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import vtk_case
from fsbi.history import History

# bound: the reader has numbers in single precision, 6e-8 of the largest
# coordinate or value; a sum, difference and product of such
SINGLE = 4 * 6e-8


def fail(text):
    raise SystemExit(text)


def near(what, values, reference, scale):
    error = np.max(np.abs(values - reference)) / (scale or 1)     # 0: at rest
    print(f"{what}: {error:.1e} of {scale:.3g}")
    if not error <= SINGLE:
        fail(f"{what}: off by {error:.1e} of {scale:.3g}")


def row(table, time):
    """Values at a time."""
    i = np.argmin(np.abs(table["time"] - time))
    if abs(table["time"][i] - time) > 1e-6 * abs(time):
        fail(f"no row of the history is at {time}")
    return table.array[i, 1:]


def regions(folder, *wanted):
    case = vtk_case.Case(folder)
    if not case.times:
        fail("no times")
    for time in case.times:
        found = case.at(time)
        for name in wanted:
            if name not in found or found[name][0] is None:
                fail(f"no region {name} at {time}; there are {sorted(found)}")
            mesh, patches = found[name]
            field = "U" if name == "fluid" else "D"
            if len(vtk_case.cells(mesh, field)) != mesh.GetNumberOfCells() or not patches:
                fail(f"{field} or patches missing in {name} at {time}")
    print(len(case.times), "times of", *wanted)


def rigid(history, name, patch, time):
    """The velocity of its faces is that of the rigid motion."""
    centres = history[f"bodies/{name}/position"]
    centre, velocity, spin = (row(history[f"bodies/{name}/{t}"], time)
                              for t in ("position", "velocity", "angularVelocity"))
    x = vtk_case.centres(patch)
    u = velocity + np.cross(spin, x - centre)
    scale = np.abs(u).max() + np.linalg.norm(spin) * np.abs(x).max()
    # the mesh is where the step set out to bring the body, which is corrected then
    steps = np.diff(np.vstack([centres.array[:, 1:], centre]), axis=0)
    beside = np.mean(vtk_case.cells(patch, "U") - u, axis=0)
    near(f"U of {name} at {time:g}", vtk_case.cells(patch, "U"), u + beside, scale)
    # bound: a step's travel, times the spin
    most = np.linalg.norm(spin) * np.linalg.norm(steps, axis=1).max() + SINGLE * scale
    if np.linalg.norm(beside) > most:
        fail(f"U of {name} at {time:g}: {beside} off on average, bound {most:.1e}")


def elastic(history, name, solid, patch, time):
    """Its centre, and its surface in the fluid's mesh."""
    mesh, own = solid
    V = vtk_case.volumes(mesh)[:, None]
    x = vtk_case.centres(mesh)
    centre = np.sum(V * (x + vtk_case.cells(mesh, "D")), axis=0) / V.sum()
    size = np.abs(x).max()
    near(f"centre of {name} at {time:g}", centre,
         row(history[f"elasticBodies/{name}/centre"], time), size)
    if patch is not None:
        surface = own[name]
        moved = vtk_case.points(surface) + vtk_case.vertices(surface, "pointD")
        tree = vtk.vtkPointSet.SafeDownCast(patch)
        there = np.array([tree.GetPoint(tree.FindPoint(p)) for p in moved])
        near(f"surface of {name} at {time:g}", there, moved, np.abs(moved).max())


def fields(folder, kind=""):
    case = vtk_case.Case(folder, kind == "decomposed")
    history = History(os.path.join(folder, "postProcessing/history.h5"))
    compared = 0
    # rolling bodies keep their shape while it rolls: their surface has another motion
    with open(os.path.join(folder, "constant/bodies"), encoding="utf-8") as file:
        rolls = "rollingLeukocyte;" in file.read()
    for time in (t for t in case.times if t > 0):
        found = case.at(time)
        fluid = found.get("fluid")
        for path in history.paths():
            group, name, last = (path.split("/") + ["", ""])[:3]
            if (group, last) == ("bodies", "position") and not rolls:
                rigid(history, name, fluid[1][name], time)
                compared += 1
            elif (group, last) == ("bodies", "position"):
                compared += 1
            elif (group, last) == ("elasticBodies", "centre"):
                elastic(history, name, found[name], fluid and fluid[1][name], time)
                compared += 1
    if not compared:
        fail("nothing was compared")


def new_mesh(folder):
    case = vtk_case.Case(folder)
    n = {case.at(t)["fluid"][0].GetNumberOfCells() for t in case.times}
    print("cells:", n)
    if len(n) < 2:
        fail("there is no new mesh among the saved states")


def drawn(folder, picture):
    case = vtk_case.Case(folder)
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for name, (mesh, patches) in case.at(case.times[-1]).items():
        if name == "defaultRegion":
            continue
        for patch, data in patches.items():
            mapper = vtk.vtkPolyDataMapper()
            mapper.SetInputData(data)
            actor = vtk.vtkActor()
            actor.SetMapper(mapper)
            if name == "fluid":
                actor.GetProperty().SetRepresentationToWireframe()
            actor.GetProperty().SetColor(0.2, 0.4, 0.7)
            renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(500, 400)
    window.AddRenderer(renderer)
    renderer.GetActiveCamera().Azimuth(30)
    renderer.ResetCamera()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    ink = np.mean(np.any(pixels[:, :3] < 200, axis=1))
    print(f"{100*ink:.0f} % of the picture is drawn")
    if ink < 0.02:
        fail("the picture is empty")


COMMANDS = {"regions": regions, "fields": fields, "newMesh": new_mesh, "drawn": drawn}
COMMANDS[sys.argv[1]](*sys.argv[2:])
