# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh a .geo file by gmsh's library, for OpenFOAM's gmshToFoam.

    python3 -m fsbi.gmsh beam.geo beam.msh      # as gmsh -3 -format msh2
    gmshToFoam beam.msh -region beam

Physical surfaces become patches.
"""

import ctypes
import ctypes.util
import sys


def mesh(geometry, output):
    name = ctypes.util.find_library("gmsh")
    if not name:
        sys.exit("gmsh: there is no libgmsh")
    library = ctypes.CDLL(name)
    fault = ctypes.c_int()

    def call(function, *arguments):
        getattr(library, f"gmsh{function}")(*arguments, ctypes.byref(fault))
        if fault.value:
            sys.exit(f"gmsh: {function} failed for {geometry}")

    call("Initialize", 0, None, 0)
    call("OptionSetNumber", b"General.Terminal", ctypes.c_double(0))
    call("OptionSetNumber", b"Mesh.MshFileVersion", ctypes.c_double(2.2))
    call("Open", geometry.encode())
    call("ModelMeshGenerate", 3)
    call("Write", output.encode())
    call("Finalize")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    mesh(*sys.argv[1:])
