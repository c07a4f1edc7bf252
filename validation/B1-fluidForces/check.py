# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare forces and torques with exact values; write results.csv and draw."""

import os
import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case, cases, reference
from fsbi.convergence import overall_order
from fsbi.results import Results

BODY, RADIUS = "tumourCell", 8
FORCE = 6 * np.pi * RADIUS              # per velocity
TORQUE = 8 * np.pi * RADIUS**3          # per angular velocity
quick = sys.argv[1:2] == ["true"]
results = Results("B1")


def cost(run):
    return dict(seconds=run.seconds, cells=run.cells)


def size(run):
    return run.cells ** (-1 / 3)


def far_field():
    """Drag 6 pi mu a U; iterations that do not grow; order. Cells per radius at
    the surface: 3.6, 6, 9.5, 15."""
    runs = cases("runs/drag*")
    errors = []
    # bound: meshes 3 and 4: what was required before, 0.2 % at 75 000 and 0.05 %
    # at 300 000 cells. Meshes 1 and 2 serve the order; required was 1 % at 12
    # cells per radius, which at second order is 11 % and 4 % here. They are held
    # to 3 % and 1 % against changes for the worse; the 3 % was 1 % before 2.2 %
    # were seen
    bounds = [0.03, 0.01, 0.002, 0.0005]
    for i, (run, bound) in enumerate(zip(runs, bounds)):
        drag = run.force(BODY)[-1, 0] / (FORCE * 1.4e-4)
        results.add("drag", drag, 1, bound, **cost(run), variant=f"mesh{i + 1}")
        errors.append(abs(drag - 1))
    if quick:
        return
    iterations = [run.iterations[0] for run in runs]
    growth = max(abs(n / iterations[1] - 1) for n in iterations[1:])
    # bound: required before: flat within 20 %
    results.add("iterations_growth_from_20000_cells_abs", growth, 0, 0.2)
    orders = plots.convergence(
        "dragOrder.png", [size(r) for r in runs], {"drag": np.array(errors)},
        xlabel="cells$^{-1/3}$", title="Drag in an exact Stokes far field")
    # bound: required before: order 1.8 of a second-order scheme
    results.at_least("drag_order", overall_order([size(r) for r in runs[1:]], errors[1:]), 1.8)
    figure, axes = plots.plt.subplots()
    axes.loglog([r.seconds for r in runs], errors, marker="o", mfc="white")
    for run, error in zip(runs, errors):
        axes.annotate(f"{run.cells:,}".replace(",", " "), (run.seconds, error),
                      (6, 4), textcoords="offset points", fontsize=9)
    axes.margins(x=0.15)
    axes.set(xlabel="seconds, meshing and solution", ylabel="relative error of the drag")
    axes.set_title("Work and precision (numbers: cells)", loc="left")
    plots.save(figure, "dragWork.png")
    return orders


def far_field_order4():
    """The same with order 4, at 3.6, 5 and 7.6 cells per radius."""
    runs = cases("runs/fourth*")
    # bound: the project's case table: 0.3 % at 5 000 tetrahedra, 0.05 % at 13 000,
    # 0.03 % at 40 000
    bounds = [0.003, 0.0005, 0.0003]
    for i, (run, bound) in enumerate(zip(runs, bounds)):
        drag = run.force(BODY)[-1, 0] / (FORCE * 1.4e-4)
        results.add("drag_order4", drag, 1, bound, **cost(run), variant=f"mesh{i + 1}")
        # bound: the project's case table: 45 at most, and flat
        results.add("drag_order4_iterations", run.iterations[0], 40, 0.125,
                    variant=f"mesh{i + 1}")


def in_shear():
    """Stresslet of a free sphere, 20/3 pi mu a^3 E, by both orders, edges of 3.6, 5
    and 7.6 cells per radius; those in the cube above give 5 000, 13 000 and 40 000
    cells around it with the same edges."""
    for order in (2, 4):
        sizes = [edge for edge in (0.28, 0.2, 0.132)
                 if os.path.isdir(f"runs/shear{order}-{edge}")]
        errors = [stresslet_error(order, edge) for edge in sizes]
        if len(sizes) == 3:
            # bound: the order in theory, less 0.2 and 0.5 for meshes that are not
            # similar (issue: 3.5)
            results.at_least(f"stresslet_order{order}_order", overall_order(sizes, errors),
                             {2: 1.8, 4: 3.5}[order])


def stresslet_error(order, edge):
    # bound: order 4: 0.3 % with 5 cells per radius (the project's case table), the
    # others by fourth order from it. Order 2: 1 % with 12 cells per radius, asked of
    # the drag before, by second order
    bound = 0.003 * (edge / 0.2)**4 if order == 4 else 0.01 * (edge * 12)**2
    run = Case(f"runs/shear{order}-{edge}")
    found = run.history[f"bodies/{BODY}/stresslet"].array[-1, 1:]
    exact = 20 / 3 * np.pi * RADIUS**3 * 2.5e-5
    results.add(f"stresslet_order{order}", found[2], exact, bound, **cost(run), variant=edge)
    results.add(f"stresslet_other_components_order{order}_abs",
                abs(np.delete(found, 2)).max() / exact, 0, bound, variant=edge)
    return abs(found[2] / exact - 1)


