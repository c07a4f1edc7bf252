# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One of the checks of what fsbiResistance wrote; fails with the reason."""

import csv
import sys

import numpy as np

RADIUS, HALF_BOX, VISCOSITY = 8, 60, 1
FLOW = np.array([0.003, -0.002, 0.001, 0, 0, 0])
DRAG = 6 * np.pi * VISCOSITY * RADIUS

with open("case/postProcessing/resistance.csv", newline="") as file:
    rows = np.array([[float(x) for x in row[2:]] for row in list(csv.reader(file))[1:]])
R, M, FORCE = rows[:, :6], rows[:, 6:12], rows[:, 12]
UNIT = np.sqrt(np.outer(np.diag(R), np.diag(R)))


def below(error, bound):
    if not error < bound:
        print(rows)
        sys.exit(f"{error:.3g} is not below {bound:g}")


def symmetric():
    # bound: the tool's own measure of a mesh; 3 % is what forces on one are good to
    below(np.abs((R - R.T) / UNIT).max(), 0.03)


def in_sphere(radius):
    """Drag and torque per motion in the middle of a sphere (Haberman and Sayre 1958)."""
    k = RADIUS / radius
    drag = (1 - k**5) / (1 - 9 / 4 * k + 5 / 2 * k**3 - 9 / 4 * k**5 + k**6)
    return np.array(3 * [drag * DRAG] + 3 * [DRAG * RADIUS**2 / 0.75 / (1 - k**3)])


def hindered():
    # bound: least dissipation: more than in the sphere around the box, less than in
    # that within; 5 % for triangles of a quarter of the radius, which cut 1.6 % off
    # its cube
    own = np.diag(R)
    below((1 - own / in_sphere(HALF_BOX * 3**0.5)).max(), 0.05)
    below((own / in_sphere(HALF_BOX) - 1).max(), 0.05)


def inverse():
    # bound: ten digits in the file
    below(np.abs((R @ M - np.eye(6)) * UNIT / np.diag(R)).max(), 1e-8)


def flow():
    # bound: Stokes flow is linear, on any mesh: ten times the solver's tolerance of
    # 1e-9, for pressure and corner values a hundred times that
    below(np.abs(FORCE - R @ FLOW).max() / np.abs(FORCE[:3]).max(), 1e-6)


def tractions():
    path = "case/postProcessing/tractions.tumourCell.csv"
    t = np.loadtxt(path, delimiter=",", skiprows=1)[:, 3:]
    # uniform on a sphere in a uniform flow, so the mean needs no weights
    # bound: 5 % for the area of the triangles, as above, and walls
    mean = t.mean(axis=0) * 4 * np.pi * RADIUS**2
    below(np.abs(mean - FORCE[:3]).max() / np.abs(FORCE[:3]).max(), 0.05)


locals()[sys.argv[1]]()
