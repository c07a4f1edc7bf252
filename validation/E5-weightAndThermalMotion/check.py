# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling against exact Stokes flow in a ball; thermal motion against theory of
diffusion; write results.csv and draw."""

import glob
import sys

import matplotlib
import numpy as np
from scipy.spatial.transform import Rotation

from fsbi.case import Case
from fsbi.history import History
from fsbi.results import Results
from theory import KT, BesideWall, ellipsoid_diffusion, pair_mobility

matplotlib.use("Agg")
import matplotlib.pyplot as plt             # noqa: E402

RADIUS, BALL = 8, 32                        # um, of the spheres that settle
DENSITY, FLUID, GRAVITY = 1.05, 1, 9.81e-6  # pg/um3, um/us2; viscosity 1
BODY = "tumourCell"
quick = sys.argv[1:2] == ["true"]
results = Results("E5")


def settling_velocity():
    """Of a sphere in the middle of a ball (Haberman & Sayre 1958)."""
    x = RADIUS / BALL
    factor = (1 - x**5) / (1 - 9/4*x + 5/2*x**3 - 9/4*x**5 + x**6)
    force = (DENSITY - FLUID) * 4/3*np.pi*RADIUS**3 * GRAVITY
    return force / (6*np.pi*RADIUS * factor)


def settling():
    exact = settling_velocity()
    for kind in ("settling", "elasticSettling"):
        for i, folder in enumerate(sorted(glob.glob(f"runs/{kind}[0-9]"))):
            run = Case(folder)
            history = History(f"{folder}/postProcessing/history.h5")
            place = history[{"settling": f"bodies/{BODY}/position",
                             "elasticSettling": f"elasticBodies/{BODY}/centre"}[kind]]
            # over the last step, when an elastic sphere has its shape
            velocity = -(np.diff(place["z"]) / np.diff(place["time"]))[-1]
            # bound: drag in this ball was off by 0.6 and 0.3 % at such edges
            # (B1); here cells grow faster: three times that. An elastic
            # sphere deforms antisymmetrically, which leaves its drag to the
            # first order
            bound = (0.02, 0.01)[i]
            name = {"settling": "settling_velocity",
                    "elasticSettling": "settling_velocity_elastic"}[kind]
            results.add(name, velocity, exact, bound, seconds=run.seconds,
                        cells=run.cells, variant=f"mesh{i + 1}")


class Walk:
    """Displacements and turns of every step but the first, in axes of the body where the
    step begins, and the random forces, in the laboratory's."""

    def __init__(self, folder, body="a"):
        self.run = Case(folder)
        history = History(f"{folder}/postProcessing/history.h5")
        q = np.column_stack([history[f"bodies/{body}/orientation"][c] for c in "xyzw"])
        turned = Rotation.from_quat(q)
        to_body = turned[:-1].inv()
        self.way = to_body.apply(np.diff(self.run.position(body), axis=0))
        self.turn = to_body.apply((turned[1:] * to_body).as_rotvec())
        table = history[f"effects/thermalMotion/{body}"]
        self.force = np.column_stack([table["F" + c] for c in "xyz"])
        self.torque = np.column_stack([table["T" + c] for c in "xyz"])
        self.dt = self.run.time()[-1] / len(self.force)
        self.cost = dict(seconds=self.run.seconds, cells=self.run.cells)


def deviates(numbers):
    """Three standard deviations of the mean square of so many independent
    normal numbers, relative."""
    return 3 * np.sqrt(2 / numbers)


def add_square(name, sample, expected, cost, variant=""):
    # bound: 3 sigma; of it the mesh has 1 to 3 % of ways, 3 to 5 % of turns
    results.add(name, np.mean(sample**2), expected, deviates(sample.size), variant=variant,
                **cost)


