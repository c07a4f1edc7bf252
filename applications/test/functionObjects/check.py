# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Output of function objects against the saved states, as ParaView's reader has
them, at every saved time. check.py CHECK CASE [CASE]"""

import glob
import re
import sys

import numpy as np
import vtk

import vtk_case

STEPS = 9
# bound: six digits of the output, single precision of the reader
DIGITS = 1e-5
RADIUS = 8                  # of the sphere


def fail(text):
    raise SystemExit(text)


def near(what, value, reference, scale, bound=DIGITS):
    error = np.max(np.abs(np.asarray(value) - reference)) / scale
    print(f"{what}: {error:.1e} of {scale:.3g}")
    if not error <= bound:
        fail(f"{what}: off by {error:.1e} of {scale:.3g}, bound {bound}")


def rows(path):
    """Numbers of every line that is no comment, by time; one file there is."""
    files = glob.glob(path)
    if len(files) != 1:
        fail(f"{len(files)} files {path}")
    with open(files[0]) as file:
        lines = [re.findall(r"(?<![\w.])[-+]?[\d.]+(?:e[-+]\d+)?", line)
                 for line in file if not line.startswith("#")]
    return [np.array(line, float) for line in lines if line]


def output(case, name, file="*", mesh="fluid"):
    return rows(f"{case}/postProcessing/{mesh}/{name}/*/{file}")


def probed(case, name, field):
    return rows(f"{case}/postProcessing/{name}/fluid/*/{field}")


def saved(folder):
    """Every saved time after the first, with its regions."""
    case = vtk_case.Case(folder)
    for time in case.times:
        if time > 0:
            yield time, case.at(time)


def at(table, time):
    return next(row[1:] for row in table if row[0] == time)


def lines(case):
    counts = {
        "points U": len(probed(case, "points", "U")),
        "points p": len(probed(case, "points", "p")),
        "range": len(output(case, "range")) // 2,
        "flow": len(output(case, "flow")),
        "skin": len(output(case, "skin")),
        "through": len(output(case, "through")),
        "cuts": len(glob.glob(f"{case}/postProcessing/cuts/*/U_middle.raw")),
        "lines": len(glob.glob(f"{case}/postProcessing/sets/lines/fluid/*/*.vtk")),
    }
    print(counts)
    wrong = {name: n for name, n in counts.items() if n != STEPS}
    if wrong or len(probed(case, "late", "U")) != 4:
        fail(f"not one line a step: {wrong}")


def in_cells(mesh, points, field):
    """Values of the cells that hold the points."""
    locator = vtk.vtkCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    return vtk_case.cells(mesh, field)[[locator.FindCell(p) for p in points]]


def probes(case, name="points", places=((20.3, 31.7, 104.2), (100.1, 90.7, 20.4),
                                        (60.2, 60.4, 72.3))):
    table = probed(case, name, "U")
    for time, regions in saved(case):
        if time < table[0][0]:
            continue
        u = in_cells(regions["fluid"][0], places, "U")
        near(f"U at {time:g}", at(table, time).reshape(-1, 3), u, 6e-3)


def late(case):
    probes(case, "late", ((100.1, 90.7, 20.4),))


def everywhere(region, field):
    mesh, patches = region
    return np.concatenate([vtk_case.cells(mesh, field)]
                          + [vtk_case.cells(p, field) for p in patches.values()])


def extremes(case, region="fluid", fields=("U", "p")):
    table = output(case, "range", mesh=region)
    for time, regions in saved(case):
        found = [row[1:] for row in table if row[0] == time]
        for field, row in zip(fields, found):
            values = everywhere(regions[region], field)
            if values.ndim > 1:
                values = np.linalg.norm(values, axis=1)
            scale = np.abs(values).max()
            # row: least, where, most, where
            near(f"min {field} at {time:g}", row[0], values.min(), scale)
            near(f"max {field} at {time:g}", row[4], values.max(), scale)


def volume(case):
    table = output(case, "flow")
    for time, regions in saved(case):
        mesh = regions["fluid"][0]
        flow = vtk_case.volumes(mesh) @ vtk_case.cells(mesh, "U")
        near(f"flow at {time:g}", at(table, time), flow, np.abs(flow).max())


def area(polygons):
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(polygons)
    size.Update()
    return vtk_case.cells(size.GetOutput(), "Area")


def cut_by(mesh, origin, normal):
    plane = vtk.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(mesh)
    cutter.Update()
    return cutter.GetOutput()


def areas(case):
    skin, through = output(case, "skin"), output(case, "through")
    for time, regions in saved(case):
        mesh, patches = regions["fluid"]
        A = area(patches["tumourCell"])
        mean = A @ vtk_case.cells(patches["tumourCell"], "U") / A.sum()
        values = at(skin, time)
        near(f"area of the body at {time:g}", values[0], A.sum(), A.sum())
        near(f"U on it at {time:g}", values[1:], mean, np.abs(mean).max())
        cut = cut_by(mesh, (90, 60, 60), (1, 0, 0))
        flow = area(cut) @ vtk_case.cells(cut, "U")
        near(f"flow through x = 90 at {time:g}", at(through, time), flow,
             np.abs(flow).max(), 10 * DIGITS)


def cut(case):
    for time, regions in saved(case):
        values = np.loadtxt(f"{case}/postProcessing/cuts/{time:g}/U_middle.raw")
        mesh = regions["fluid"][0]
        u = vtk_case.cells(mesh, "U")
        own = np.array([np.argmin(np.abs(u - row).max(axis=1)) for row in values[:, 3:]])
        near(f"U on {len(own)} faces at {time:g}", values[:, 3:], u[own], 6e-3)
        # the middle of a face lies in the cell whose velocity it has: no
        # barycentric coordinate is below zero, but for the digits of the output
        x = vtk_case.points(mesh)[vtk_case.corners(mesh)[own]]
        ones = np.ones((len(own), 4, 1))
        inside = np.linalg.solve(
            np.moveaxis(np.concatenate([x, ones], axis=2), 1, 2),
            np.concatenate([values[:, :3], ones[:, 0]], axis=1)[..., None])
        print(f"least barycentric coordinate {inside.min():.1e}")
        if len(own) < 100 or inside.min() < -1e-3:
            fail(f"{len(own)} faces at {time:g}, outside by {inside.min():.1e}")


def tracks(case):
    for file in glob.glob(f"{case}/postProcessing/sets/lines/fluid/*/*.vtk"):
        reader = vtk.vtkPolyDataReader()
        reader.SetFileName(file)
        reader.Update()
        data = reader.GetOutput()
        if data.GetNumberOfLines() != 5:
            fail(f"{data.GetNumberOfLines()} tracks in {file}")
        x = vtk_case.points(data)
        ids = vtk.vtkIdList()
        for line in range(5):
            data.GetCellPoints(line, ids)
            way = x[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
            # bound: a track through the domain ends at its end; the sphere, four
            # radii away, turns it by less than (radius/distance)^2
            near("start", way[0, 0], 5, 120)
            near("end", way[-1, 0], 120, 120, 0.01)
            near("height", way[:, 2], way[0, 2], 120, 1 / 16)


def mean(case):
    for time, regions in saved(case):
        mesh = regions["fluid"][0]
        x = vtk_case.centres(mesh)
        far = np.linalg.norm(x - 60, axis=1) > 6 * RADIUS
        u, average = (vtk_case.cells(mesh, f)[far] for f in ("U", "UMean"))
        # bound: what cells that move could see is what the sphere does there:
        # 2.5 (a/r)^2 a G/2 by the shear, 0.5 % of the fastest, and w (a/r)^2 a
        # by its spin, 0.5 %. Values of nearest cells alone would be off by their
        # distance times the gradient, 5 %
        near(f"mean at {time:g}", average, u, 3e-3, 0.01)


def same(case, other):
    # bound: the solver's tolerance of 1e-10, amplified by round-off in the mesh;
    # tables have six digits
    for name in ("flow", "skin", "through"):
        a, b = (np.array(output(c, name)) for c in (case, other))
        for column in range(1, a.shape[1]):
            near(f"{name} {column}", a[:, column], b[:, column],
                 np.abs(a[:, 1:]).max(), 1e-4)
    for field in "U", "p":
        a, b = (np.array(probed(c, "points", field))[:, 1:] for c in (case, other))
        near(f"probes {field}", a, b, np.abs(a).max(), 1e-4)


def continued(case, other):
    a, b = (vtk_case.Case(c) for c in (case, other))
    last = a.times[-1]
    a, b = (vtk_case.cells(c.at(last)["fluid"][0], "UMean") for c in (a, b))
    near("mean at the end", b, a, 6e-3, 1e-6)


def elastic(case):
    extremes(case, "cell", ("D",))
    around = output(case, "around")
    volume = output(case, "volume", mesh="cell")
    for time, regions in saved(case):
        mesh, patches = regions["cell"]
        surface = patches["cell"]
        moved = vtk_case.points(surface) + vtk_case.vertices(surface, "pointD")
        a, b, c = np.moveaxis(moved[vtk_case.corners(surface)], 1, 0)
        A = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
        near(f"area in the fluid at {time:g}", at(around, time)[0], A, A)
        x = vtk_case.points(mesh) + vtk_case.vertices(mesh, "pointD")
        a, b, c, d = np.moveaxis(x[vtk_case.corners(mesh)], 1, 0)
        V = np.abs(np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a))) / 6
        D = vtk_case.cells(mesh, "D")
        near(f"integral of D at {time:g}", at(volume, time), V @ D,
             V @ np.linalg.norm(D, axis=1))


globals()[sys.argv[1]](*sys.argv[2:])
