# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with the classes of etc/templates, which the Allrun has built and run,
against theory."""

import numpy as np
import pytest
from scipy.optimize import fsolve

from fsbi import convergence, fields
from fsbi.history import History
from fsbi.steps import tried


def history(case):
    return History(f"{case}/postProcessing/history.h5")


# A body in an optical trap: x' = -x/tau, tau = drag/k

def displacement(step):
    return history(f"trap{step}")["bodies/tumourCell/position"]["x"] - 60


@pytest.fixture(scope="module")
def relaxed():
    steps = (200, 100, 50)
    ends = [displacement(step)[-1] for step in steps]
    return convergence.order_of_three(steps, ends), convergence.richardson(steps, ends)


def test_trapped_body_moves_with_second_order_in_time(relaxed):
    # bound: BDF2
    assert relaxed[0] == pytest.approx(2, abs=0.3)


def test_trapped_body_relaxes_by_its_drag(relaxed):
    tau = 1000 / np.log(4 / relaxed[1])
    drag = 0.15 * tau / (6 * np.pi * 8)
    # bound: the walls, 7.5 radii away, add a good tenth; coarse triangles take some away
    assert 1.0 < drag < 1.4


def test_trapped_body_takes_steps_of_a_hundred_times_its_relaxation():
    x = np.abs(displacement(100000))
    assert x[3:].max() < 0.1 and x[-1] < 1e-3


# Steps that carry a body by 0.9 at most, at the velocity that it has

def test_step_limiter_of_ones_own_gives_steps_their_length_and_its_name():
    velocity = history("drift")["bodies/tumourCell/velocity"]
    speed = np.sqrt(sum(velocity[axis] ** 2 for axis in "xyz"))
    ends = velocity["time"]
    with open("drift/postProcessing/steps/0/steps.dat") as file:
        limits = [line.split(maxsplit=7)[7].strip() for line in file if line[0] != "#"]
    with open("drift/log.fsbiFoam") as file:
        told = sum("dt by drift of tumourCell" in line for line in file)
    drifts = [i for i, limit in enumerate(limits) if limit == "drift of tumourCell"]
    assert len(drifts) == told > 5
    for i in drifts:
        left = 4000 - ends[i - 1]
        # a whole number of them up to the end of the run
        length = left / np.ceil(left * speed[i - 1] / 0.9 - 1e-6)
        # bound: times have 12 digits, steps are a tenth of them
        assert ends[i] - ends[i - 1] == pytest.approx(length, rel=1e-9)


# A squirmer of the radius a in unbounded fluid: F = -6 pi mu a (V - 2/3 B e)

RADIUS, EDGE, WALL = 8, 2, 60


def force(case):
    table = history(case)["bodies/tumourCell/force/fluid"]
    return np.array([table[axis][-1] for axis in "xyz"])


@pytest.mark.parametrize("case, slip", [("held", 1), ("swims", 0)])
def test_squirmer_is_driven_by_two_thirds_of_its_slip(case, slip):
    towed = force("towed")
    # bound: second order in the edges; walls change the slip's part against that of
    # the speed by the cube of radius over distance
    bound = (EDGE / RADIUS) ** 2 + (RADIUS / WALL) ** 3
    assert np.linalg.norm(force(case) + slip * towed) < bound * np.linalg.norm(towed)


def test_towed_squirmer_has_the_drag_of_a_sphere():
    drag = np.linalg.norm(force("towed")) / (6 * np.pi * RADIUS * 6e-4)
    # bound: each of six walls 7.5 radii away adds 9/16 a/h at most
    assert 1 < drag < 1 + 6 * 9 / 16 * RADIUS / WALL


# Gent's law: stretches l along, m across, under the force T per undeformed area

E, JM = 3, 3


def gent(nu):
    """Shear modulus, Lame's constant, and the principal first Piola-Kirchhoff
    stresses as functions of l and m."""
    mu, lame = E / 2 / (1 + nu), E * nu / (1 + nu) / (1 - 2 * nu)

    def stresses(length, width):
        stiffening = JM / (JM + 3 - length**2 - 2 * width**2)
        volume = np.log(length * width**2)
        return [mu * (stiffening * x - 1 / x) + lame * volume / x for x in (length, width)]
    return mu, lame, stresses


def stretched(nu, force):
    stresses = gent(nu)[2]

    def lack(x):
        along, across = stresses(*x)
        return along - force, across
    found = np.array([1.0, 1.0])
    for part in np.linspace(0, 1, 9)[1:]:
        found = fsolve(lambda x: np.array(lack(x)) + [(1 - part) * force, 0], found, xtol=1e-13)
    return found


def energy(nu, length, width):
    mu, lame, _ = gent(nu)
    volume = np.log(length * width**2)
    return (-mu * JM / 2 * np.log(1 - (length**2 + 2 * width**2 - 3) / JM) - mu * volume
            + lame / 2 * volume**2)


NUS = pytest.mark.parametrize("nu", [0.3, 0.499])
# bound: the deformation is uniform, which hexahedra have without error; the residual
# is solved to 1e-10 of the load, and a strain has at most the loads' over E, times what
# near incompressibility takes from it, 1/(1 - 2 nu)
EXACT = 1e-7


@NUS
def test_cube_of_gents_law_stretches_as_the_principal_stresses_say(nu):
    table = history(f"gent{nu}")["elasticBodies/cube/deformation"]
    for time, length, width in zip(table["time"], table["maxStretch"], table["minStretch"]):
        assert (length, width) == pytest.approx(stretched(nu, time), rel=EXACT)
    # neoHookean would be far beyond: the limit is felt
    assert table["maxStretch"][-1] < 2


@NUS
def test_cube_of_gents_law_stores_the_energy_of_its_stretches(nu):
    stored = history(f"gent{nu}")["elasticBodies/cube/energy"]["elastic"][-1]
    assert stored == pytest.approx(energy(nu, *stretched(nu, 4)), rel=EXACT)


@NUS
def test_newtons_method_finds_gents_law_with_its_tangent(nu):
    corrections = history(f"gent{nu}")["cost"]["corrections"]
    # bound: quadratic convergence from the step before squares the part that is wrong
    # of the first correction, below a half, to 1e-10 in 6, and 2 for the first
    assert corrections.max() <= 8


# Pressure along a channel: Shah and London (1978), Laminar flow forced convection in
# ducts, table 42: f Re = 15.54806 of sides 1:2, with the hydraulic diameter 4 A/P

def gradient_of_pressure(case):
    centre = fields.internal(f"{case}/1/fluid/C")
    p = fields.internal(f"{case}/1/fluid/p")[:, 0]
    # a height away from the inlet and one and a half from the outlet
    away = (centre[:, 0] > 2) & (centre[:, 0] < 3)
    return np.polyfit(centre[away, 0], p[away], 1)[0]


WIDTH, HEIGHT, RATE, VISCOSITY = 4, 2, 8, 1.5
ACROSS = 6, 8, 12


@pytest.fixture(scope="module")
def errors():
    diameter = 2 * WIDTH * HEIGHT / (WIDTH + HEIGHT)
    mean = RATE / WIDTH / HEIGHT
    exact = -2 * 15.54806 * VISCOSITY * mean / diameter**2
    return [gradient_of_pressure(f"channel{n}") / exact - 1 for n in ACROSS]


def test_pressure_falls_along_the_channel_as_in_the_tables(errors):
    # bound: velocities at the middles of faces and a second-order operator take a
    # parabola across n cells wrongly by 1/(2 n^2) each, along both sides
    for n, error in zip(ACROSS, errors):
        assert abs(error) < 2 / n**2


def test_with_second_order(errors):
    # bound: 1.8, as for all that the second-order operator does
    assert convergence.orders(1 / np.array(ACROSS), np.abs(errors))[-1] > 1.8


# Brinkman's porous layer in 0 < z < LAYER of a channel 0 < z < TOP, driven by a force per
# volume: mu u'' - u/K + DRIVE = 0 there, mu u'' + DRIVE = 0 above, u and u' are continuous

LAYERED = 32, 48, 64
MU, RESISTIVITY, DRIVE, LAYER, TOP = 1.5, 60, 6, 0.5, 2


def porous_flow(z):
    depth = np.sqrt(MU / RESISTIVITY)
    darcy = DRIVE / RESISTIVITY
    sinh, cosh = np.sinh(LAYER / depth), np.cosh(LAYER / depth)
    # darcy (1 - cosh(z/depth)) + a sinh(z/depth) in the layer, and
    # (TOP - z) (b - DRIVE/2/MU (TOP - z)) above
    gap = TOP - LAYER
    a, b = np.linalg.solve(
        [[sinh, -gap], [cosh / depth, 1]],
        [-DRIVE / 2 / MU * gap**2 - darcy * (1 - cosh),
         DRIVE / MU * gap + darcy * sinh / depth])
    below = darcy * (1 - np.cosh(z / depth)) + a * np.sinh(z / depth)
    return np.where(z < LAYER, below, (TOP - z) * (b - DRIVE / 2 / MU * (TOP - z)))


@pytest.fixture(scope="module")
def porous_errors():
    """In the mean square, of the layer's and of the clear fluid's cells, and the largest of
    all; over the largest velocity."""
    errors = []
    for n in LAYERED:
        z = fields.internal(f"porous{n}/1/fluid/C")[:, 2]
        u = fields.internal(f"porous{n}/1/fluid/U")[:, 0]
        wrong = abs(u - porous_flow(z)) / abs(porous_flow(z)).max()
        parts = wrong[z < LAYER], wrong[z > LAYER]
        errors.append([np.sqrt(np.mean(part**2)) for part in parts] + [wrong.max()])
    return np.array(errors)


def test_fluid_flows_through_a_porous_layer_as_brinkman_says(porous_errors):
    # bound: what second differences leave of exp(z/depth), (h/depth)^2/24 of it, and as
    # gradients reach over two cells four times that
    depth = np.sqrt(MU / RESISTIVITY)
    for n, error in zip(LAYERED, porous_errors):
        assert error[2] < (TOP / n / depth) ** 2 / 6


def test_in_the_layer_and_above_with_second_order(porous_errors):
    # bound: 1.8, as for all that the second-order operator does. Of the largest error in
    # the layer, beside its edge where u'' jumps, parts of second and third order cancel
    # on coarse cells: 1.3 and 1.6 here, 1.7 and 1.8 on 96 and 128 cells
    h = 1 / np.array(LAYERED)
    for error in porous_errors.T[:2]:
        assert convergence.orders(h, error)[-1] > 1.8


# A law of viscosity

def test_casson_fluid_flows_between_plates_by_the_closed_form():
    """Mean velocity (Casson 1959), tau the stress at the wall and its share that is yield."""
    tau, share = DRIVE * TOP / 2, 1.5 / (DRIVE * TOP / 2)
    exact = tau * TOP / 2 / (3 * MU) * (
        1 - 12 / 5 * np.sqrt(share) + 3 / 2 * share - share**3 / 10)
    means = [fields.internal(f"casson{n}/1/fluid/U")[:, 0].mean() for n in (16, 32)]
    # bound: the smallest rate of 1e-3 lets the plug flow, by 1e-3 of a velocity of 0.5; where
    # it ends the viscosity jumps, in one of n/2 cells, of second order
    assert abs(means[1] / exact - 1) < 2e-3 + 4 / 32**2
    assert abs(means[1] / exact - 1) < abs(means[0] / exact - 1)


# A preconditioner changes how many iterations a solution takes, not the solution

def test_body_moves_the_same_with_another_preconditioner():
    velocities = [history(case)["bodies/tumourCell/velocity"] for case in ("block", "jacobi")]
    expected, found = (np.array([v[k][-1] for k in "xyz"]) for v in velocities)
    # bound: the solver's tolerance, 1e-8, times what a residual of the slowest
    # component adds to a velocity: below the number of cells across, 100
    assert np.linalg.norm(found - expected) < 1e-6 * np.linalg.norm(expected)


def test_it_takes_more_iterations_without_multigrid():
    iterations = [tried(case)[-1].iterations for case in ("block", "jacobi")]
    assert iterations[1] > 3 * iterations[0]
