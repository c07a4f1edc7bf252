#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a case: the mesh cut open, coloured by a field, and the bodies.

The cut is crinkled: whole cells, so that the tetrahedra show. What lies
behind the plane stays, the bodies stay whole with their triangles. An elastic
body (--region) may be shown deformed (--warp), inside the outline it had before.
Writes the VTK files it needs with foamToVTK and removes them.

Without a display run it as
    xvfb-run -a /usr/bin/python3 picture.py CASE --bodies tumourCell \\
        --normal 0 0 1 --output picture.png
"""

import argparse
import json
import os
import shutil
import subprocess
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

BODY_COLOURS = ["#E8A33D", "#5FB3D9", "#D98CB3", "#7FBF7B", "#C9C9C9"]
SCRATCH = "pictureVTK"


def arguments(argv):
    p = argparse.ArgumentParser(
        description=__doc__.split("\n\n")[0],
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    p.add_argument("case", help="folder of the case")
    p.add_argument("--region", default="fluid", help="region; '' for a case without")
    p.add_argument("--time", default="latest", help="a time, or latest")
    p.add_argument("--field", default="U", help="field of the colours")
    p.add_argument("--component", help="of the field, as zz; default: magnitude")
    p.add_argument("--warp", type=float, metavar="FACTOR",
                   help="move the points by this times D")
    p.add_argument("--bodies", nargs="*", default=[], help="patches drawn whole")
    p.add_argument("--normal", nargs=3, type=float, default=[0, 0, 1],
                   help="of the cut, towards the viewer")
    p.add_argument("--origin", nargs=3, type=float,
                   help="of the cut; default: middle of the bodies or the mesh")
    p.add_argument("--within", type=float, help="show only cells nearer to the "
                   "origin of the cut, in each direction")
    p.add_argument("--up", nargs=3, type=float, help="direction up on the page")
    p.add_argument("--tilt", nargs=2, type=float, default=[18, 20],
                   metavar=("RIGHT", "ABOVE"),
                   help="degrees of the viewer off the normal")
    p.add_argument("--zoom", type=float, default=1, help="above 1 is closer")
    p.add_argument("--focus", nargs=3, type=float,
                   help="point in the middle of the page; default: of the scene")
    p.add_argument("--range", nargs=2, type=float, help="of the colours")
    p.add_argument("--scale", type=float, default=1, help="factor on the field")
    p.add_argument("--unit", default="µm/µs", help="unit of the scaled field")
    p.add_argument("--label", help="of the colour bar; default: by the field")
    p.add_argument("--time-unit", default="µs", help="'' hides the time")
    p.add_argument("--title", default="", help="in front of the time")
    p.add_argument("--streamlines", type=int, default=0, help="how many")
    p.add_argument("--no-edges", action="store_true", help="hide the mesh")
    p.add_argument("--size", nargs=2, type=int, default=[1500, 900])
    p.add_argument("--output", default="picture.png")
    return p.parse_args(argv)


# Data

def convert(options):
    """Run foamToVTK; returns the folder of the VTK files and the time."""
    scratch = os.path.join(options.case, SCRATCH)
    shutil.rmtree(scratch, ignore_errors=True)
    fields = options.field if options.warp is None else f"{options.field} D"
    command = ["foamToVTK", "-case", options.case, "-name", SCRATCH,
               "-fields", f"({fields})"]
    if options.region:
        command += ["-region", options.region]
    if options.time == "latest":
        command += ["-latestTime"]
    else:
        command += ["-time", options.time]
    processors = decomposed(options)
    if processors:
        command = ["mpirun", "-np", str(processors)] + command + ["-parallel"]
    if "WM_PROJECT_DIR" not in os.environ:
        sys.exit("picture: source fsbiFoam's etc/bashrc first")
    run = subprocess.run(command, capture_output=True, text=True)
    series = os.path.join(scratch, options.region)
    names = [n for n in (os.listdir(series) if os.path.isdir(series) else [])
             if n.endswith(".vtm.series")]
    if run.returncode or not names:
        sys.exit("picture: foamToVTK failed:\n" + (run.stdout + run.stderr)[-1500:])
    with open(os.path.join(series, names[0])) as file:
        entry = json.load(file)["files"][-1]
    return os.path.join(series, entry["name"][: -len(".vtm")]), entry["time"]


def latest(folder):
    """The latest time folder as a number, -1 if there is none."""
    def number(name):
        try:
            return float(name)
        except ValueError:
            return -1.0
    return max(map(number, os.listdir(folder)), default=-1.0)


def decomposed(options):
    """How many processor folders hold times that the case folder lacks."""
    folders = [n for n in os.listdir(options.case) if n.startswith("processor")]
    if not folders:
        return 0
    newest = latest(os.path.join(options.case, "processor0"))
    return len(folders) if newest > latest(options.case) else 0


def read(reader, path):
    if not os.path.isfile(path):
        folder = os.path.dirname(path)
        there = sorted(n.split(".")[0] for n in os.listdir(folder))
        sys.exit(f"picture: there is no {os.path.basename(path)}; "
                 f"there are {', '.join(there)}")
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}


def at_points(data, field):
    """The values of a field at the points."""
    array = data.GetPointData().GetArray(field)
    if array is None:
        smooth = vtk.vtkCellDataToPointData()
        smooth.SetInputData(data)
        smooth.Update()
        array = smooth.GetOutput().GetPointData().GetArray(field)
    if array is None:
        sys.exit(f"picture: there is no field '{field}'")
    return vtk_to_numpy(array)


def colour_by(data, field, component, scale):
    """Add the scaled component or magnitude of the field at the points as
    'shown'."""
    values = at_points(data, field)
    if component:
        names = COMPONENTS.get(values.shape[-1] if values.ndim > 1 else 1, [])
        if component not in names:
            sys.exit(f"picture: '{field}' has no component '{component}'; "
                     f"there are {', '.join(names) or 'none'}")
        values = values[:, names.index(component)]
    elif values.ndim > 1:
        values = np.linalg.norm(values, axis=1)
    shown = numpy_to_vtk(scale * values, deep=True)
    shown.SetName("shown")
    data.GetPointData().SetScalars(shown)


# Geometry

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


def near(mesh, origin, distance):
    """The cells in the cube around the origin."""
    box = vtk.vtkBox()
    box.SetBounds(*(o + s * distance for o in origin for s in (-1, 1)))
    cells = vtk.vtkExtractGeometry()
    cells.SetInputData(mesh)
    cells.SetImplicitFunction(box)
    cells.ExtractInsideOn()
    cells.Update()
    return cells.GetOutput()


def crinkled(mesh, origin, normal):
    """The outer faces of all cells behind the plane or cut by it."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cells = vtk.vtkExtractGeometry()
    cells.SetInputData(mesh)
    cells.SetImplicitFunction(plane)
    cells.ExtractInsideOn()
    cells.ExtractBoundaryCellsOn()
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(cells.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def streamlines(mesh, field, count, origin, normal, up):
    """Tubes from a line of seeds just before the cut."""
    bounds = np.array(mesh.GetBounds()).reshape(3, 2)
    size = bounds[:, 1] - bounds[:, 0]
    reach = 0.48 * abs(np.dot(size, np.abs(up)))
    start = np.array(origin) + 0.1 * np.max(size) * normal
    centre = start + up * np.dot(middle(mesh) - start, up)
    seeds = vtk.vtkLineSource()
    seeds.SetPoint1(centre - reach * up)
    seeds.SetPoint2(centre + reach * up)
    seeds.SetResolution(max(count - 1, 1))
    mesh.GetPointData().SetActiveVectors(field)
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(mesh)
    tracer.SetSourceConnection(seeds.GetOutputPort())
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetMaximumPropagation(20 * np.max(size))
    tracer.SetIntegratorTypeToRungeKutta45()
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputConnection(tracer.GetOutputPort())
    tubes.SetRadius(0.0022 * np.max(size))
    tubes.SetNumberOfSides(10)
    tubes.Update()
    return tubes.GetOutput()


# Rendering

def rgb(code):
    return tuple(int(code[i:i + 2], 16) / 255 for i in (1, 3, 5))


def actor(data, colour=None, edges=None, width=1.0, table=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    if table is None:
        mapper.ScalarVisibilityOff()
    else:
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    a = vtk.vtkActor()
    a.SetMapper(mapper)
    look = a.GetProperty()
    look.SetAmbient(0.5)
    look.SetDiffuse(0.55)
    look.SetLineWidth(width)
    if colour:
        look.SetColor(rgb(colour))
        look.SetSpecular(0.12)
        look.SetSpecularPower(25)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(rgb(edges))
    return a


def lookup_table(colours, bounds):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *colours(i))
    table.SetRange(*bounds)
    table.Build()
    return table


def directions(options):
    """Unit vectors: towards the viewer's side of the cut, and up."""
    normal = np.array(options.normal) / np.linalg.norm(options.normal)
    if options.up:
        up = np.array(options.up)
    else:
        up = np.array([0, 1, 0]) if abs(normal[1]) < 0.7 else np.array([0, 0, 1])
    up = up - np.dot(up, normal) * normal
    return normal, up / np.linalg.norm(up)


def camera(renderer, target, normal, up, options):
    view = renderer.GetActiveCamera()
    view.SetFocalPoint(target)
    view.SetPosition(target + normal)
    view.SetViewUp(up)
    view.SetViewAngle(14)
    view.Azimuth(options.tilt[0])
    view.Elevation(options.tilt[1])
    renderer.ResetCamera()
    if options.focus:
        shift = np.array(options.focus) - view.GetFocalPoint()
        view.SetPosition(view.GetPosition() + shift)
        view.SetFocalPoint(options.focus)
    view.Zoom(1.25 * options.zoom)
    renderer.ResetCameraClippingRange()


def render(renderer, size):
    """The scene as an array of pixels, smoothed."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    nx, ny, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(ny, nx, -1)[::-1]


def trim(pixels, margin=12):
    """Without the white around the scene."""
    ink = np.any(pixels[:, :, :3] < 250, axis=2)
    rows, columns = np.flatnonzero(ink.any(1)), np.flatnonzero(ink.any(0))
    if not len(rows):
        sys.exit("picture: the rendered scene is empty")
    pixels = pixels[max(rows[0] - margin, 0):rows[-1] + margin,
                    max(columns[0] - margin, 0):columns[-1] + margin, :3]
    side = max(0, 800 - pixels.shape[1]) // 2
    return np.pad(pixels, ((0, 0), (side, side), (0, 0)), constant_values=255)


def page(pixels, bounds, colours, options, time):
    """The scene with title and colour bar."""
    from fsbi import plots
    plt = plots.plt

    height, width = pixels.shape[:2]
    dpi = 150
    total = (width / dpi, height / dpi + 1.15)
    figure = plt.figure(figsize=total, dpi=dpi)
    scene = figure.add_axes([0, 0.7 / total[1], 1, height / dpi / total[1]])
    scene.imshow(pixels, interpolation="none", aspect="auto")
    scene.axis("off")
    title = options.title
    if options.time_unit:
        title = ", ".join(filter(None, [title, f"t = {time:g} {options.time_unit}"]))
    figure.text(0.02, 1 - 0.14 / total[1], title, va="top", fontsize=13)
    bar = figure.add_axes([0.4, 0.5 / total[1], 0.52, 0.13 / total[1]])
    norm = plots.matplotlib.colors.Normalize(*bounds)
    scale = figure.colorbar(
        plots.matplotlib.cm.ScalarMappable(norm, colours), cax=bar,
        orientation="horizontal")
    scale.outline.set_linewidth(0.5)
    bar.tick_params(labelsize=9, length=3)
    label = options.label or {"U": "velocity magnitude", "p": "pressure",
                              "D": "displacement magnitude"}.get(
                                  options.field, options.field)
    figure.text(0.38, 0.565 / total[1], f"{label} ({options.unit})", ha="right",
                va="center", fontsize=10)
    folder = os.path.dirname(options.output)
    os.makedirs(folder or ".", exist_ok=True)
    figure.savefig(options.output)
    plots._shrink(options.output, 400_000)


def draw(options):
    from fsbi import plots
    colours = plots.matplotlib.colormaps["viridis"]

    files, time = convert(options)
    mesh = read(vtk.vtkXMLUnstructuredGridReader(),
                os.path.join(files, "internal.vtu"))
    bodies = [read(vtk.vtkXMLPolyDataReader(),
                   os.path.join(files, "boundary", f"{b}.vtp"))
              for b in options.bodies]
    shutil.rmtree(os.path.join(options.case, SCRATCH), ignore_errors=True)

    colour_by(mesh, options.field, options.component, options.scale)
    before = outline(mesh)
    if options.warp is not None:
        warp(mesh, options.warp)
    normal, up = directions(options)
    origin = options.origin or (
        np.mean([middle(b) for b in bodies], axis=0) if bodies else middle(mesh))
    if options.within:
        mesh = near(mesh, origin, options.within)
    cut = crinkled(mesh, origin, normal)
    bounds = options.range or cut.GetPointData().GetScalars().GetRange()

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor(cut, edges=None if options.no_edges else "#2b2b3a",
                            width=0.8, table=lookup_table(colours, bounds)))
    if options.warp is not None:
        renderer.AddActor(actor(before, "#777777", width=1.5))
    for i, body in enumerate(bodies):
        renderer.AddActor(actor(body, BODY_COLOURS[i % 5],
                                None if options.no_edges else "#5a3a10"))
    if options.streamlines:
        lines = streamlines(mesh, options.field, options.streamlines,
                            origin, normal, up)
        renderer.AddActor(actor(lines, "#E4E4E4"))
    camera(renderer, middle(cut), normal, up, options)
    page(trim(render(renderer, options.size)), bounds, colours, options, time)
    print(f"    {options.output}")


if __name__ == "__main__":
    draw(arguments(sys.argv[1:]))
