# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The peer: drag on a body in Stokes flow by quadratic finite elements.

    python3 taylorHood.py sphere 0.28 [--growth 0.28] [--tolerance 1e-6]

Taylor-Hood tetrahedra (velocity P2, pressure P1) with curved sides in dolfinx,
solved by FGMRES with a block triangular preconditioner: a multigrid cycle for
each component of the velocity (P2, P1, then algebraic), the mass matrix for the
pressure. The force is the reaction, the residual of the momentum equation in
the nodes on the body, which converges twice as fast as integrated tractions.

The three components share one stiffness matrix K; G_i = -int p dv/dx_i. What is
solved for is the correction of a velocity that has the boundary values: it is
zero in the nodes there.

Lengths in radii, viscosity and far velocity 1. Prints one line of JSON; seconds
are the processor's, without imports and without compiling the forms (dolfinx
keeps those: call once before).
"""

import argparse
import json
import resource
import time

import numpy as np
import ufl
from dolfinx import fem, mesh as meshes
from dolfinx.cpp.fem.petsc import interpolation_matrix
from dolfinx.fem.petsc import assemble_matrix, create_matrix
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc

import bodies
from curvedMesh import curved_mesh

COMPILER = dict(cffi_extra_compile_args=["-O3", "-march=native"])
TETRAHEDRON10 = 11                      # gmsh's number
DEGREE = 3                              # of the quadrature, on curved cells


class Clock:
    """Processor's seconds of named parts."""

    def __init__(self):
        self.parts, self.wall = {}, time.perf_counter()
        self.begin = self.last = time.process_time()

    def lap(self, part):
        now = time.process_time()
        self.parts[part] = now - self.last
        self.last = now

    def read(self):
        return dict(seconds=self.last - self.begin,
                    wall=time.perf_counter() - self.wall, **self.parts)


def distributed(points, cells):
    order = gmshio.cell_perm_array(meshes.CellType.tetrahedron, 10)
    return meshes.create_mesh(
        MPI.COMM_SELF, cells[:, order], points, gmshio.ufl_mesh(TETRAHEDRON10, 3))


# Discretisation

def matrix(expression, conditions=(), like=None):
    """Like another: with the entries of that."""
    form = fem.form(expression, jit_params=COMPILER)
    found = like.duplicate() if like else create_matrix(form)
    assemble_matrix(found, form, bcs=list(conditions))
    found.assemble()
    return found


def boundary_nodes(space, mesh):
    mesh.topology.create_connectivity(2, 3)
    return fem.locate_dofs_topological(
        space, 2, meshes.exterior_facet_indices(mesh.topology))


class TaylorHood:
    """Matrices on a mesh, and its nodes on the boundary."""

    def __init__(self, mesh, box):
        """box: half widths"""
        self.cells = mesh.topology.index_map(3).size_local
        velocity = fem.FunctionSpace(mesh, ("CG", 2))
        pressure = fem.FunctionSpace(mesh, ("CG", 1))
        u, v = ufl.TrialFunction(velocity), ufl.TestFunction(velocity)
        p, q = ufl.TrialFunction(pressure), ufl.TestFunction(pressure)
        dx = ufl.dx(domain=mesh, metadata={"quadrature_degree": DEGREE})
        self.stiffness = matrix(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx)
        self.gradients = [matrix(-p * v.dx(0) * dx)]
        for i in (1, 2):
            self.gradients.append(matrix(-p * v.dx(i) * dx, like=self.gradients[0]))
        self.mass = matrix(p * q * dx)
        self.nodes, self.pressures = self.gradients[0].size
        self.points = velocity.tabulate_dof_coordinates()
        self.boundary = boundary_nodes(velocity, mesh)
        on_body = (np.abs(self.points[self.boundary]) < 0.999 * box).all(axis=1)
        self.body = self.boundary[on_body]
        self.prolongation = interpolation_matrix(pressure._cpp_object, velocity._cpp_object)
        self.prolongation.assemble()
        rim = fem.dirichletbc(PETSc.ScalarType(0), boundary_nodes(pressure, mesh), pressure)
        self.coarse = matrix(ufl.inner(ufl.grad(p), ufl.grad(q)) * dx, [rim])

    def eliminate(self):
        """Rows and columns of the boundary nodes, from here on."""
        self.stiffness.zeroRowsColumns(self.boundary, 1)
        for gradient in self.gradients:
            gradient.zeroRows(self.boundary, 0)
        self.prolongation.zeroRows(self.boundary, 0)


