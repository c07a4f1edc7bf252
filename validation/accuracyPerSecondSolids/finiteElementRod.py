# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rod of this study by finite elements (dolfinx 0.5): Newton's method, each
step by MUMPS; the form compiled before counts for nothing.

    python3 finiteElementRod.py hexahedra|tetrahedra DEGREE ACROSS
"""

import json
import resource
import sys
import time

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

LENGTH = 10
PULL = 0.0025                   # force per area, F L^2/(E I) = 3
OPTIONS = {"cffi_extra_compile_args": ["-O3", "-march=native"]}


def make_mesh(kind, across):
    cell = mesh.CellType.hexahedron if kind == "hexahedra" else mesh.CellType.tetrahedron
    return mesh.create_box(MPI.COMM_SELF, [np.zeros(3), np.array([LENGTH, 1.0, 1.0])],
                           [LENGTH * across, across, across], cell)


def forms(domain, space, degree):
    """Residual and derivative of a Saint Venant-Kirchhoff body, E 1, nu 0."""
    u, v = fem.Function(space), ufl.TestFunction(space)
    F = ufl.Identity(3) + ufl.grad(u)
    E = (F.T * F - ufl.Identity(3)) / 2
    end = mesh.locate_entities_boundary(domain, 2, lambda x: np.isclose(x[0], LENGTH))
    tags = mesh.meshtags(domain, 2, np.sort(end), np.full(len(end), 1, np.int32))
    ds = ufl.Measure("ds", domain=domain, subdomain_data=tags)
    dx = ufl.dx(metadata={"quadrature_degree": 2 * degree})
    residual = ufl.derivative(ufl.inner(E, E) / 2 * dx, u, v) - PULL * v[1] * ds(1)
    derivative = ufl.derivative(residual, u, ufl.TrialFunction(space))
    return (u, fem.form(residual, jit_params=OPTIONS),
            fem.form(derivative, jit_params=OPTIONS))


def solver(matrix):
    krylov = PETSc.KSP().create(MPI.COMM_SELF)
    krylov.setOperators(matrix)
    krylov.setType("preonly")
    krylov.getPC().setType("cholesky")
    krylov.getPC().setFactorSolverType("mumps")
    matrix.setOption(PETSc.Mat.Option.SYMMETRIC, True)
    return krylov


def newton(space, u, residual, derivative):
    """How many steps it takes."""
    root = mesh.locate_entities_boundary(space.mesh, 2, lambda x: np.isclose(x[0], 0))
    held = fem.dirichletbc(np.zeros(3), fem.locate_dofs_topological(space, 2, root), space)
    matrix = petsc.create_matrix(derivative)
    krylov = solver(matrix)
    for step in range(60):
        b = petsc.assemble_vector(residual)
        petsc.set_bc(b, [held], u.vector, -1.0)
        if b.norm() < 1e-8 * PULL:
            return step
        matrix.zeroEntries()
        petsc.assemble_matrix(matrix, derivative, bcs=[held])
        matrix.assemble()
        correction = b.duplicate()
        krylov.solve(b, correction)
        u.vector.axpy(-1, correction)
    sys.exit("not converged")


def main():
    kind, degree, across = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    start = time.process_time()
    domain = make_mesh(kind, across)
    space = fem.VectorFunctionSpace(domain, ("CG", degree))
    u, residual, derivative = forms(domain, space, degree)
    steps = newton(space, u, residual, derivative)
    x = space.tabulate_dof_coordinates()
    # the middle of the end; a node of hexahedra and of all others with an even
    # number of cells, else the mean of the nearest
    distance = ((x - (LENGTH, 0.5, 0.5))**2).sum(axis=1)
    nearest = np.isclose(distance, distance.min())
    place = (x + u.x.array.reshape(-1, 3))[nearest].mean(axis=0)
    print(json.dumps(dict(
        kind=kind, degree=degree, across=across,
        cells=domain.topology.index_map(3).size_local, x=place[0], y=place[1], Newton=steps,
        seconds=time.process_time() - start,
        memory=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)))


if __name__ == "__main__":
    main()
