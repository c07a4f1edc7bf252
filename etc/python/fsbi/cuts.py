# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts, lines and arrows of VTK data for pictures."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}


def at_points(data, field):
    """The values of a field at the points."""
    array = smooth(data, field).GetPointData().GetArray(field)
    if array is None:
        raise ValueError(f"there is no field '{field}'")
    return vtk_to_numpy(array)


def colour_by(data, field, component, scale):
    """Add the scaled component or magnitude of the field at the points as
    'shown'."""
    values = at_points(data, field)
    if component:
        names = COMPONENTS.get(values.shape[-1] if values.ndim > 1 else 1, [])
        if component not in names:
            raise ValueError(f"'{field}' has no component '{component}'; "
                             f"there are {', '.join(names) or 'none'}")
        values = values[:, names.index(component)]
    elif values.ndim > 1:
        values = np.linalg.norm(values, axis=1)
    shown = numpy_to_vtk(scale * values, deep=True)
    shown.SetName("shown")
    data.GetPointData().SetScalars(shown)


def middle(data):
    b = data.GetBounds()
    return np.array([(b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2])


def warp(data, factor):
    """Move the points by the displacement times a factor."""
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(
        vtk_to_numpy(data.GetPoints().GetData()) + factor * at_points(data, "D"),
        deep=True))
    data.SetPoints(points)


def outwards(surface):
    """A closed surface of triangles with its faces turned outwards: the patch of
    a fluid is the other way round."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    faces = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    if len(faces) != 3 * surface.GetNumberOfPolys():
        return surface
    a, b, c = (points - points.mean(axis=0))[faces.reshape(-1, 3)].transpose(1, 0, 2)
    if np.einsum("ij,ij->", a, np.cross(b, c)) > 0:
        return surface
    turned = vtk.vtkReverseSense()
    turned.SetInputData(surface)
    turned.Update()
    return turned.GetOutput()


def outline(mesh):
    """The sharp edges of a mesh."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetFeatureAngle(60)
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def crinkled(mesh, origin, normal):
    """The outer faces of all cells behind the plane or cut by it."""
    cells = vtk.vtkExtractGeometry()
    cells.SetInputData(mesh)
    cells.SetImplicitFunction(_plane(origin, normal))
    cells.ExtractInsideOn()
    cells.ExtractBoundaryCellsOn()
    return _surface(cells)


def flat(mesh, origin, normal, within=None):
    """The outside of what lies behind the plane, where cells are cut in two;
    within: only of what is in a cube around the origin, with sides as smooth."""
    part = vtk.vtkTrivialProducer()
    part.SetOutput(mesh)
    sides = [(origin, normal)]
    if within:
        sides += [(origin + within * axis, axis) for axis in np.vstack((np.eye(3), -np.eye(3)))]
    for place, axis in sides:
        cut = vtk.vtkTableBasedClipDataSet()
        cut.SetInputConnection(part.GetOutputPort())
        cut.SetClipFunction(_plane(place, axis))
        cut.InsideOutOn()
        part = cut
    return _surface(part)


def _plane(origin, normal):
    plane = vtk.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


def _surface(cells):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(cells.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def streamlines(mesh, field, count, origin, normal, up, bounds):
    """Tubes from a line of seeds through the origin, just before the cut, as far
    as the box of what is shown."""
    low, high = np.array(bounds).reshape(3, 2).T
    size = max(high - low)
    middle_of_seeds = origin + 0.02 * size * normal
    middle_of_seeds += up * np.dot((low + high) / 2 - middle_of_seeds, up)
    reach = 0.48 * np.dot(high - low, np.abs(up)) * up
    seeds = vtk.vtkLineSource()
    seeds.SetPoint1(middle_of_seeds - reach)
    seeds.SetPoint2(middle_of_seeds + reach)
    seeds.SetResolution(max(count - 1, 1))
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(smooth(mesh, field))
    tracer.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, field)
    tracer.SetSourceConnection(seeds.GetOutputPort())
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetMaximumPropagation(4 * size)
    tracer.SetIntegratorTypeToRungeKutta45()
    box = vtk.vtkBox()
    ahead = 0.3 * size * normal                 # what passes before the cut shows, too
    box.SetBounds(*np.column_stack((np.minimum(low, low + ahead),
                                    np.maximum(high, high + ahead))).ravel())
    inside = vtk.vtkClipPolyData()
    inside.SetInputConnection(tracer.GetOutputPort())
    inside.SetClipFunction(box)
    inside.InsideOutOn()
    return tubes(inside, 0.0022 * size)


def smooth(data, field):
    """The same data with the field at its points."""
    if data.GetPointData().GetArray(field):
        return data
    spread = vtk.vtkCellDataToPointData()
    spread.SetInputData(data)
    spread.PassCellDataOn()
    spread.Update()
    return spread.GetOutput()


def tubes(lines, radius):
    """Round ones around the lines that a filter makes."""
    made = vtk.vtkTubeFilter()
    made.SetInputConnection(lines.GetOutputPort())
    made.SetRadius(radius)
    made.SetNumberOfSides(10)
    made.CappingOn()
    made.Update()
    return made.GetOutput()


def largest_tension(bonds):
    tension = bonds.GetCellData().GetArray("tension")
    return np.abs(vtk_to_numpy(tension)).max(initial=0) if tension else 0


def bond_tubes(bonds, radius, scale):
    """Bonds as tubes coloured by their tension, scaled."""
    tension = vtk_to_numpy(bonds.GetCellData().GetArray("tension"))
    shown = numpy_to_vtk(scale * tension, deep=True)
    shown.SetName("shown")
    bonds.GetCellData().SetScalars(shown)
    source = vtk.vtkTrivialProducer()
    source.SetOutput(bonds)
    return tubes(source, radius)


def arrows(grid, origin, normal, up, bounds, count=13):
    """Arrows of the vectors B of a grid on the plane of the cut, the largest as
    long as their distance; and the largest length of B."""
    right = np.cross(up, normal)
    low, high = np.array(bounds).reshape(3, 2).T
    reach = 0.48 * max(abs(np.dot(high - low, d)) for d in (up, right))
    across = np.linspace(-reach, reach, count)
    points = vtk.vtkPoints()
    for a in across:
        for b in across:
            place = origin + a * right + b * up
            if (low <= place + 1e-3 * reach).all() and (place <= high + 1e-3 * reach).all():
                points.InsertNextPoint(place)
    places = vtk.vtkPolyData()
    places.SetPoints(points)
    probe = vtk.vtkProbeFilter()
    probe.SetInputData(places)
    probe.SetSourceData(grid)
    probe.Update()
    largest = np.linalg.norm(vtk_to_numpy(grid.GetPointData().GetArray("B")), axis=1).max()
    found = probe.GetOutput()
    found.GetPointData().SetActiveVectors("B")
    glyph = vtk.vtkGlyph3D()
    glyph.SetInputData(found)
    glyph.SetSourceData(_arrow())
    glyph.SetVectorModeToUseVector()
    glyph.SetScaleModeToScaleByVector()
    glyph.SetScaleFactor(1.6 * reach / (count - 1) / max(largest, 1e-300))
    glyph.Update()
    return glyph.GetOutput(), largest


def _arrow():
    arrow = vtk.vtkArrowSource()
    arrow.SetTipResolution(16)
    arrow.SetShaftResolution(12)
    arrow.SetShaftRadius(0.05)
    arrow.SetTipRadius(0.14)
    arrow.Update()
    return arrow.GetOutput()
