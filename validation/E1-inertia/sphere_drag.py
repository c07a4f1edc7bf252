# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere held in a steady uniform flow at Reynolds numbers 2 a U rho/mu, by
quadratic finite elements (Taylor and Hood) in the plane of axis and radius: writes
sphere_drag.csv, which check.py reads. Needs python3-dolfinx and python3-gmsh.

The domain is a cylinder from 20 radii before the sphere to 40 behind it, of the same cross
section as the square of 40 by 40 radii of the runs, all of it with the velocity of the flow.

Usage, after . etc/bashrc:
    /usr/bin/python3 sphere_drag.py [edge on the sphere over its radius, default 0.02]
"""

import math
import sys

import dolfinx
import numpy as np
import ufl
from dolfinx import fem
from mpi4py import MPI
from petsc4py import PETSc

from fsbi.finite_elements import outside, taylor_hood

BEFORE, BEHIND, WIDE = 20, 40, 40 / math.sqrt(math.pi)
REYNOLDS = (1, 10, 20, 50, 100)


def mesh(edge):
    """Half a plane outside of the unit circle, finer at it and in its wake."""
    behind = "0.02 * Sqrt(x*x) + 2 * (Sqrt(x*x) - x)"
    return outside(lambda occ: occ.addRectangle(-BEFORE, 0, 0, BEFORE + BEHIND, WIDE),
                   lambda occ: occ.addDisk(0, 0, 0, 1, 1), 2,
                   f"{edge} + 0.1 * (Sqrt(x*x + y*y) - 1)",
                   f"{4 * edge} + {behind} + 0.3 * y")


class Flow:
    """Steady flow of unit velocity and density along x around the unit sphere."""

    def __init__(self, domain):
        self.space = taylor_hood(domain)
        self.mu = fem.Constant(domain, PETSc.ScalarType(1))
        self.state = fem.Function(self.space)
        u, p = ufl.split(self.state)
        v, q = ufl.TestFunctions(self.space)
        r = ufl.SpatialCoordinate(domain)[1]

        def div(w):
            return ufl.div(w) + w[1] / r

        def strain(w):
            return ufl.sym(ufl.grad(w))

        self.rows = (
            2 * self.mu * (ufl.inner(strain(u), strain(v)) + u[1] * v[1] / r**2)
            + ufl.dot(ufl.dot(ufl.grad(u), u), v) - p * div(v) - q * div(u) - 1e-9 * p * q
        ) * r * ufl.dx
        velocity, _ = self.space.sub(0).collapse()
        self.uniform = fem.Function(velocity)
        self.uniform.interpolate(lambda x: np.vstack([np.ones_like(x[0]), 0 * x[0]]))
        still = fem.Function(velocity)

        def near(x):
            return np.hypot(x[0], x[1]) < 1.001

        def outer(x):
            ends = np.isclose(x[0], -BEFORE) | np.isclose(x[0], BEHIND)
            return ends | np.isclose(x[1], WIDE)

        def at(where):
            return fem.locate_dofs_geometrical((self.space.sub(0), velocity), where)

        radial, _ = self.space.sub(0).sub(1).collapse()
        axis = fem.locate_dofs_geometrical(
            (self.space.sub(0).sub(1), radial), lambda x: np.isclose(x[1], 0)
        )
        self.given = [
            fem.dirichletbc(fem.Function(radial), axis, self.space.sub(0).sub(1)),
            fem.dirichletbc(self.uniform, at(outer), self.space.sub(0)),
            fem.dirichletbc(still, at(near), self.space.sub(0)),
        ]
        along, _ = self.space.sub(0).sub(0).collapse()
        self.pulled = fem.locate_dofs_geometrical((self.space.sub(0).sub(0), along), near)[0]

    def drag(self, reynolds):
        """Coefficient of drag, F/(rho U^2/2 pi a^2)."""
        self.mu.value = 2 / reynolds
        problem = fem.petsc.NonlinearProblem(self.rows, self.state, self.given)
        solver = dolfinx.nls.petsc.NewtonSolver(MPI.COMM_WORLD, problem)
        solver.rtol = 1e-10
        ksp = solver.krylov_solver
        ksp.setType("preonly")
        ksp.getPC().setType("lu")
        ksp.getPC().setFactorSolverType("mumps")
        solver.solve(self.state)
        rows = fem.petsc.assemble_vector(fem.form(self.rows))
        return -2 * math.pi * rows.array[self.pulled].sum() / (math.pi / 2)


def main():
    edge = float(sys.argv[1]) if len(sys.argv) > 1 else 0.02
    flow = Flow(mesh(edge))
    with open("sphere_drag.csv", "w") as table:
        print("# drag of a sphere, F/(rho U^2/2 pi a^2), by sphere_drag.py with edges of", edge,
              file=table)
        print("Re,drag", file=table)
        for reynolds in REYNOLDS:
            print(f"{reynolds},{flow.drag(reynolds):.6f}", file=table)


if __name__ == "__main__":
    main()
