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


@pytest.mark.parametrize("run", ["soft20000", "soft2000000"])
def test_contact_bears_the_load(run):
    # bound: what is left of the way to rest, and loads that bodies are balanced to
    force = pushes(run)[0][-1]
    print(run, force / LOAD)
    assert abs(force / LOAD - 1) < 1e-3


@pytest.mark.parametrize("run, axis", [("soft20000", 1), ("soft2000000", 1),
                                       ("besideRigid", 0), ("twoSoft", 0)])
def test_what_pushes_is_balanced_in_every_step(run, axis):
    # contact, the fluid and the load; bound: rows are solved to 1e-6 of what presses,
    # and a body has a thousand of them
    h = history(run)
    sum_ = sum(np.array(list(h[f"elasticBodies/cell/{x}"].array[:, 1 + axis]))
               for x in ("force/effects", "fluidForce"))
    print(run, np.abs(sum_ / LOAD - 1).max())
    assert np.abs(sum_ / LOAD - 1).max() < 1e-3


@pytest.mark.parametrize("run", ["besideRigid", "twoSoft"])
def test_a_pair_comes_to_rest(run):
    other = centre(run, "a")[:, 0] if run == "twoSoft" \
        else history(run)["bodies/a/position"]["x"]
    approach = -np.diff(centre(run)[:, 0] - other)
    print(run, approach)
    # bound: the fluid lets go within some 50 000 us, 6 pi mu R over E R and the
    # lubrication, so that in 80 000 and more all but a tenth of the speed is gone
    assert abs(approach[-1]) < 0.1 * abs(approach[0])


def test_beside_a_rigid_body_steps_converge_as_elsewhere():
    # bound: the corrections that a step may take where nothing touches
    cost = history("besideRigid")["cost"]
    print(cost["corrections"])
    assert cost["corrections"].max() <= 15 and len(cost["time"]) == 5


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
    # rows of the history begin after the first step; before it there is the weight only
    total = np.concatenate([[LOAD * 4.3], total])
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
