# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Can the laws fail? Small scenes are run, which all laws find right; then one
number of the recorded history is changed at a time, and its law must say so.

    doctored.py             writes doctored.csv: law, what was changed, caught
"""

import csv
import os
import sys

import outcome
from laws import LAWS
from record import Run
from scene import Body, Flow, Scene

RATE = 5e-5


def magnet_and_inertia():
    """A magnet that is driven, a heavy bead, one of which a component is given."""
    scene = Scene(Flow("rest"), step=500, steps=4, effects=dict(magnetics=dict(
        fields=dict(main=dict(type="uniform", B=(1e-6, 0, 0))),
        bodies=dict(driven=dict(type="permanent", direction=(0, 1, 0), magnetisation=1e4)))))
    scene.add(Body("driven", radius=3, size=1.2, overdamped=True, force=(0.01, 0, 0),
                   position=(-9, 0, 0)))
    scene.add(Body("heavy", radius=3, size=1.2, density=50, velocity=(0, 1e-4, 0),
                   angularVelocity=(0, 0, 2e-5), force=(0, 0, 0.005)))
    scene.add(Body("held", radius=3, size=1.2, overdamped=True, position=(9, 0, 0),
                   constraints=dict(velocity=(0, 2e-5, 0), velocityAxes="(y)")))
    return scene


def alone_at_rest():
    """A bead that is driven."""
    scene = Scene(Flow("rest"), step=500, steps=2)
    scene.add(Body("driven", radius=3, size=1.2, overdamped=True, force=(0.01, 0, 0)))
    return scene


def bonds_in_shear():
    """A bead on a floor with bonds, below a nearly incompressible cell."""
    scene = Scene(Flow("shear", RATE, floor=True), step=200, steps=4)
    scene.add(Body("bead", radius=3, size=1.2, overdamped=True, position=(0, -16.8, 0)))
    scene.add(Body("cell", radius=4, size=1.8, position=(0, 0, 0),
                   elastic=dict(type="neoHookean", E=2.98 * RATE / 0.1, nu=0.49)))
    scene.effects["bonds"] = dict(
        temperature=310, seed=3, maxStretch=1000,
        molecules={"bead": {"A": dict(density=1)}, "bottom": {"B": dict(density=10)}},
        pairs={"AB": dict(kinds="(A B)", law="Dembo", sts=0.01, k0on=1e-2, k0off=1e-5, s=0.01,
                          **{"lambda": 0.05}, roughness=0.4)})
    return scene


def weight_at_rest():
    """An elastic body and a bead that sink."""
    scene = Scene(Flow("rest"), step=500, steps=4)
    scene.add(Body("cell", radius=4, size=1.6, position=(-8, 0, 0), bodyForce=(0, -4e-5, 0),
                   elastic=dict(type="neoHookean", E=1.3e-3, nu=0.3)))
    scene.add(Body("bead", radius=3, size=1.2, overdamped=True, position=(8, 0, 0),
                   force=(0, -0.01, 0)))
    return scene


def pressed_on_floor():
    """A capsule on a bead on the floor, with contact."""
    scene = Scene(Flow("rest", walls=True), step=2000, steps=4,
                  effects=dict(contact=dict(gap=0.02, pressure=1)))
    scene.add(Body("bead", radius=3, size=1.2, overdamped=True, position=(0, -16.95, 0),
                   force=(0, -0.02, 0)))
    scene.add(Body("rod", "capsule", radius=2, length=4, size=0.9, overdamped=True,
                   position=(0, -11.9, 0), force=(0, -0.02, 0)))
    return scene


def times(factor):
    def change(rows):
        rows *= factor
    return change


def plus(amount, column=0, row=-1):
    def change(rows):
        rows[row, column] += amount
    return change


# law, scene, table, what is done to its rows (without the time)
CHANGES = [
    ("end", magnet_and_inertia, "cost", None),
    ("held", magnet_and_inertia, "bodies/held/velocity", times(1.001)),
    ("balance", magnet_and_inertia, "bodies/driven/force/fluid", times(1.001)),
    ("balance", magnet_and_inertia, "bodies/driven/torque/effects", times(1.01)),
    ("balance", magnet_and_inertia, "bodies/heavy/velocity", times(1.02)),
    ("balance", magnet_and_inertia, "bodies/heavy/torque/fluid", times(1.02)),
    ("balance", weight_at_rest, "elasticBodies/cell/fluidForce", times(1.001)),
    ("balance", bonds_in_shear, "bodies/bead/force/effects", times(1.01)),
    ("motion", magnet_and_inertia, "bodies/driven/position", plus(0.01)),
    ("motion", magnet_and_inertia, "bodies/driven/orientation", times(1.001)),
    ("speeds", bonds_in_shear, "bodies/bead/velocity", times(20)),
    ("speeds", bonds_in_shear, "elasticBodies/cell/centre", plus(5)),
    ("drag", alone_at_rest, "bodies/driven/force/fluid", times(0.6)),
    ("drag", alone_at_rest, "bodies/driven/force/fluid", times(1.25)),
    ("clearance", magnet_and_inertia, "bodies/driven/position", plus(5)),
    ("volume", bonds_in_shear, "elasticBodies/cell/volume", plus(40)),
    ("volume", bonds_in_shear, "elasticBodies/cell/deformation", plus(-2)),
    ("budget", bonds_in_shear, "elasticBodies/cell/energy", plus(1e-4)),
    ("decay", weight_at_rest, "elasticBodies/cell/energy", plus(0.01)),
    ("decay", weight_at_rest, "bodies/bead/force/fluid", times(-1)),
    ("bonds", bonds_in_shear, "effects/bonds/AB", plus(1)),
    ("bonds", bonds_in_shear, "effects/bonds/AB", plus(1e-3, column=4)),
    ("bonds", bonds_in_shear, "effects/bonds/events", plus(-1, column=4)),
    ("contact", pressed_on_floor, "effects/contact/nearest", plus(-0.03)),
    ("contact", pressed_on_floor, "effects/contact/nearest", plus(1e-3, column=2)),
    ("contact", pressed_on_floor, "bodies/bead/position", plus(-0.05, column=1)),
    ("contact", pressed_on_floor, "bodies/rod/position", plus(-0.05, column=1)),
    ("magnets", magnet_and_inertia, "effects/magnetics/driven", plus(1e-4, column=11)),
]


def folder(make):
    return f"runs/{make.__name__}"


def recorded(make):
    return Run(make(), folder(make), outcome.read(folder(make)))


def caught(law, make, table, change):
    judge = next(known for known in LAWS if known.__name__ == law)
    run = recorded(make)
    before = judge(run)
    if change is None:
        run.ended = run.time[-2]
    else:
        change(run.history[table].array[:, 1:])
    after = judge(run)
    print(f"{'ok' if after and not before else 'NOT CAUGHT'} - {law}: {table}: "
          f"{before or after}", flush=True)
    return bool(after) and not before


def main():
    os.makedirs("runs", exist_ok=True)
    for make in dict.fromkeys(make for _, make, _, _ in CHANGES):
        ended = outcome.judge(make(), folder(make))
        print(f"{make.__name__}: {ended} {ended.skipped}", flush=True)
        if ended.verdict != "right":
            return 1
    rows = [(law, table, int(caught(law, make, table, change)))
            for law, make, table, change in CHANGES]
    with open("doctored.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([("law", "table", "caught"), *rows])
    return 0 if all(row[2] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