def sphere():
    walk = Walk("runs/sphere")
    drag, couple, dt = 6*np.pi, 8*np.pi, walk.dt
    add_square("sphere_square_displacement", walk.way, 2*KT*dt/drag, walk.cost)
    add_square("sphere_square_rotation", walk.turn, 2*KT*dt/couple, walk.cost)
    add_square("force_variance", walk.force, 2*KT*drag/dt, walk.cost)
    add_square("torque_variance", walk.torque, 2*KT*couple/dt, walk.cost)
    if not quick:
        # ten steps: they are independent of each other
        position = walk.run.position("a")[::10]
        add_square("sphere_square_displacement_10_steps", np.diff(position, axis=0),
                   20*KT*dt/drag, walk.cost)


def ellipsoid():
    walk = Walk("runs/ellipsoid")
    ways, turns = (2*D*walk.dt for D in ellipsoid_diffusion((2, 1.4, 1)))
    for i, axis in enumerate(("long", "middle", "short")):
        add_square("ellipsoid_square_displacement", walk.way[:, i], ways[i], walk.cost, axis)
        add_square("ellipsoid_square_rotation", walk.turn[:, i], turns[i], walk.cost, axis)
    scaled = np.hstack([walk.way / np.sqrt(ways), walk.turn / np.sqrt(turns)])
    add_square("ellipsoid_square_of_all", scaled, 1, walk.cost)


def pair():
    """What two spheres do together, along the line between them: sum and
    difference have the mobilities own + other and own - other, each of both."""
    a, b = (Walk("runs/pair", name) for name in "ab")
    own, other = (m / (6*np.pi) for m in pair_mobility(3))
    for name, sign in (("together", 1), ("apart", -1)):
        way = (a.way[:, 0] + sign * b.way[:, 0]) / np.sqrt(2)
        add_square(f"pair_square_{name}", way, 2*KT*a.dt*(own + sign*other), a.cost)


def beside_wall():
    run = Case("runs/wall")
    history = History("runs/wall/postProcessing/history.h5")
    gap = history["bodies/a/position"]["y"] - 1
    weight = 0.5 * 4/3*np.pi * GRAVITY
    theory = BesideWall(weight, strength=2e-6, reach=0.5)
    steps = len(gap)
    dt = run.time()[-1] / steps
    cost = dict(seconds=run.seconds, cells=run.cells)

    # bound: 3 sigma of a mean over as many steps from the same start, by
    # runs of the Langevin equation
    sigma = theory.deviation(0.5, dt, steps)
    results.add("mean_gap_abs", np.mean(gap), theory.mean(), 3*sigma, **cost)

    draw(gap, theory)


def drift():
    """Nothing acts on the sphere beside the wall: the part of every step that is
    not the mobility where it began times the random force is on average the
    drift kT dM/dz."""
    run = Case("runs/drift")
    gap = History("runs/drift/postProcessing/history.h5")["bodies/a/position"]["y"] - 1
    theory = BesideWall(0, strength=0, reach=1)
    force = run.force("a", "effects")[1:, 1]
    speed = np.diff(gap) / (run.time()[-1] / len(gap))
    found = speed - theory.mobility(gap[:-1])*force
    expected = KT*theory.slope(gap[:-1])
    # bound: each is the square of a normal number: 3 sigma of their sum
    bound = 3*np.sqrt(2*np.sum(expected**2)) / np.sum(expected)
    results.add("drift_beside_wall", np.mean(found), np.mean(expected), bound,
                seconds=run.seconds, cells=run.cells)


def draw(gap, theory):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.5))
    axes[0].plot(gap, lw=0.8)
    axes[0].set(xlabel="step", ylabel="gap (µm)", title="A heavy sphere of 1 µm above a wall")
    axes[1].hist(gap, bins=20, density=True, alpha=0.5, label="fsbiFoam")
    axes[1].plot(theory.gaps, theory.density, "k", label="Boltzmann")
    axes[1].set(xlabel="gap (µm)", ylabel="density (1/µm)", xlim=(0, 1.5))
    axes[1].legend()
    figure.tight_layout()
    figure.savefig("besideWall.png", dpi=110)


def main():
    settling()
    sphere()
    ellipsoid()
    if not quick:
        pair()
    beside_wall()
    drift()
    results.write()


if __name__ == "__main__":
    main()
