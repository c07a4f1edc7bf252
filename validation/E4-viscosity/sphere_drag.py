# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag of a sphere that moves along the axis of a closed tube, in fluids whose viscosity
depends on the rate of shear, by quadratic finite elements (Taylor and Hood) in the plane of
axis and radius: writes sphere_drag.csv, which check.py reads. Needs python3-dolfinx and
python3-gmsh.

Lengths in radii of the sphere, its velocity is 1. The drag is over 6 pi m, m being the
viscosity at rest (Carreau) or the consistency (power law). Tubes: `narrow`, of radius 2 and
12 long, and `wide`, of radius and half length 100, in which the drag is that without walls.

Usage, after . etc/bashrc: /usr/bin/python3 sphere_drag.py [edge on the sphere, default 0.02]
"""

import math
import sys

import dolfinx
import numpy as np
import ufl
from dolfinx import fem
from mpi4py import MPI

from fsbi.finite_elements import outside, taylor_hood

# radius, half length, growth of edges
TUBES = {"narrow": (2, 6, 0.03), "wide": (100, 100, 0.1)}
# tube, law, exponent, time or smallest rate, viscosity at high rates
FLUIDS = [
    ("narrow", "Newtonian", 1, 1, 0),
    ("narrow", "Carreau", 0.36, 1, 0.0625),
    ("narrow", "Carreau", 0.36, 10, 0.0625),
    ("narrow", "powerLaw", 0.6, 0.01, 0),
    ("wide", "Newtonian", 1, 1, 0),
    ("wide", "powerLaw", 0.8, 1e-4, 0),
    ("wide", "powerLaw", 0.6, 1e-4, 0),
]


def mesh(edge, radius, half, growth):
    """Half a plane outside of the unit circle, finer at it."""
    return outside(lambda occ: occ.addRectangle(-half, 0, 0, 2 * half, radius),
                   lambda occ: occ.addDisk(0, 0, 0, 1, 1), 2,
                   f"{edge} + {growth} * (Sqrt(x*x + y*y) - 1)")


class Flow:
    """Creeping flow around the unit sphere that moves along the axis."""

    def __init__(self, domain, radius, half):
        self.space = taylor_hood(domain)
        self.radius = ufl.SpatialCoordinate(domain)[1]
        velocity, _ = self.space.sub(0).collapse()
        moving = fem.Function(velocity)
        moving.interpolate(lambda x: np.vstack([np.ones_like(x[0]), 0 * x[0]]))

        def near(x):
            return np.hypot(x[0], x[1]) < 1.001

        def outer(x):
            return np.isclose(np.abs(x[0]), half) | np.isclose(x[1], radius)

        def at(where):
            return fem.locate_dofs_geometrical((self.space.sub(0), velocity), where)

        radial, _ = self.space.sub(0).sub(1).collapse()
        axis = fem.locate_dofs_geometrical(
            (self.space.sub(0).sub(1), radial), lambda x: np.isclose(x[1], 0)
        )
        self.given = [
            fem.dirichletbc(fem.Function(radial), axis, self.space.sub(0).sub(1)),
            fem.dirichletbc(fem.Function(velocity), at(outer), self.space.sub(0)),
            fem.dirichletbc(moving, at(near), self.space.sub(0)),
        ]
        along, _ = self.space.sub(0).sub(0).collapse()
        self.pulled = fem.locate_dofs_geometrical((self.space.sub(0).sub(0), along), near)[0]

    def rows(self, state, eta):
        """Weak momentum and continuity, with a viscosity of the square of the rate."""
        u, p = ufl.split(state)
        v, q = ufl.TestFunctions(self.space)
        r = self.radius

        def div(w):
            return ufl.div(w) + w[1] / r

        def both(a, b):
            strain = ufl.inner(ufl.sym(ufl.grad(a)), ufl.sym(ufl.grad(b)))
            return strain + a[1] * b[1] / r**2

        return (
            2 * eta(2 * both(u, u)) * both(u, v) - p * div(v) - q * div(u) - 1e-10 * p * q
        ) * r * ufl.dx

    def drag(self, law, exponent, scale, plateau):
        """Over 6 pi, in steps of the exponent from that of a Newtonian fluid."""
        state = fem.Function(self.space)
        for part in (0, 0.5, 1) if exponent != 1 else (0,):
            power = part * (exponent - 1) / 2

            def eta(square, power=power):
                if law == "Carreau":
                    return plateau + (1 - plateau) * (1 + scale**2 * square)**power
                return (square + scale**2)**power

            rows = self.rows(state, eta)
            problem = fem.petsc.NonlinearProblem(rows, state, self.given)
            solver = dolfinx.nls.petsc.NewtonSolver(MPI.COMM_WORLD, problem)
            solver.rtol = 1e-9
            solver.max_it = 60
            ksp = solver.krylov_solver
            ksp.setType("preonly")
            ksp.getPC().setType("lu")
            ksp.getPC().setFactorSolverType("mumps")
            solver.solve(state)
        force = fem.petsc.assemble_vector(fem.form(rows)).array[self.pulled].sum()
        return 2 * math.pi * force / (6 * math.pi)


def main():
    edge = float(sys.argv[1]) if len(sys.argv) > 1 else 0.02
    flows = {
        name: Flow(mesh(edge, *tube), *tube[:2]) for name, tube in TUBES.items()
    }
    with open("sphere_drag.csv", "w") as table:
        print("# drag of a sphere over 6 pi m a U, by sphere_drag.py with edges of", edge,
              file=table)
        print("tube,law,exponent,scale,plateau,drag", file=table)
        for tube, *fluid in FLUIDS:
            row = (tube, *fluid, f"{flows[tube].drag(*fluid):.6f}")
            print(*row, sep=",", file=table)
            print(*row, flush=True)


if __name__ == "__main__":
    main()
