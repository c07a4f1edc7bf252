"""Elastic spheres that loads press on a wall, a rigid sphere and each other."""
import numpy as np
import pytest

from fsbi.history import History

RADIUS, GAP = 4, 0.1
LOAD = 3.17e-5 * 4 / 3 * np.pi * RADIUS**3


def history(run):
    return History(f"{run}/postProcessing/history.h5")


def centre(run, body="cell"):
    return np.array([history(run)[f"elasticBodies/{body}/centre"][x] for x in "xyz"]).T


def pushes(run):
    """Sum of the forces of contact, distance"""
    contact = history(run)["effects/contact/nearest"]
    return contact["force"], contact["distance"]


@pytest.mark.parametrize("run", ["soft20000", "soft2000000", "besideRigid", "twoSoft"])
def test_contact_bears_the_load(run):
    # bound: what is left of the way to rest, and loads that bodies are balanced to:
    # 1e-3. Forces of asperities of a sphere do not all have the direction of their sum:
    # by half the square of the zone's radius over the sphere's, which is below 0.4
    force = pushes(run)[0][-1]
    print(run, force / LOAD)
    tilted = 0 if run.startswith("soft") else 0.4**2 / 2
    assert -1e-3 < force / LOAD - 1 < 1e-3 + tilted


@pytest.mark.parametrize("run", ["soft20000", "soft2000000", "besideRigid", "twoSoft"])
def test_surfaces_stay_apart(run):
    assert (pushes(run)[1] > GAP).all()


def test_rests_there_in_steps_a_hundred_times_apart():
    # bound: at rest steps make no difference but for what is left of the way: 1e-3 of
    # the radius
    a, b = (centre(run)[-1, 1] for run in ("soft20000", "soft2000000"))
    print(a, b)
    assert abs(a - b) < 1e-3 * RADIUS
    steps = np.diff(centre("soft2000000")[:, 1])
    assert abs(steps[-1]) < 1e-6 * RADIUS


@pytest.mark.parametrize("run", ["soft20000", "soft2000000"])
def test_loses_energy_only(run):
    h = history(run)
    total = (h["elasticBodies/cell/energy"]["elastic"] + h["effects/contact/nearest"]["energy"]
             + LOAD * centre(run)[:, 1])
    lost = total[0] - total[-1]
    print(run, np.diff(total).max() / lost)
    # bound: loads balanced to 1e-3, along the way of every step, of what is lost in all;
    # the weight is that of the mesh's volume
    assert (np.diff(total) < 1e-3 * lost).all()


def test_two_elastic_spheres_stay_where_they_are():
    # bound: the triangles on both sides differ: their sagitta, 1.2^2/(6 radii)
    a, b = (centre("twoSoft", body)[-1, 0] for body in ("a", "cell"))
    print(a, b)
    assert abs(a + b - 40) < 1.2**2 / (6 * RADIUS)
    assert b - a < 2 * RADIUS + GAP
