#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a case: the mesh cut open, coloured by a field, and the bodies.

The cut is crinkled: whole cells, so that the tetrahedra show; or flat. What lies
behind the plane stays, the bodies stay whole with their triangles. An elastic
body (--region) may be shown deformed (--warp), inside the outline it had before.
Bonds (--bonds) are lines coloured by their tension, the magnetic field (--B) is
arrows on the cut. Writes the VTK files it needs with foamToVTK and removes them.

Without a display run it as
    xvfb-run -a /usr/bin/python3 picture.py CASE --bodies tumourCell \\
        --normal 0 0 1 --output picture.png
"""

import argparse
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from fsbi import cuts, pictures, vtk_files

BODY_COLOURS = ["#E8A33D", "#5FB3D9", "#D98CB3", "#7FBF7B", "#C9C9C9"]


def options_of(program):
    """The options; a movie has the same."""
    p = argparse.ArgumentParser(
        prog=program,
        description=__doc__.split("\n\n")[0],
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    p.add_argument("-help", action="help", help=argparse.SUPPRESS)
    p.add_argument("case", help="folder of the case")
    p.add_argument("--region", default="fluid", help="region; '' for a case without")
    p.add_argument("--time", default="latest", help="a time, or latest")
    p.add_argument("--field", default="U", help="field of the colours")
    p.add_argument("--component", help="of the field, as zz; default: magnitude")
    p.add_argument("--warp", type=float, metavar="FACTOR",
                   help="move the points by this times D")
    p.add_argument("--bodies", nargs="*", default=[], help="patches drawn whole")
    p.add_argument("--body-field", help="of the patches, colours the bodies")
    p.add_argument("--body-range", nargs=2, type=float, help="of these colours")
    p.add_argument("--body-label", help="of their bar, with the unit; default: the field")
    p.add_argument("--normal", nargs=3, type=float, default=[0, 0, 1],
                   help="of the cut, towards the viewer")
    p.add_argument("--origin", nargs=3, type=float,
                   help="of the cut; default: middle of the bodies or the mesh")
    p.add_argument("--within", type=float, help="show only what is nearer to the "
                   "origin of the cut, in each direction; cut flat")
    p.add_argument("--flat", action="store_true", help="cut cells in two")
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
    p.add_argument("--bonds", action="store_true",
                   help="bonds, coloured by their tension")
    p.add_argument("--bond-width", type=float, default=1, help="above 1 is thicker")
    p.add_argument("--bond-range", type=float, help="largest tension of the colours, scaled")
    p.add_argument("--bond-scale", type=float, default=1000, help="factor on the tension")
    p.add_argument("--bond-unit", default="pN", help="unit of the scaled tension")
    p.add_argument("--B", action="store_true",
                   help="arrows of the magnetic field of all but the bodies")
    p.add_argument("--see-through", type=float, default=1, metavar="OPACITY",
                   help="of the bodies, 0 to 1")
    p.add_argument("--no-cut", action="store_true", help="bodies and bonds only")
    p.add_argument("--no-edges", action="store_true", help="hide the mesh")
    p.add_argument("--size", nargs=2, type=int, default=[1500, 900])
    p.add_argument("--output", default="picture.png")
    return p


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


def place(renderer, view, shift):
    """Where another scene's camera stands, moved."""
    mine = renderer.GetActiveCamera()
    mine.DeepCopy(view)
    mine.SetPosition(np.add(view.GetPosition(), shift))
    mine.SetFocalPoint(np.add(view.GetFocalPoint(), shift))


