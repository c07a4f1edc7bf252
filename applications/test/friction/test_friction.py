"""Two spheres that drive each other; what friction costs."""
import numpy as np

from fsbi.history import History

RADIUS, RANGE, PRESS, FRICTION, SPIN = 4, 0.02, 1, 0.3, 0.005
INERTIA = 2 / 5 * 4 / 3 * np.pi * RADIUS**5
# As in validation/N6-friction: loads agree within 1e-3 of the largest, normals turn in
# the zone; what presses is integrated to 0.15^2, one-sided for an arm of the zone's radius
LAW = 1e-3 + RANGE / RADIUS
NOISE = 1e-3 + 0.15**2 * np.sqrt(2 * RANGE / RADIUS)


def history(run):
    return History(f"{run}/postProcessing/history.h5")


def vector(table):
    return np.array([table[x] for x in "xyz"]).T


def test_a_wheel_starts_by_what_friction_turns_it():
    h = history("wheels")["bodies/b/angularVelocity"]
    stops = SPIN * INERTIA / (FRICTION * PRESS * RADIUS)
    slips = h["time"] < stops - 1
    rate = (-h["z"] / h["time"])[slips][-1]
    exact = FRICTION * PRESS * RADIUS / INERTIA
    print(rate, exact)
    # bound: besides, half of the distance between them in the arm
    assert abs(rate / exact - 1) < LAW + NOISE / FRICTION + RANGE / RADIUS


def test_wheels_turn_against_each_other():
    w = history("wheels")["bodies/b/angularVelocity"]["z"][-1]
    print(w)
    # bound: what it may slip
    assert abs(w + SPIN) < 1e-3 / RADIUS


def test_friction_leaves_no_force_and_no_torque():
    h = history("wheels")
    force, moment = 0, 0
    for body in "ab":
        f, t = (vector(h[f"bodies/{body}/{x}/effects"]) for x in ("force", "torque"))
        force = force + f
        moment = moment + t + np.cross(vector(h[f"bodies/{body}/position"]), f)
    print(np.abs(force).max(), np.abs(moment).max())
    # bound: positions of 20 to round-off, and loads along their tangents: places turn
    # within the agreement of 1e-3, of the second order of a step's turn, 0.005
    assert np.abs(force).max() < 1e-10 * PRESS
    assert np.abs(moment).max() < 1e-3 * SPIN * PRESS * RADIUS


def test_an_elastic_sphere_feels_no_more_than_the_limit():
    h = history("soft")
    force, press = (np.array(list(h[f"effects/contact/{x}"]["force"]))
                    for x in ("friction", "nearest"))
    along, up = (h["elasticBodies/cell/force/effects"][x] for x in "xy")
    print(force / press, along / up)
    # bound: of every part, to round-off
    assert (force <= FRICTION * press * (1 + 1e-10)).all()
    # against the load, which drives to +x
    assert (along < 0).all() and (force > 0).all()


def test_corrections_are_few():
    for run in ("whole", "wheels", "soft"):
        found = history(run)["cost"]["corrections"]
        print(run, found)
        # bound: a third of those after which a step is halved, of elastic bodies a seventh
        assert (found >= 1).all() and (found <= 8).all()