# Solution

def multigrid(disc):
    """A V cycle for a component of the velocity."""
    pc = PETSc.PC().create(MPI.COMM_SELF)
    pc.setOperators(disc.stiffness)
    pc.setType("mg")
    pc.setMGLevels(2)
    pc.setMGInterpolation(1, disc.prolongation)
    smoother = pc.getMGSmoother(1)
    smoother.setType("richardson")
    smoother.setTolerances(max_it=1)
    smoother.getPC().setType("sor")
    coarse = pc.getMGCoarseSolve()
    coarse.setOperators(disc.coarse)
    coarse.setType("preonly")
    coarse.getPC().setType("gamg")
    pc.setUp()
    return pc


def mass_solver(mass):
    """Four steps of Chebyshev's: the spectrum after Jacobi is [1/2, 5/2] (Wathen 1987)."""
    ksp = PETSc.KSP().create(MPI.COMM_SELF)
    ksp.setOperators(mass)
    ksp.setOptionsPrefix("mass_")
    options = PETSc.Options("mass_")
    for name, value in (("ksp_type", "chebyshev"), ("ksp_chebyshev_eigenvalues", "0.5,2.5"),
                        ("ksp_max_it", 4), ("ksp_convergence_test", "skip"),
                        ("ksp_norm_type", "none"), ("pc_type", "jacobi")):
        options[name] = value
    ksp.setFromOptions()
    ksp.setUp()
    return ksp


class Blocks:
    """Views of the parts of a vector: three components and the pressure."""

    def __init__(self, disc):
        n = disc.nodes
        self.ranges = [slice(i * n, (i + 1) * n) for i in range(3)] + [slice(3 * n, None)]

    def of(self, array):
        return [PETSc.Vec().createWithArray(array[r], comm=MPI.COMM_SELF) for r in self.ranges]


class StokesMatrix:
    def __init__(self, disc):
        self.disc, self.blocks = disc, Blocks(disc)

    def mult(self, matrix, x, y):
        *u, p = self.blocks.of(x.getArray(readonly=True))
        *r, c = self.blocks.of(y.getArray())
        c.set(0)
        for ui, ri, g in zip(u, r, self.disc.gradients):
            self.disc.stiffness.mult(ui, ri)
            g.multAdd(p, ri, ri)
            g.multTransposeAdd(ui, c, c)


class BlockTriangular:
    """Pressure by its mass, then velocity by what that leaves."""

    def __init__(self, disc):
        self.disc, self.blocks = disc, Blocks(disc)
        self.cycle, self.mass = multigrid(disc), mass_solver(disc.mass)
        self.rest = disc.stiffness.createVecRight()

    def apply(self, pc, x, y):
        *r, c = self.blocks.of(x.getArray(readonly=True))
        *u, p = self.blocks.of(y.getArray())
        self.mass.solve(c, p)
        for ri, ui, g in zip(r, u, self.disc.gradients):
            # p here is minus the pressure's correction
            g.multAdd(p, ri, self.rest)
            self.cycle.apply(self.rest, ui)
        p.scale(-1)


class Converged:
    """Relative to the first residual, that of the given velocity."""

    def __init__(self, tolerance):
        self.tolerance = tolerance

    def __call__(self, ksp, iteration, norm):
        if iteration == 0:
            self.first = norm
        if norm <= self.tolerance * self.first:
            return PETSc.KSP.ConvergedReason.CONVERGED_RTOL
        return 0 if iteration < 300 else PETSc.KSP.ConvergedReason.DIVERGED_ITS