def render(renderers, size):
    """The scene as an array of pixels, smoothed."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.SetNumberOfLayers(len(renderers))
    for renderer in renderers:
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


def ink(pixels, margin=12):
    """The box of what is not white: top, bottom, left, right."""
    there = np.any(pixels[:, :, :3] < 250, axis=2)
    rows, columns = np.flatnonzero(there.any(1)), np.flatnonzero(there.any(0))
    if not len(rows):
        raise ValueError("the rendered scene is empty")
    return (max(rows[0] - margin, 0), rows[-1] + margin,
            max(columns[0] - margin, 0), columns[-1] + margin)


def trim(pixels, box):
    """Without the white around the box, at least 800 wide."""
    pixels = pixels[box[0]:box[1], box[2]:box[3], :3]
    side = max(0, 800 - pixels.shape[1]) // 2
    return np.pad(pixels, ((0, 0), (side, side), (0, 0)), constant_values=255)


def page(pixels, bars, options, title):
    """The scene with its title and colour bars: (label, bounds, colours) of each."""
    from fsbi import plots
    plt = plots.plt

    height, width = pixels.shape[:2]
    dpi = 150
    foot = 0.1 + 0.6 * len(bars)
    total = (width / dpi, height / dpi + 0.45 + foot)
    figure = plt.figure(figsize=total, dpi=dpi)
    scene = figure.add_axes([0, foot / total[1], 1, height / dpi / total[1]])
    scene.imshow(pixels, interpolation="none", aspect="auto")
    scene.axis("off")
    figure.text(0.02, 1 - 0.14 / total[1], title, va="top", fontsize=13)
    for i, (label, bounds, colours) in enumerate(bars):
        y = foot - 0.2 - 0.6 * i
        bar = figure.add_axes([0.4, y / total[1], 0.52, 0.13 / total[1]])
        norm = plots.matplotlib.colors.Normalize(*bounds)
        scale = figure.colorbar(
            plots.matplotlib.cm.ScalarMappable(norm, colours), cax=bar,
            orientation="horizontal")
        scale.outline.set_linewidth(0.5)
        bar.tick_params(labelsize=9, length=3)
        figure.text(0.38, (y + 0.065) / total[1], label, ha="right", va="center", fontsize=10)
    pictures.save(figure, options.output, 400_000)


def title_of(options, time, largest_B):
    parts = [options.title]
    if options.time_unit:
        parts.append(f"t = {time:g} {options.time_unit}")
    if largest_B is not None:
        parts.append(f"arrows: B up to {1e3 * largest_B:.3g} mT")
    return ", ".join(filter(None, parts))


class Scene:
    """What a state is drawn of."""

    def __init__(self, options, state):
        self.options = options
        self.time = state.time
        self.mesh = state.mesh()
        self.bodies = [state.patch(b) for b in options.bodies]
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.front = vtk.vtkRenderer()          # drawn over all else
        self.front.SetLayer(1)
        self.front.SetActiveCamera(self.renderer.GetActiveCamera())
        self.bars = []
        self.largest_B = None
        self.normal, self.up = directions(options)
        self.origin = np.array(options.origin or (
            np.mean([cuts.middle(b) for b in self.bodies], axis=0)
            if self.bodies else cuts.middle(self.mesh)))

    def add(self, data, *arguments, **looks):
        made = actor(data, *arguments, **looks)
        self.renderer.AddActor(made)
        return made

    def fill(self):
        """Add all that is asked for; returns what the camera looks at."""
        o = self.options
        target = self._bodies_only() if o.no_cut else self._cut()
        table = self._body_colours() if o.body_field and self.bodies else None
        for i, body in enumerate(self.bodies):
            shown = self.add(cuts.outwards(body), BODY_COLOURS[i % 5],
                             None if o.no_edges else "#5a3a10", table=table)
            if o.see_through < 1:
                shown.GetProperty().SetOpacity(o.see_through)
                shown.GetProperty().BackfaceCullingOn()
        if o.streamlines:
            self.add(cuts.streamlines(self.mesh, o.field, o.streamlines, self.origin,
                                      self.normal, self.up, target.GetBounds()), "#E4E4E4")
        if o.bonds:
            self._bonds(target)
        if o.B:
            self._field(target)
        return cuts.middle(target)

    def _body_colours(self):
        from fsbi import plots
        o = self.options
        for body in self.bodies:
            cuts.colour_by(body, o.body_field, None, 1)
        ranges = [b.GetPointData().GetScalars().GetRange() for b in self.bodies]
        bounds = o.body_range or (min(r[0] for r in ranges), max(r[1] for r in ranges))
        colours = plots.matplotlib.colormaps["inferno"]
        self.bars.append((o.body_label or o.body_field, bounds, colours))
        return lookup_table(colours, bounds)

    def _bodies_only(self):
        join = vtk.vtkAppendPolyData()
        for body in self.bodies:
            join.AddInputData(body)
        join.Update()
        return join.GetOutput()

    def _cut(self):
        from fsbi import plots
        o = self.options
        colours = plots.matplotlib.colormaps["viridis"]
        cuts.colour_by(self.mesh, o.field, o.component, o.scale)
        before = cuts.outline(self.mesh)
        if o.warp is not None:
            cuts.warp(self.mesh, o.warp)
        if o.flat or o.within:
            cut = cuts.flat(self.mesh, self.origin, self.normal, o.within)
        else:
            cut = cuts.crinkled(self.mesh, self.origin, self.normal)
        bounds = o.range or cut.GetPointData().GetScalars().GetRange()
        self.add(cut, edges=None if o.no_edges else "#2b2b3a", width=0.8,
                 table=lookup_table(colours, bounds))
        if o.warp is not None:
            self.add(before, "#777777", width=1.5)
        label = o.label or {"U": "velocity magnitude", "p": "pressure",
                            "D": "displacement magnitude"}.get(o.field, o.field)
        self.bars.append((f"{label} ({o.unit})", bounds, colours))
        return cut

    def _bonds(self, target):
        from fsbi import plots
        o = self.options
        bonds = vtk_files.saved_drawing(o.case, self.time, "bonds.vtk")
        if bonds is None:
            raise ValueError(f"there is no uniform/bonds.vtk in the state of time {self.time:g}")
        reach = o.bond_range or cuts.largest_tension(bonds) * o.bond_scale
        if not reach > 0:
            return
        colours = plots.matplotlib.colormaps["coolwarm"]
        if bonds.GetNumberOfLines():
            width = 0.0012 * o.bond_width / o.zoom * target.GetLength()
            self.add(cuts.bond_tubes(bonds, width, o.bond_scale),
                     table=lookup_table(colours, (-reach, reach)))
        self.bars.append((f"tension of bonds ({o.bond_unit})", (-reach, reach), colours))

    def _field(self, target):
        grid = vtk_files.saved_drawing(self.options.case, self.time, "B.vtk")
        if grid is None:
            raise ValueError(f"there is no uniform/B.vtk in the state of time {self.time:g}")
        drawn, self.largest_B = cuts.arrows(grid, self.origin, self.normal, self.up,
                                            target.GetBounds())
        self.front.AddActor(actor(drawn, "#F0425C"))


def view_of(options, state):
    """The camera of a state's picture."""
    scene = Scene(options, state)
    camera(scene.renderer, scene.fill(), scene.normal, scene.up, options)
    return scene.renderer.GetActiveCamera()


def drawn(options, state, view=None, shift=0):
    """(pixels, colour bars, title) of a state; view: with this camera, moved."""
    scene = Scene(options, state)
    target = scene.fill()
    if view is None:
        camera(scene.renderer, target, scene.normal, scene.up, options)
    else:
        place(scene.renderer, view, shift)
    scene.renderer.ResetCameraClippingRange()
    return (render([scene.renderer, scene.front], options.size), scene.bars,
            title_of(options, scene.time, scene.largest_B))


def fields_of(options):
    return " ".join(filter(None, (options.field, options.body_field,
                                  None if options.warp is None else "D")))


def main():
    options = options_of("picture").parse_args()
    try:
        with vtk_files.VTKFiles(options.case, options.region, fields_of(options),
                                options.time) as states:
            pixels, bars, title = drawn(options, states[-1])
        page(trim(pixels, ink(pixels)), bars, options, title)
    except (vtk_files.NoStates, ValueError) as error:
        sys.exit(f"picture: {error}")
    print(f"    {options.output}")


if __name__ == "__main__":
    main()