def ball_radius(folder):
    """Of a ball with the volume of fluid and body."""
    with open(os.path.join(folder, "log.checkMesh")) as log:
        volume = float(re.search(r"Total volume = ([0-9.e+]+)", log.read())[1])
    return (3 * volume / (4 * np.pi) + RADIUS**3) ** (1 / 3)


def shell():
    runs = cases("runs/shell*")
    forces, torques = [], []
    for i, run in enumerate(runs):
        x = RADIUS / ball_radius(run.folder)
        drag = (1 - x**5) / (1 - 9/4*x + 5/2*x**3 - 9/4*x**5 + x**6)
        couple = 1 / (1 - x**3)
        force = -run.force(BODY)[-1, 0] / (FORCE * 1e-4)
        torque = -run.torque(BODY)[-1, 2] / (TORQUE * 1e-5)
        # bound: required 1 % at 12 cells per radius, at second order 9, 4 and
        # 1.8 % at the 4, 6 and 9 of these meshes; the finest is held to the 1 %,
        # the others to 3 % against changes for the worse. Quick (5 cells): 5.8 %
        bound = 0.01 if i == 2 else 0.03
        mesh = f"mesh{i + 1}"
        results.add("shell_drag", force, drag, bound, **cost(run), variant=mesh)
        results.add("shell_torque", torque, couple, bound, **cost(run), variant=mesh)
        forces.append(abs(force / drag - 1))
        torques.append(abs(torque / couple - 1))
    if not quick:
        plots.convergence(
            "shellOrder.png", [size(r) for r in runs],
            {"drag": np.array(forces), "torque": np.array(torques)},
            xlabel="cells$^{-1/3}$", title="Sphere in a concentric shell, b = 4 a")


NAMES = "force_parallel", "lever_parallel", "force_normal", "torque_spin"


def wall_values(run):
    """Ft, torque over force and radius (of the parallel motion), Fn, Tn."""
    force, torque = run.force(BODY)[-1], run.torque(BODY)[-1]
    return (force[0] / (FORCE * 1e-4), torque[1] / force[0] / RADIUS,
            -force[2] / (FORCE * 1e-4), -torque[2] / (TORQUE * 1e-5))


def exact_wall(height):
    """The same from the tables; nan where a table lacks the height."""
    values = {}
    for kind in ("Parallel", "Normal"):
        for row in reference(f"reference/wall{kind}.csv"):
            if abs(row["h_over_a"] - height) < 1e-4:
                values.update(row)
    lever = 4 / 3 * values["Tt"] / values["Ft"] if "Tt" in values else np.nan
    return [values.get("Ft", np.nan), lever, values.get("Fn", np.nan),
            values.get("Tn", np.nan)]


def beside_a_wall():
    for height in (1.1276, 1.3, 1.5430806, 3, 5):
        folder = f"runs/wall{height!r}"
        if not os.path.isdir(folder):
            continue
        run = Case(folder)
        for name, value, exact in zip(NAMES, wall_values(run), exact_wall(height)):
            if not np.isnan(exact):
                wall_row(name, f"at_{height:.4g}a", value, exact, run)
    if not quick:
        wall_order()


def wall_row(name, place, value, exact, run):
    """The torque of a parallel motion nearly vanishes: its lever arm is checked,
    in radii."""
    # bound: required 1 % at 12 cells per radius (here 16; quick 10, at second
    # order 1.44 %). The torque is made of the tractions that make the force, at
    # arms of up to a radius: 1 % of them are 0.01 radii of lever arm. It is held
    # to a fifth of that (quick: a third)
    if name == "lever_parallel":
        results.add(f"wall_{name}_abs", value, exact, 0.005 if quick else 0.002,
                    **cost(run), variant=place)
    else:
        results.add(f"wall_{name}", value, exact, 0.0144 if quick else 0.01, **cost(run),
                    variant=place)


def wall_order():
    """In the edge length of the sphere's triangles; all else goes with it."""
    runs = cases("runs/wallOrder*")
    edges = [float(run.folder.removeprefix("runs/wallOrder")) for run in runs]
    exact = exact_wall(1.3)
    errors = {}
    for k, name in ((0, "force parallel"), (2, "force normal"), (3, "torque spin")):
        errors[name] = np.array([abs(wall_values(r)[k] / exact[k] - 1) for r in runs])
        # bound: required before, as for the drag
        results.at_least(f"wall_order_{name.replace(' ', '_')}",
                         overall_order(edges, errors[name]), 1.8)
    plots.convergence(
        "wallOrder.png", edges, errors, xlabel="edge length on the sphere / radius",
        title="Sphere beside a wall, centre at 1.3 radii")


def main():
    far_field()
    far_field_order4()
    in_shear()
    shell()
    beside_a_wall()
    results.write()


if __name__ == "__main__":
    main()
