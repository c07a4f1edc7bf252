# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A case as ParaView shows it: read by its reader, vtkOpenFOAMReader.

    case = Case("softCell")                 # has softCell/*.foam
    mesh, patches = case.at(4000)["fluid"]
    u = cells(mesh, "U")
"""

import glob
import os

import vtk
from vtk.util.numpy_support import vtk_to_numpy


class Case:
    """Regions and times as the reader finds them, all fields."""

    def __init__(self, folder, decomposed=False):
        files = glob.glob(os.path.join(folder, "*.foam"))
        if len(files) != 1:
            raise SystemExit(f"{folder} has {len(files)} files .foam")
        self.reader = vtk.vtkPOpenFOAMReader() if decomposed \
            else vtk.vtkOpenFOAMReader()
        if decomposed:
            self.controller = vtk.vtkDummyController()
            self.reader.SetController(self.controller)
            self.reader.SetCaseType(0)
        self.reader.SetFileName(files[0])
        self.reader.UpdateInformation()
        self.reader.EnableAllPatchArrays()
        self.reader.EnableAllCellArrays()
        self.reader.EnableAllPointArrays()
        self.reader.SetCreateCellToPoint(0)
        steps = vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS()
        self.times = self.reader.GetOutputInformation(0).Get(steps) or ()

    def at(self, time):
        """The regions: name, then the mesh and a dictionary of patches."""
        self.reader.UpdateTimeStep(time)
        regions = {}
        for name, block in parts(self.reader.GetOutput()):
            if name in ("internalMesh", "boundary"):    # there is but one
                regions.setdefault("", [None, {}])
                take(regions[""], name, block)
                continue
            regions[name] = [None, {}]
            for part, inner in parts(block):
                take(regions[name], part, inner)
        return regions


def parts(block):
    """Names and contents of a block."""
    for i in range(block.GetNumberOfBlocks()):
        name = block.GetMetaData(i).Get(vtk.vtkCompositeDataSet.NAME())
        yield name, block.GetBlock(i)


def take(region, name, block):
    if name == "internalMesh":
        region[0] = block
    elif name == "boundary":
        region[1] = dict(parts(block))


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def cells(data, field):
    """One row per cell or face."""
    array = data.GetCellData().GetArray(field)
    if array is None:
        raise SystemExit(f"there is no field {field}")
    return vtk_to_numpy(array).astype(float)


def vertices(data, field):
    return vtk_to_numpy(data.GetPointData().GetArray(field)).astype(float)


def corners(data):
    """Vertices of cells or faces that are all of one kind, one row each."""
    connectivity = data.GetPolys() if data.IsA("vtkPolyData") else data.GetCells()
    return vtk_to_numpy(connectivity.GetConnectivityArray()).reshape(
        data.GetNumberOfCells(), -1)


def centres(data):
    return points(data)[corners(data)].mean(axis=1)


def volumes(mesh):
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(mesh)
    size.Update()
    return cells(size.GetOutput(), "Volume")
