# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ways of the membrane, by the velocities at the faces of the run's mesh,
against exact times; loads against those of a rigid body and of a sphere; write
results.csv and draw."""

import glob
import sys

import numpy as np

from fsbi import convergence, plots
from fsbi.case import Case, cases, reference
from fsbi.leukocyte import Leukocyte
from fsbi.results import Results
from membrane import Membrane

BODY, CELL = "leukocyte", Leukocyte(radius=1, Ax=0.25, Ay=0.1, By=0.4)
V = OMEGA = 1.2e-4
TURNS = 10
quick = sys.argv[1:2] == ["true"]
results = Results("S1")


def cost(run):
    return dict(seconds=run.seconds, cells=run.cells)


def relative(values):
    """Spread over the mean's size, largest over time."""
    mean = values.mean(axis=0)
    return np.max(np.linalg.norm(values - mean, axis=1)) / np.linalg.norm(mean)


def turns():
    run = Case("runs/turns")
    end = run.time()[-1]
    w, _, _, z = run.history[f"bodies/{BODY}/orientation"].array[-1, 1:]
    # bound: digits of the end time in the dictionary
    results.add("turns", end * OMEGA / (2 * np.pi), TURNS, 1e-5, **cost(run))
    # bound: round-off of 360 steps
    results.add("angle_after_ten_turns_abs", np.sin(np.arctan2(z, w) + OMEGA * end / 2), 0,
                1e-10)
    # bound: round-off of 360 steps
    results.add("travel_in_ten_turns", run.position(BODY)[-1, 0], V * end, 1e-10)
    # bound: the triangles that only travel need no other mesh
    results.add("meshes_made", run.history["cost"]["meshes"][-1], 1, 0)
    # bound: one mesh, one steady flow: the solver's tolerance, 1e-8 of the residual,
    # times a thousand, which is what a residual of the whole flow may mean for a force
    results.add("force_variation_abs", relative(run.force(BODY)), 0, 1e-5)
    results.add("torque_variation_abs", relative(run.torque(BODY)), 0, 1e-5)
    membrane = Membrane(run, BODY, V)
    times(membrane, 0.2 if quick else 0.225)
    if not quick:
        draw_paths(run, membrane)


def times(membrane, edge, name=""):
    """Time of a turn, and its parts backward and upward."""
    # Faces lie below the shape, as on a sphere of radius r by edge^2/(6 r); three
    # times that, as the leukocyte's smallest radii are a third of r
    off = edge**2 / 2
    # bound: the time of a turn is off by as much as the way is
    results.add("turn_of_the_membrane" + name, membrane.turn * OMEGA / (2 * np.pi), 1, off)
    # bound: so is each velocity on the way; root of the mean square over the turn
    exact = CELL.velocity(np.radians(membrane.place), V, OMEGA)
    results.add(f"velocity_of_the_membrane{name}_abs", np.sqrt(np.average(
        (V + membrane.velocity[:, 0] - exact)**2, weights=membrane.time)) / V, 0, off)
    exact = CELL.part_backward(V, OMEGA)
    # bound: what a membrane that is slower by as much would have
    results.add(f"part_of_time_backward{name}_abs", membrane.backward, exact,
                abs(CELL.part_backward(V, OMEGA * (1 - off)) - exact))
    # bound: one half is off by as much, the other is not
    results.add(f"part_of_time_upward{name}_abs", membrane.upward, 0.5, off / 4)