def krylov(disc, tolerance):
    size = 3 * disc.nodes + disc.pressures
    operator = PETSc.Mat().createPython(
        (size, size), StokesMatrix(disc), comm=MPI.COMM_SELF)
    operator.setUp()
    ksp = PETSc.KSP().create(MPI.COMM_SELF)
    ksp.setOperators(operator)
    ksp.setType("fgmres")
    ksp.setGMRESRestart(100)
    ksp.getPC().setType("python")
    ksp.getPC().setPythonContext(BlockTriangular(disc))
    ksp.setConvergenceTest(Converged(tolerance))
    ksp.setUp()
    return ksp


class Drag:
    """Along x: the reaction of the body's nodes to a velocity and a pressure."""

    def __init__(self, disc):
        ones = disc.stiffness.createVecRight()
        ones.getArray()[disc.body] = 1
        self.stiffness, self.gradient = ones.duplicate(), disc.mass.createVecRight()
        disc.stiffness.mult(ones, self.stiffness)
        disc.gradients[0].multTranspose(ones, self.gradient)

    def __call__(self, u, p):
        return -self.stiffness.dot(u) - self.gradient.dot(p)


def right_hand_side(disc, given):
    """Minus the residual of the given velocities; compatible: mass is conserved as a
    whole."""
    blocks = Blocks(disc)
    found = PETSc.Vec().createSeq(3 * disc.nodes + disc.pressures)
    *r, c = blocks.of(found.getArray())
    for velocity, ri, g in zip(given, r, disc.gradients):
        disc.stiffness.mult(velocity, ri)
        g.multTransposeAdd(velocity, c, c)
        ri.getArray()[disc.boundary] = 0
    ones, weights = c.duplicate(), c.duplicate()
    ones.set(1)
    disc.mass.mult(ones, weights)
    c.axpy(-c.sum() / weights.sum(), weights)
    found.scale(-1)
    return found


def boundary_velocity(disc, flow):
    """Of the far field; zero on the body and inside."""
    outer = np.setdiff1d(disc.boundary, disc.body)
    given = []
    for component in flow(disc.points[outer]).T:
        vector = disc.stiffness.createVecRight()
        vector.getArray()[outer] = component
        given.append(vector)
    return given


def solve(disc, flow, tolerance, clock):
    """Drag, iterations."""
    given = boundary_velocity(disc, flow)
    rhs = right_hand_side(disc, given)
    drag = Drag(disc)
    disc.eliminate()
    ksp = krylov(disc, tolerance)
    clock.lap("setUp")
    x = rhs.duplicate()
    ksp.solve(rhs, x)
    if ksp.getConvergedReason() < 0:
        raise RuntimeError(f"FGMRES: {ksp.getConvergedReason()}")
    *u, p = Blocks(disc).of(x.getArray())
    u[0].axpy(1, given[0])
    force = drag(u[0], p)
    clock.lap("solve")
    return force, ksp.getIterationNumber()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("body", choices=bodies.BODIES)
    parser.add_argument("size", type=float)
    parser.add_argument("--growth", type=float)
    parser.add_argument("--tolerance", type=float, default=1e-6)
    o = parser.parse_args()
    clock = Clock()
    mesh = distributed(*curved_mesh(o.body, o.size, o.growth or o.size))
    clock.lap("meshing")
    disc = TaylorHood(mesh, bodies.box_of(o.body))
    clock.lap("assembly")
    force, iterations = solve(disc, bodies.flow(o.body), o.tolerance, clock)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(json.dumps(dict(
        body=o.body, size=o.size, cells=disc.cells, drag=force, iterations=iterations,
        memory=memory, **clock.read())))


if __name__ == "__main__":
    main()
