# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies, bonds and walls of a run in three dimensions, from the saved states.

Where all bodies keep their shapes they are shown at every step, by their
positions and orientations in the history, otherwise at the saved times; bonds
are known at the saved times. A body that enters or leaves is there while it is in
the domain.
"""

import base64
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

from .. import vtk_files
from .run import thinned

MAX_TIMES = 300
MAX_BYTES = 2_200_000           # of surfaces, before they become text
# distance of points of one shape, in its radii: the mesh stands where the body
# was expected at the end of a step, a little off from where the history has it
SAME = 0.05


class Surface:
    def __init__(self, data):
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputData(data)
        triangles.PassLinesOff()
        triangles.PassVertsOff()
        triangles.Update()
        flat = triangles.GetOutput()
        self.points = vtk_to_numpy(flat.GetPoints().GetData()).astype(float)
        self.faces = vtk_to_numpy(flat.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        # seen from outside: the patch of a fluid is the other way round
        a, b, c = (self.points[self.faces[:, i]] - self.points.mean(axis=0) for i in range(3))
        if np.einsum("ij,ij->", a, np.cross(b, c)) < 0:
            self.faces = self.faces[:, ::-1]

    @classmethod
    def of(cls, points, faces):
        made = cls.__new__(cls)
        made.points, made.faces = points, faces
        return made

    def distances(self, points):
        """Of points from the surface; its triangles may be others than theirs."""
        made = vtk.vtkPolyData()
        made.SetPoints(vtk.vtkPoints())
        made.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(self.points), deep=True))
        triangles = vtk.vtkCellArray()
        triangles.SetData(3, numpy_to_vtkIdTypeArray(
            np.ascontiguousarray(self.faces, np.int64).ravel(), deep=True))
        made.SetPolys(triangles)
        surface = vtk.vtkImplicitPolyDataDistance()
        surface.SetInput(made)
        found = vtk.vtkDoubleArray()
        surface.EvaluateFunction(numpy_to_vtk(np.ascontiguousarray(points), deep=True), found)
        return abs(vtk_to_numpy(found))

    def radius(self):
        return np.linalg.norm(self.points - self.points.mean(axis=0), axis=1).max()


def collect(case, run):
    """What the page's script draws, or {"missing": why}."""
    try:
        if os.path.isfile(os.path.join(case, "constant", "fluid", "material")):
            return _in_fluid(case, run)
        return _alone(case, run)
    except vtk_files.NoStates as error:
        return {"missing": str(error)}


def _in_fluid(case, run):
    with vtk_files.VTKFiles(case, fields="none", times="all", internal=False) as states:
        names = [name for _, name in run.bodies() or _recorded(run)]
        surfaces = {n: _present(n, states) for n in names}
        names = [n for n in names if any(surfaces[n])]
        if not names:
            return {"missing": "no body is in any saved state"}
        surfaces = {n: surfaces[n] for n in names}
        walls = [_walls(s, [surfaces[n][k] for n in names if surfaces[n][k]], names)
                 for k, s in enumerate(states)]
    times = [state.time for state in states]
    bonds = [vtk_files.saved_drawing(case, t, "bonds.vtk") for t in times]
    kept = {n: _kept_shape(run, n, times, surfaces[n]) for n in names}
    if all(kept.values()):
        shown = _stepped(run, names, kept, times, bonds)
    else:
        shown = _saved(times, surfaces, bonds)
    return {**shown, "walls": walls, "paths": {n: _paths(run, n) for n in names}}


def _present(name, states):
    """A body's surface in every state; None where it has not entered, or has left."""
    return [Surface(state.patch(name)) if name in state.patches()
            and state.patch(name).GetNumberOfPoints() else None for state in states]


def _alone(case, run):
    """Elastic bodies without a flow: surfaces, moved by their displacement."""
    surfaces = {}
    for _, name in run.bodies():
        with vtk_files.VTKFiles(case, name, fields="D", times="all", internal=False) as states:
            times = [state.time for state in states]
            surfaces[name] = [_deformed(state) for state in states]
    if not surfaces:
        return {"missing": "the history names no body"}
    factor = _visible(surfaces)
    moved = {}
    for name, parts in surfaces.items():
        moved[name] = [whole for whole, _ in parts]
        for whole, by in parts:
            whole.points = whole.points + factor * by
    shown = _saved(times, moved, [None] * len(times))
    return {**shown, "walls": [], "paths": {}, "factor": factor}


def _recorded(run):
    """(kind, name) of bodies of histories that have no notes."""
    paths = [p.split("/") for p in run.history.paths()]
    return sorted({(p[0], p[1]) for p in paths if p[0] in ("bodies", "elasticBodies")})


# What moves without a change of shape

def _rotation(q):
    w, x, y, z = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def _motion(run, name, turns):
    """Time, centre, quaternion of every step that the body is there; None of an elastic
    body."""
    if f"bodies/{name}/position" not in run.history:
        return None
    at = run.history[f"bodies/{name}/position"].array
    by = run.history[f"bodies/{name}/orientation"].array[:, 1:]
    return np.hstack((at, by if turns else np.tile([1.0, 0, 0, 0], (len(at), 1))))


def _kept_shape(run, name, times, surfaces):
    """(surface about its centre, motion) that is found at all saved times; None
    if the body deforms. What is prescribed may move without turning."""
    for turns in (True, False):
        motion = _motion(run, name, turns)
        if motion is None or not len(motion):
            return None
        rows = [_row(motion[:, 0], t) for t in times]
        known = [k for k, r in enumerate(rows) if r is not None and surfaces[k]]
        if not known:
            return None
        local = [(surfaces[k].points - motion[rows[k], 1:4]) @ _rotation(motion[rows[k], 4:])
                 for k in known]
        # the last one is farthest from a sudden start
        last = Surface.of(local[-1], surfaces[known[-1]].faces)
        if all(last.distances(points).max() <= SAME * last.radius() for points in local):
            return last, motion
    return None


