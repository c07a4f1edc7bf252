# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What references by quadratic finite elements share: a region outside of a sphere in curved
cells, and elements of Taylor and Hood. Needs python3-dolfinx and python3-gmsh.

    domain = outside(lambda occ: occ.addRectangle(-6, 0, 0, 12, 2),
                     lambda occ: occ.addDisk(0, 0, 0, 1, 1), 2, "0.02 + 0.1 * x")
    space = taylor_hood(domain)
"""

import gmsh
import ufl
from dolfinx import fem
from dolfinx.io import gmshio
from mpi4py import MPI


def outside(room, body, dimension, *sizes):
    """Mesh of one shape without another, which are functions of gmsh's kernel; cells are
    as large as the smallest of these formulae of x, y and z."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    occ = gmsh.model.occ
    occ.cut([(dimension, room(occ))], [(dimension, body(occ))])
    occ.synchronize()
    entities = gmsh.model.getEntities(dimension)
    gmsh.model.addPhysicalGroup(dimension, [tag for _, tag in entities], 1)
    field = gmsh.model.mesh.field
    parts = []
    for size in sizes:
        parts.append(field.add("MathEval"))
        field.setString(parts[-1], "F", size)
    least = field.add("Min")
    field.setNumbers(least, "FieldsList", parts)
    field.setAsBackgroundMesh(least)
    for option in ("FromPoints", "ExtendFromBoundary", "FromCurvature"):
        gmsh.option.setNumber(f"Mesh.MeshSize{option}", 0)
    gmsh.model.mesh.generate(dimension)
    gmsh.model.mesh.setOrder(2)
    result = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=dimension)[0]
    gmsh.finalize()
    return result


def taylor_hood(domain):
    """Quadratic velocities, linear pressures."""
    cell = domain.ufl_cell()
    return fem.FunctionSpace(domain, ufl.MixedElement(
        ufl.VectorElement("CG", cell, 2), ufl.FiniteElement("CG", cell, 1)))
