# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres with Coulomb friction on a wall against closed balances; write results.csv."""

import csv
import sys

import numpy as np

from fsbi.case import Case
from fsbi.results import Results

RADIUS, RANGE, PRESS, FRICTION = 4, 0.02, 1, 0.3
MASS = 4 / 3 * np.pi * RADIUS**3
INERTIA = 2 / 5 * MASS * RADIUS**2
# Of the press: loads agree within 1e-3 of the largest, normals turn within the zone
# by up to sqrt(2 range/R), so that of friction's sum 1 - cos < range/R is missing
LAW = 1e-3 + RANGE / RADIUS
# and the pressure is integrated to 0.15^2, which, one-sided, has for an arm the
# radius of the zone
NOISE = 1e-3 + 0.15**2 * np.sqrt(2 * RANGE / RADIUS)
LIMIT = FRICTION * PRESS
results = Results("N6")


class Run:
    def __init__(self, name):
        self.name = name
        self.case = Case(f"runs/{name}")
        h = self.case.history
        self.v = h["bodies/a/velocity"]["x"]
        self.w = h["bodies/a/angularVelocity"]["z"]
        self.t = h["bodies/a/velocity"]["time"]
        self.force = h["bodies/a/force/effects"]["x"]
        self.torque = h["bodies/a/torque/effects"]["z"]
        self.dissipated = h["effects/contact/friction"]["dissipated"]

    def add(self, quantity, value, reference, bound):
        results.add(quantity, value, reference=reference, bound=bound, variant=self.name,
                    seconds=self.case.seconds, cells=self.case.cells)


def roll():
    """Rolls: m a = T - F, I a/R = F R"""
    run, T = Run("roll"), 0.5
    bound = NOISE * PRESS / T + RANGE / RADIUS
    run.add("acceleration", run.v[-1] / run.t[-1], T / (MASS + INERTIA / RADIUS**2), bound)
    # bound: F is 2/7 of T
    run.add("friction_over_force", -run.force.mean() / T, 2 / 7, 3.5 * bound)
    # slips no faster than it sticks
    run.add("slip_abs", np.abs(run.v + RADIUS * run.w).max(), 0, 1e-3)


def slide():
    """Slides: m a = T - mu W, I alpha = mu W R"""
    run, T = Run("slide"), 2
    run.add("friction_over_press", -run.force.mean() / PRESS, FRICTION, LAW)
    run.add("acceleration", run.v[-1] / run.t[-1], (T - LIMIT) / MASS, LAW * LIMIT / (T - LIMIT))
    # bound: besides, what presses is not in the middle
    run.add("angular_acceleration", -run.w[-1] / run.t[-1], LIMIT * RADIUS / INERTIA,
            LAW + NOISE / FRICTION)


def bowl():
    """Thrown: whatever the coefficient, the moment about the place that touches stays,
    5/7 of the velocity, 2/7 of the energy is lost"""
    run, v0 = Run("bowl"), 0.05
    bound = NOISE * PRESS * run.t[-1] / MASS / v0 + RANGE / RADIUS
    run.add("velocity_rolling", run.v[-1], 5 / 7 * v0, bound)
    run.add("slip_abs", abs(run.v[-1] + RADIUS * run.w[-1]), 0, 1e-3)
    # bound: of what is lost while the slip falls to zero in proportion to time, the
    # slip at the end of every step instead of the mean one
    stops = 2 / 7 * v0 * MASS / LIMIT
    step = run.t[1] - run.t[0]
    run.add("energy_dissipated", run.dissipated.sum(), MASS * v0**2 / 7,
            step / stops + bound)


def creep():
    """Sticks: 2 y - y^2 = T/(mu W)"""
    run, T = Run("creep"), 0.15
    y = 1 - np.sqrt(1 - T / LIMIT)
    # bound: loads are known to LAW of the press, and y follows them by 1/(2 - 2 y)
    run.add("creep_over_slipSpeed", run.v[-1] / 1e-3, y, LAW / FRICTION / (2 - 2 * y) / y)
    run.add("creep_abs", run.v.max(), 0, 1e-3)


def spin():
    """A torque beyond mu W R turns it, one below does not"""
    run, T = Run("spinBelow"), 0.9
    y = 1 - np.sqrt(1 - T / LIMIT / RADIUS)
    run.add("creep_over_slipSpeed", RADIUS * run.w[-1] / 1e-3, y,
            (LAW + NOISE) / FRICTION / (2 - 2 * y) / y)
    run, T = Run("spinBeyond"), 1.5
    limit = LIMIT * RADIUS
    run.add("largest_torque", -run.torque.mean(), limit, LAW + NOISE / FRICTION)
    run.add("angular_acceleration", run.w[-1] / run.t[-1], (T - limit) / INERTIA,
            (LAW + NOISE / FRICTION) * limit / (T - limit))


def belt():
    """Taken along by a wall: mu W/m until it goes with it"""
    run, wall = Run("belt"), 0.01
    slips = run.t < wall * MASS / LIMIT - 2
    run.add("acceleration", (run.v / run.t)[slips][-1], LIMIT / MASS, LAW)
    # bound: at rest on it nothing pulls but 1e-3 of the press
    y = 1 - np.sqrt(1 - 1e-3 / FRICTION)
    run.add("velocity_of_wall_abs", run.v[-1], wall, y * 1e-4 + 1e-3 * PRESS / MASS * 1)


def resistance(run):
    """Of x and of the rotation about z"""
    with open(f"runs/{run.name}/postProcessing/resistance.csv", newline="") as file:
        rows = {r["row"]: r for r in csv.DictReader(file)}
    return np.array([[float(rows[row][column]) for column in ("R.a.Ux", "R.a.Wz")]
                     for row in ("Fx", "Tz")])


def viscous():
    """Without inertia: T - F = R_xx v + R_xw w, - F R = R_wx v + R_ww w"""
    run, T = Run("viscousRoll"), 0.5
    R = resistance(run)
    # the moment about the place that touches, v = - w R
    e = np.array([1, -1 / RADIUS])
    v = T / (e @ R @ e)
    # bound: besides, what it slips
    run.add("velocity", run.v[-1], v, NOISE * PRESS / T + RANGE / RADIUS + 2e-5 / v)
    run = Run("viscousSlide")
    T, R = 2, resistance(run)
    # the mesh has the fluid press a sphere that slides, which the exact flow does not
    press = PRESS - run.case.history["bodies/a/force/fluid"]["y"][-1]
    F = FRICTION * press
    v, w = np.linalg.solve(R, [T - F, -F * RADIUS])
    run.add("friction_over_press", -run.force[-1] / press, FRICTION, LAW)
    bound = LAW * LIMIT / (T - LIMIT) + NOISE * PRESS / T
    run.add("velocity", run.v[-1], v, bound)
    run.add("angular_velocity", run.w[-1], w, LAW + NOISE / FRICTION)


def main():
    roll()
    slide()
    bowl()
    creep()
    spin()
    belt()
    viscous()
    results.write()
    sys.exit(results.check())


if __name__ == "__main__":
    main()
