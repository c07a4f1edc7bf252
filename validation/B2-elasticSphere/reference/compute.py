#!/usr/bin/python3
# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compute the references of B2, S9 and S10, and how far they have converged:

    reference/compute.py

writes the CSV files beside it, in some ten seconds."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import ellipsoid                                                # noqa: E402
from ellipsoid import (IncompressibleNeoHookean, NeoHookean,    # noqa: E402
                       StVenantKirchhoff, deformation)

NU = 0.133
SOFTENING = StVenantKirchhoff(NU)
ABOUT = "An elastic sphere in simple shear, exact: computed by reference/compute.py"


def write(name, columns, rows, about):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    with open(path, "w") as file:
        file.write(f"# {ABOUT}. {about}\n{','.join(columns)}\n")
        for row in rows:
            file.write(",".join(f"{v:.8g}" for v in row) + "\n")
    print("    " + name)


def shape(x):
    a = np.exp(x[:3])
    return deformation(a), np.degrees(x[3]), *a, np.prod(a)


def steady():
    rows, x, law = [], None, IncompressibleNeoHookean()
    for Ca in (0.001, 0.005, 0.01, 0.02, 0.03, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3,
               0.4, 0.5, 0.6, 0.8, 1):
        x = ellipsoid.steady(law, Ca, x)
        a = np.exp(x[:3])
        rows.append([Ca, *shape(x)[:2],
                     ellipsoid.stresslet(a, x[3], law.stress(a) / Ca)[0, 1]])
    write("steady.csv", ["Ca", "D_exact", "theta_deg", "stresslet_xy"], rows,
          "Steady shape, incompressible neo-Hookean; stresslet over viscosity, shear "
          "rate and radius^3")


def start_up():
    times = (0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1, 1.5, 2, 3, 5)
    rows = []
    for Ca in (0.05, 0.1, 0.2):
        found = ellipsoid.start_up(IncompressibleNeoHookean(), Ca, times, 0.005)
        rows += [[Ca, t, deformation(a), np.degrees(theta)]
                 for t, (a, theta) in zip(times, found)]
    write("startUp.csv", ["Ca", "gamma_t", "D_exact_NHinc", "theta_deg"], rows,
          "From a sphere at rest, incompressible neo-Hookean")


def branches():
    D = np.arange(0.01, 0.601, 0.01)
    for law in (SOFTENING, NeoHookean(NU)):
        rows = [[np.exp(x[4]), *shape(x)] for x in ellipsoid.branch(law, D)]
        write(f"{type(law).__name__}.csv",
              ["Ca", "D", "theta_deg", "longest", "shortest", "third", "J"], rows,
              f"Steady shapes at nu {NU}, by their deformation; semi-axes over the radius")


def compressible():
    rows = []
    for nu in (0.3, 0.49):
        x = None
        for Ca in (0.02, 0.05, 0.1, 0.2, 0.3, 0.4):
            x = ellipsoid.steady(NeoHookean(nu), Ca, x)
            rows.append([nu, Ca, *shape(x)[:2]])
    write("compressible.csv", ["nu", "Ca", "D", "theta_deg"], rows,
          "Steady shape, neo-Hookean")


def fold():
    rows = [[nu, *ellipsoid.fold(StVenantKirchhoff(nu), 0.01)] for nu in (0, NU, 0.3, 0.45)]
    write("fold.csv", ["nu", "Ca", "D"], rows,
          "Largest Ca with a steady shape, St.Venant-Kirchhoff")


def convergence():
    rows = []
    for nodes, step in ((8, 0.04), (16, 0.02), (32, 0.01), (64, 0.005)):
        x = ellipsoid.steady(SOFTENING, 0.2, ellipsoid.at_deformation(SOFTENING, 0.3), nodes)
        a, _ = ellipsoid.start_up(IncompressibleNeoHookean(), 0.2, [0.4], step, nodes)[0]
        rows.append([nodes, step, ellipsoid.fold(SOFTENING, step, nodes)[0], shape(x)[0],
                     deformation(a)])
    write("convergence.csv", ["nodes", "step", "fold_Ca", "D_Ca0.2", "D_startUp"], rows,
          "Nodes of the quadrature; steps of the continuation and in time")


def surface():
    """The flow of the ellipsoid at the fold against quadrature over its surface."""
    x = ellipsoid.at_deformation(SOFTENING, 0.513)
    a = np.exp(x[:3])
    S = ellipsoid.balance(a, x[3], SOFTENING.stress(a) / np.exp(x[4]))[3]
    points = a * np.array([[0.3, 0.1, -0.2], [-0.1, 0.4, 0.2], [0.2, -0.3, 0.4]])
    exact = points @ ellipsoid.disturbance(a, S, ellipsoid.potentials(a))[0].T
    rows = [[n, np.abs(ellipsoid.by_surface(a, S, points, n) - exact).max()
             / np.abs(exact).max()] for n in (8, 16, 32, 64)]
    write("surface.csv", ["points", "difference"], rows,
          "Flow around the ellipsoid: potentials against quadrature over the surface")


if __name__ == "__main__":
    for part in (steady, start_up, branches, compressible, fold, convergence, surface):
        part()
