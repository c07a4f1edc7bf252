# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The way of the membrane against exact times, loads against those of a rigid
body and of a sphere; write results.csv and draw."""

import glob
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case, cases, reference
from fsbi.leukocyte import Leukocyte
from fsbi.results import Results

BODY, CELL = "leukocyte", Leukocyte(radius=1, Ax=0.25, Ay=0.1, By=0.4)
V = OMEGA = 1.2e-4
TURNS = 10
quick = sys.argv[1] == "true"
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
    results.add("turns", end * OMEGA / (2 * np.pi), TURNS, 1e-5, **cost(run))
    results.add("angle_after_ten_turns_abs", np.sin(np.arctan2(z, w) + OMEGA * end / 2), 0,
                1e-10)
    results.add("travel_in_ten_turns", run.position(BODY)[-1, 0], V * end, 1e-10)
    results.add("meshes_made", run.history["cost"]["meshes"][-1], 1, 0)
    results.add("force_variation_abs", relative(run.force(BODY)), 0, 1e-5)
    results.add("torque_variation_abs", relative(run.torque(BODY)), 0, 1e-5)
    times(run)
    if not quick:
        draw_paths(run)


def times(run):
    """Parts of the time backward and upward, from the ways of points all around
    the middle plane; each is known to one step in a turn."""
    perTurn = (len(run.time())) / TURNS
    ways = [CELL.path(run.history, BODY, angle)
            for angle in np.linspace(0, 2 * np.pi, 200, endpoint=False)]
    steps = np.diff(ways, axis=1)
    results.add("part_of_time_backward_abs", np.mean(steps[:, :, 0] < 0),
                CELL.part_backward(V, OMEGA), 0.2 / perTurn)
    results.add("part_of_time_upward_abs", np.mean(steps[:, :, 1] > 0), 0.5, 0.2 / perTurn)


def draw_paths(run):
    figure, (path, speed) = plots.plt.subplots(2, 1, figsize=(7.2, 6))
    part = int(len(run.time()) / TURNS * 2)
    for i, (start, name) in enumerate(((90, "top"), (180, "rear"), (270, "bottom"))):
        way = CELL.path(run.history, BODY, np.radians(start))[:part]
        path.plot(*way[:, :2].T, color=plots.COLOURS[i], label=name,
                  marker=plots.MARKERS[i], markevery=6, mfc="white")
    path.axhline(0, color="black", lw=2)
    path.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal", ylim=(-0.2, 2.9))
    path.set_title("Points of the membrane that start at the …, two turns", loc="left")
    path.legend(ncols=3, loc="upper left")
    angles = np.linspace(0, 2 * np.pi, 400)
    speed.plot(np.degrees(angles), 1e6 * CELL.velocity(angles, V, OMEGA), color="black",
               lw=1.2, label="exact")
    way = CELL.path(run.history, BODY, 0.0)
    time = run.time()
    middle = -OMEGA * (time[1:part // 2] + time[:part // 2 - 1]) / 2
    speed.plot(np.degrees(middle) % 360,
               1e6 * np.diff(way[:part // 2, 0]) / np.diff(time[:part // 2]),
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
    results.add("sphere_force_abs", force, exact["Fr"], 0.003 if quick else 0.001, **cost(run))
    results.add("sphere_torque", torque, exact["Tr"], 0.02 if quick else 0.01, **cost(run))
    if not quick:
        orders(edges, errors)


def orders(edges, errors):
    results.at_least("sphere_torque_order",
                     np.polyfit(np.log(edges), np.log(errors), 1)[0], 1.8)
    plots.convergence("sphereOrder.png", edges, {"torque": np.array(errors)},
                      xlabel="edge length on the sphere / radius",
                      title="A sphere that turns beside a wall, centre at 1.54 radii")


def observed_order(h, f):
    """p of f = f0 + C h^p through three meshes."""
    ratio = (f[0] - f[1]) / (f[1] - f[2])
    low, high = 0.1, 6
    for _ in range(60):
        p = (low + high) / 2
        if (h[0]**p - h[1]**p) / (h[1]**p - h[2]**p) < ratio:
            low = p
        else:
            high = p
    return p


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
        limit = f[-1] - (f[-2] - f[-1]) / ((h[-2] / h[-1])**2 - 1)
        results.at_least(f"roll_{name}_order", observed_order(h[-3:], f[-3:]), 1.8)
        results.add(f"roll_{name}_against_extrapolated", f[-1], limit, 0.02, **cost(finest))


turns()
rigid()
sphere()
if not quick:
    meshes()
results.write()