# What the script gets

def _text(array, kind):
    return base64.b64encode(np.ascontiguousarray(array, kind).tobytes()).decode()


def _stepped(run, names, kept, saved, bonds):
    times = run.history["cost"]["time"]
    states = {_row(times, t): b for t, b in zip(saved, bonds)}
    states.pop(None, None)
    rows = np.union1d(thinned(len(times), MAX_TIMES), list(states)).astype(int)
    bodies = []
    for name in names:
        surface, motion = kept[name][0], _of_steps(kept[name][1], times)
        bodies.append({"name": name, "faces": _text(surface.faces, "<u4"),
                       "points": _text(surface.points, "<f4"),
                       "motion": _text(motion[rows, 1:], "<f4")})
    return {"times": times[rows].tolist(), "bodies": bodies,
            "bonds": [_bonds(states.get(k)) for k in rows] if any(bonds) else []}


def _of_steps(motion, times):
    """With a row for every step; no number while the body is not there."""
    rows = np.full((len(times), motion.shape[1]), np.nan)
    rows[np.isin(times, motion[:, 0])] = motion[np.isin(motion[:, 0], times)]
    return rows


def _row(times, wanted):
    """Which time it is; None: none of them."""
    k = int(np.argmin(abs(times - wanted)))
    return k if abs(times[k] - wanted) <= 1e-6 * abs(wanted) else None


def _saved(times, surfaces, bonds):
    size = sum(s.points.size * 4 for all in surfaces.values() for s in all if s)
    rows = thinned(len(times), max(2, int(len(times) * min(1, MAX_BYTES / size))))
    bodies = []
    for name, all_surfaces in surfaces.items():
        first = next(s.faces for s in all_surfaces if s)
        frames = []
        for k in rows:
            s = all_surfaces[k]
            if s is None:
                frames.append(None)
                continue
            frames.append({"points": _text(s.points, "<f4")})
            if not np.array_equal(s.faces, first):
                frames[-1]["faces"] = _text(s.faces, "<u4")
        bodies.append({"name": name, "faces": _text(first, "<u4"), "frames": frames})
    return {"times": [times[k] for k in rows], "bodies": bodies,
            "bonds": [_bonds(bonds[k]) for k in rows] if any(bonds) else [],
            "left_out": len(times) - len(rows)}


def _bonds(data):
    """None: not known."""
    if data is None:
        return None
    if not data.GetNumberOfLines():
        return {"ends": "", "tension": []}
    ends = vtk_to_numpy(data.GetPoints().GetData())
    tension = vtk_to_numpy(data.GetCellData().GetArray("tension"))
    return {"ends": _text(ends, "<f4"), "tension": [float(f"{t:.4g}") for t in tension]}


def _paths(run, name):
    """The ways of the centre, one for each time that the body is in the domain."""
    steps = run.history["cost"]["time"]
    for table in (f"bodies/{name}/position", f"elasticBodies/{name}/centre"):
        if table in run.history:
            way = run.history[table].array
            gaps = np.flatnonzero(np.diff(np.searchsorted(steps, way[:, 0])) > 1) + 1
            return [_text(part[thinned(len(part), 500), 1:], "<f4")
                    for part in np.split(way, gaps) if len(part)]
    return []


def _walls(state, surfaces, bodies):
    """The box of the domain, and the plane patches that a body is near."""
    box = vtk.vtkBoundingBox()
    planes = []
    for name in state.patches():
        data = state.patch(name)
        if name in bodies or not data.GetNumberOfPoints():
            continue
        box.AddBounds(data.GetBounds())
        low, high = np.array(data.GetBounds()).reshape(3, 2).T
        flat = np.flatnonzero(high - low < 1e-6 * max(high - low))
        if len(flat) == 1 and _near(surfaces, flat[0], low[flat[0]]):
            planes.append({"low": low.tolist(), "high": high.tolist()})
    bounds = [0.0] * 6
    box.GetBounds(bounds)
    return {"time": state.time, "low": bounds[::2], "high": bounds[1::2], "planes": planes}


def _near(surfaces, axis, place):
    return any(abs(s.points[:, axis] - place).min() < s.radius() for s in surfaces)


# Displacements

def _deformed(state):
    """(surface, displacement of its points) of all patches together."""
    join = vtk.vtkAppendPolyData()
    for name in state.patches():
        join.AddInputData(state.patch(name))
    merge = vtk.vtkCleanPolyData()
    merge.SetInputConnection(join.GetOutputPort())
    merge.Update()
    data = merge.GetOutput()
    spread = vtk.vtkCellDataToPointData()
    spread.SetInputData(data)
    spread.Update()
    values = spread.GetOutput().GetPointData().GetArray("D")
    if values is None:
        values = data.GetPointData().GetArray("D")
    surface = Surface(data)
    by = np.zeros_like(surface.points) if values is None else vtk_to_numpy(values).astype(float)
    return surface, by


def _visible(surfaces):
    """A power of ten by which small displacements are enlarged."""
    largest = max(np.linalg.norm(by, axis=1).max() for all in surfaces.values()
                  for _, by in all)
    size = max(whole.radius() for all in surfaces.values() for whole, _ in all)
    if not largest > 0 or largest > 0.02 * size:
        return 1.0
    return float(10 ** np.floor(np.log10(0.2 * size / largest)))