def draw_paths(run, membrane):
    figure, (path, speed) = plots.plt.subplots(2, 1, figsize=(7.2, 6))
    part = int(len(run.time()) / TURNS * 2)
    for i, (start, name) in enumerate(((90, "top"), (180, "rear"), (270, "bottom"))):
        way = CELL.path(run.history, BODY, np.radians(start))[:part]
        path.plot(*way[:, :2].T, color="black", lw=1.2, label=None if i else "exact")
        way = membrane.path(start, run.time()[:part:6]) + [0, run.position(BODY)[0, 1]]
        path.plot(*way.T, color=plots.COLOURS[i], label=name, ls="",
                  marker=plots.MARKERS[i], mfc="white")
    path.axhline(0, color="black", lw=2)
    path.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal", ylim=(-0.2, 2.9))
    path.set_title("Points of the membrane that start at the …, two turns", loc="left")
    path.legend(ncols=3, loc="upper left")
    angles = np.linspace(0, 2 * np.pi, 400)
    speed.plot(np.degrees(angles), 1e6 * CELL.velocity(angles, V, OMEGA), color="black",
               lw=1.2, label="exact")
    shown = slice(0, None, len(membrane.time) // 40)
    speed.plot(membrane.place[shown], 1e6 * (V + membrane.velocity[shown, 0]),
               color=plots.COLOURS[0], ls="", marker="o", mfc="white", label="fsbiFoam")
    speed.axhline(0, color="#999999", lw=0.8)
    speed.set(xlabel="place on the sphere (degrees; 90: top)",
              ylabel="velocity along x (µm/s)", xticks=range(0, 361, 90))
    speed.set_title("Velocity of the membrane", loc="left")
    speed.legend()
    plots.save(figure, "paths.png")


def rigid():
    """Without rotation it is the same problem as a rigid body's; torques are
    about different centres."""
    rigid, slide = Case("runs/rigid"), Case("runs/slide")
    force = rigid.force(BODY)[-1]
    arm = rigid.position(BODY)[-1] - slide.position(BODY)[-1]
    torque = rigid.torque(BODY)[-1] + np.cross(arm, force)
    for name, a, b in (("force", slide.force(BODY)[-1], force),
                       ("torque", slide.torque(BODY)[-1], torque)):
        # bound: a hundred times the solver's tolerance of 1e-8, since two systems of
        # equations are solved to it
        results.add(f"{name}_as_of_rigid_body_abs",
                    np.linalg.norm(a - b) / np.linalg.norm(b), 0, 1e-6, **cost(slide))


def sphere():
    """Ax = Ay = By = 0: a sphere that turns beside a wall."""
    exact = [row for row in reference("reference/wallRolling.csv")
             if abs(row["h_over_a"] - 1.5430806) < 1e-6][0]
    edges, errors = [], []
    for run in reversed(cases("runs/sphere*")):
        edge = float(run.folder.removeprefix("runs/sphere"))
        edges.append(edge)
        spin = 8 * 1e-5
        force = run.force("tumourCell")[-1, 0] / (6 * np.pi * 8 * spin)
        torque = run.torque("tumourCell")[-1, 1] / (8 * np.pi * 64 * spin)
        errors.append(abs(torque / exact["Tr"] - 1))
    # the finest; the force nearly vanishes beside torque over radius
    # bound: a tenth of the torque's
    results.add("sphere_force_abs", force, exact["Fr"], 0.002 if quick else 0.001, **cost(run))
    # bound: twice 3/8 edge^2, edges 0.16 and 0.11 radii, by which the torque is smaller
    # on triangles inside the sphere: they lie edge^2/8 below it on average
    results.add("sphere_torque", torque, exact["Tr"], 0.02 if quick else 0.01, **cost(run))
    if not quick:
        orders(edges, errors)


def orders(edges, errors):
    # bound: second order, 1.8 as for all forces (B1)
    results.at_least("sphere_torque_order",
                     convergence.overall_order(edges, errors), 1.8)
    plots.convergence("sphereOrder.png", edges, {"torque": np.array(errors)},
                      xlabel="edge length on the sphere / radius",
                      title="A sphere that turns beside a wall, centre at 1.54 radii")


def meshes():
    """Loads on the rolling leukocyte on finer and finer meshes: no exact ones
    are known, so the limit is extrapolated."""
    runs = sorted(((float(f.removeprefix("runs/roll")), Case(f))
                   for f in glob.glob("runs/roll*")), reverse=True)
    h = np.array([size for size, _ in runs])
    finest = runs[-1][1]
    for name, values in (("force_x", [run.force(BODY)[-1, 0] for _, run in runs]),
                         ("torque_z", [run.torque(BODY)[-1, 2] for _, run in runs])):
        f = np.array(values)
        limit = convergence.richardson(h, f)
        # bound: second order, 1.8 as for all forces (B1)
        results.at_least(f"roll_{name}_order", convergence.order_of_three(h, f), 1.8)
        # bound: the project's case table for bodies beside a wall (S6), 2 %
        results.add(f"roll_{name}_against_extrapolated", f[-1], limit, 0.02, **cost(finest))


def membranes():
    """The same from one step on finer and finer triangles. The shape's smallest radii
    are a third of r: on edges of 0.3 and 0.2 orders do not show yet."""
    runs = {float(f.removeprefix("runs/membrane")): Case(f)
            for f in glob.glob("runs/membrane*")}
    edges = sorted(runs, reverse=True)
    found = [Membrane(runs[edge], BODY, V) for edge in edges]
    errors = [abs(m.turn * OMEGA / (2 * np.pi) - 1) for m in found]
    # bound: the way lies off by the square of the edges; 1.8 of 2
    results.at_least("turn_of_the_membrane_order",
                     convergence.overall_order(edges, errors), 1.8)
    times(found[-1], edges[-1], "_finest")


def main():
    turns()
    rigid()
    sphere()
    if not quick:
        meshes()
        membranes()
    results.write()


if __name__ == "__main__":
    main()
