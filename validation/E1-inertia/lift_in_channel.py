# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inertial lift on a sphere in a square channel, by quadratic finite elements (Taylor and
Hood) on curved tetrahedra: writes lift_in_channel.csv, which check.py reads. Needs
python3-dolfinx and python3-gmsh.

The sphere is carried along x, free of drag, turns free of torque about z, and is held at
its height y over the axis, on the mid-line z = 0, which half of the channel mirrors. Steady
flow of Navier and Stokes in the frame of the sphere, written in velocities against the walls:
what carries momentum is u - U. Velocity and spin are unknowns of the same Newton's method;
forces are residuals of momentum, tested with motions of the surface. Both ends have the
developed profile, as in the runs. Lengths over the width H, velocities over that on the
axis, lift coefficient F/(rho Um^2 d^4/H^2) (Di Carlo et al., Phys. Rev. Lett. 102, 2009).

Usage, after . etc/bashrc:
    /usr/bin/python3 lift_in_channel.py [edges on the sphere over its radius ...]
"""

import sys

import numpy as np
import ufl
from dolfinx import fem
from mpi4py import MPI
from petsc4py import PETSc

from fsbi.finite_elements import outside, taylor_hood

REYNOLDS = 40           # rho Um H/mu
RADIUS = 0.125
HALF_LENGTH = 1.5
HEIGHTS = (0.08, 0.16, 0.24, 0.32)


def mesh(height, edge):
    """Half a channel around the sphere, finer at it."""
    distance = f"(Sqrt(x*x + (y-{height})*(y-{height}) + z*z) - {RADIUS})"
    return outside(lambda occ: occ.addBox(-HALF_LENGTH, -0.5, 0, 2 * HALF_LENGTH, 1, 0.5),
                   lambda occ: occ.addSphere(0, height, 0, RADIUS), 3,
                   f"{edge} * ({RADIUS} + 0.8 * {distance})", f"{0.6 * edge}")


def developed(x):
    """Velocity in a square channel, 1 on the axis, by its series."""
    def profile(y, z):
        n = np.arange(1, 60, 2)[:, None]
        waves = (-1)**((n - 1) // 2) / n**3 * np.cos(n * np.pi * y)
        # cosh(n pi z)/cosh(n pi/2) without large numbers
        across = ((np.exp(n * np.pi * (abs(z) - 0.5)) + np.exp(-n * np.pi * (abs(z) + 0.5)))
                  / (1 + np.exp(-n * np.pi)))
        return np.sum(waves * (1 - across), axis=0)
    along = profile(x[1], x[2]) / profile(np.zeros(1), np.zeros(1))
    return np.vstack([along, 0 * along, 0 * along])


class Channel:
    """Flow around the sphere at a height, and the forces on it."""

    def __init__(self, height, edge, convection):
        domain = mesh(height, edge)
        self.space = taylor_hood(domain)
        self.velocity, self.places = self.space.sub(0).collapse()
        self.speed = fem.Constant(domain, PETSc.ScalarType(0))
        self.spin = 0.0
        self.state = fem.Function(self.space)
        self.write_equations(convection)
        self.hold(height)

    def write_equations(self, convection):
        u, p = ufl.split(self.state)
        v, q = ufl.TestFunctions(self.space)
        carried = ufl.dot(ufl.grad(u), u) - self.speed * u.dx(0)
        rows = (2 / REYNOLDS * ufl.inner(ufl.sym(ufl.grad(u)), ufl.sym(ufl.grad(v)))
                - p * ufl.div(v) - q * ufl.div(u) - 1e-8 * p * q) * ufl.dx
        by_speed = fem.Constant(self.space.mesh, PETSc.ScalarType(0)) * ufl.dot(u, v) * ufl.dx
        if convection:
            rows += ufl.dot(carried, v) * ufl.dx
            by_speed = -ufl.dot(u.dx(0), v) * ufl.dx
        self.rows = fem.form(rows)
        self.by_speed = fem.form(by_speed)
        self.derivative = fem.form(ufl.derivative(rows, self.state))

    def hold(self, height):
        """Which unknowns are given, and motions of the sphere's surface."""
        def near(x):
            return x[0]**2 + (x[1] - height)**2 + x[2]**2 < (1.002 * RADIUS)**2

        def walls(x):
            return np.isclose(abs(x[1]), 0.5) | np.isclose(x[2], 0.5)

        def ends(x):
            return np.isclose(abs(x[0]), HALF_LENGTH)

        def at(where, part=None):
            space = self.space.sub(0) if part is None else self.space.sub(0).sub(part)
            return fem.locate_dofs_geometrical((space, space.collapse()[0]), where)[0]

        def motion(function, where=near):
            shape = fem.Function(self.velocity)
            shape.interpolate(function)
            given = np.zeros(self.size())
            place = np.unique(at(where))
            full = np.zeros(self.size())
            full[self.places] = shape.x.array
            given[place] = full[place]
            return given

        def unit(axis):
            return lambda x: np.vstack([1.0 * (axis == i) + 0 * x[0] for i in range(3)])

        self.along, self.lateral = motion(unit(0)), motion(unit(1))
        self.turning = motion(lambda x: np.vstack([height - x[1], x[0], 0 * x[0]]))
        self.state.x.array[:] = motion(developed, ends)
        self.given = np.unique(np.concatenate(
            [at(near), at(walls), at(ends), at(lambda x: np.isclose(x[2], 0), 2)]))

    def size(self):
        return self.space.dofmap.index_map.size_local * self.space.dofmap.index_map_bs

    def factorise(self):
        """Derivative of the rows, and its factors with the given unknowns held."""
        self.whole = fem.petsc.assemble_matrix(self.derivative)
        self.whole.assemble()
        self.change_by_speed = fem.petsc.assemble_vector(self.by_speed).array.copy()
        self.held = self.whole.copy()
        self.held.zeroRows(self.given.astype(np.int32), 1.0)
        self.solver = PETSc.KSP().create(MPI.COMM_WORLD)
        self.solver.setOperators(self.held)
        self.solver.setType("preonly")
        self.solver.getPC().setType("lu")
        self.solver.getPC().setFactorSolverType("mumps")

    def solve(self, right, given):
        right = right.copy()
        right[self.given] = given[self.given]
        answer = self.held.createVecRight()
        self.solver.solve(PETSc.Vec().createWithArray(right), answer)
        return answer.array.copy()

    def times(self, vector):
        product = self.whole.createVecLeft()
        self.whole.mult(PETSc.Vec().createWithArray(vector), product)
        return product.array.copy()

    def correct(self):
        """One correction by Newton's method of flow, velocity and spin; its size, without
        pressures, whose constant is held by next to nothing."""
        rows = fem.petsc.assemble_vector(self.rows).array.copy()
        none = np.zeros_like(rows)
        steps = [self.solve(-rows, none), self.solve(-self.change_by_speed, self.along),
                 self.solve(none, self.turning)]
        changes = [self.times(step) for step in steps]
        changes[1] += self.change_by_speed
        tests = np.array([self.along, self.turning])
        change = np.linalg.solve(tests @ np.array(changes[1:]).T, -tests @ (rows + changes[0]))
        step = steps[0] + change @ np.array(steps[1:])
        self.state.x.array[:] += step
        self.speed.value += change[0]
        self.spin += change[1]
        return max(abs(step[self.places]))

    def lift(self):
        """Coefficient; velocity and spin are solved for, too."""
        size = 1.0
        for _ in range(20):
            # near the end the last factors do
            if size > 1e-2:
                self.factorise()
            size = self.correct()
            if size < 1e-9:
                break
        else:
            raise RuntimeError("Newton's method does not converge")
        # twice: the other half of the channel
        force = -2 * fem.petsc.assemble_vector(self.rows).array @ self.lateral
        return force / (2 * RADIUS)**4


def row(height, edge, convection):
    flow = Channel(height, edge, convection)
    lift = flow.lift()
    cells = flow.space.mesh.topology.index_map(3).size_local
    return [REYNOLDS * convection, height, edge, cells, float(flow.speed.value), flow.spin, lift]


def main():
    edges = [float(edge) for edge in sys.argv[1:]] or [0.5, 0.35, 0.25]
    with open("lift_in_channel.csv", "w") as table:
        print("# sphere in a square channel by lift_in_channel.py: d/H 0.25, Re = rho Um H/mu,",
              "ends 1.5 H away; y/H, edges over the radius, cells of half the channel, U/Um,",
              "omega H/Um, F/(rho Um^2 d^4/H^2)", file=table)
        print("Re,height,edge,cells,speed,spin,lift", file=table)
        for convection, heights in ((False, HEIGHTS[-1:]), (True, HEIGHTS)):
            for height in heights:
                for edge in edges:
                    numbers = row(height, edge, convection)
                    print(",".join(f"{number:.7g}" for number in numbers), file=table,
                          flush=True)


if __name__ == "__main__":
    main()
