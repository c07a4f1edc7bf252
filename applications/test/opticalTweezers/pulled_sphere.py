# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An elastic sphere pulled apart by two beads, by axisymmetric finite elements (dolfinx,
quadratic) of linear elasticity: mean displacement of what a bead holds, times Young's
modulus and the sphere's radius, over the force.

Usage: pulled_sphere.py [poissonRatio [beadRadiusOverRadius]]     python3-dolfinx, gmsh
"""

import sys

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.io import gmshio
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI


def quarter_disc(edge, bead):
    """Of radius 1; circle from the axis r = 0 at z = 1, the bead's part apart."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    add = gmsh.model.geo
    angle = 2 * np.arcsin(bead / 2)         # of a chord as long as the bead's radius
    centre = add.addPoint(0, 0, 0, 5 * edge)
    pole = add.addPoint(0, 1, 0, edge)
    rim = add.addPoint(np.sin(angle), np.cos(angle), 0, edge / 10)
    equator = add.addPoint(1, 0, 0, 5 * edge)
    lines = [add.addLine(pole, centre), add.addLine(centre, equator),
             add.addCircleArc(equator, centre, rim), add.addCircleArc(rim, centre, pole)]
    add.addPlaneSurface([add.addCurveLoop(lines)])
    add.synchronize()
    for tag, line in enumerate(lines):
        gmsh.model.addPhysicalGroup(1, [line], tag + 1)
    gmsh.model.addPhysicalGroup(2, [1], 1)
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2)
    mesh, _, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
    gmsh.finalize()
    return mesh, facets


def compliance(nu, bead, edge):
    mesh, facets = quarter_disc(edge, bead)
    space = fem.VectorFunctionSpace(mesh, ("CG", 2))
    r = ufl.SpatialCoordinate(mesh)[0]
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    mu, lame = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))

    def strain(w):
        return ufl.as_tensor([[w[0].dx(0), (w[0].dx(1) + w[1].dx(0)) / 2, 0],
                              [(w[0].dx(1) + w[1].dx(0)) / 2, w[1].dx(1), 0],
                              [0, 0, w[0] / r]])

    stress = 2 * mu * strain(u) + lame * ufl.tr(strain(u)) * ufl.Identity(3)
    ds = ufl.Measure("ds", domain=mesh, subdomain_data=facets)
    area = np.pi * bead**2                  # of a cap, of whatever sphere
    dx = ufl.dx(metadata={"quadrature_degree": 6})
    energy = 2 * np.pi * ufl.inner(stress, strain(v)) * r * dx
    load = 2 * np.pi * v[1] / area * r * ds(4)
    fixed = []
    for tag, component in ((1, 0), (2, 1)):     # on the axis, on the plane of symmetry
        dofs = fem.locate_dofs_topological(space.sub(component), 1, facets.find(tag))
        fixed.append(fem.dirichletbc(0.0, dofs, space.sub(component)))
    w = LinearProblem(energy, load, bcs=fixed,
                      petsc_options={"ksp_type": "preonly", "pc_type": "lu"}).solve()
    return fem.assemble_scalar(fem.form(2 * np.pi * w[1] / area * r * ds(4)))


if __name__ == "__main__":
    given = [float(value) for value in sys.argv[1:]]
    nu, bead = (given + [0.49, 0.375][len(given):])[:2]
    for edge in (0.04, 0.02, 0.01):
        print(f"edge {edge}: {compliance(nu, bead, edge):.6f}")
