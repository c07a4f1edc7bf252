# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the runs with the exact solution; write results.csv and draw."""

import glob
import os
import re
import sys
from functools import cache

import numpy as np

from fsbi import ellipsoid, plots
from fsbi.case import Case, cases, reference
from fsbi.convergence import orders
from fsbi.results import Results

RATE = 5e-5
RADIUS = 4
NU = 0.133          # of the runs "softening"
SIZES = np.array([0.3, 0.2, 0.135])     # edges over the radius of the runs "order"
# bound: error of the deformation on 22 000 cells (issue). Edges of 0.1 radii meet
# it by the second order that the runs "order" show: see expected_on_fine_mesh()
DEFORMATION = 0.005
quick = sys.argv[1:2] == ["true"]
results = Results("B2")


@cache
def steady():
    """Exact shapes by Ca."""
    return {row["Ca"]: row for row in reference("reference/steady.csv")}


def rate_by_directions(D):
    """Largest rate of the tensor B of a steady shape, with the flow of
    fsbi.ellipsoid, an integral over directions in place of potentials."""
    row = min(reference("reference/StVenantKirchhoff.csv"), key=lambda r: abs(r["D"] - D))
    c, s = np.cos(np.radians(row["theta_deg"])), np.sin(np.radians(row["theta_deg"]))
    F = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) * [row["longest"], row["shortest"],
                                                        row["third"]]
    stress = ellipsoid.saint_venant_kirchhoff(NU)(F) @ F.T / np.linalg.det(F) / row["Ca"]
    L = ellipsoid.velocity_gradient(F, stress, ellipsoid.SHEAR)
    rate = L @ F @ F.T
    return np.abs(rate + rate.T).max()


def references():
    """reference/compute.py, and how far it has converged."""
    rows = reference("reference/convergence.csv")
    for key, name in (("fold_Ca", "fold"), ("D_Ca0.2", "steady"), ("D_startUp", "startUp")):
        # bound: a hundredth of the tightest bound that such a value serves
        results.add(f"reference_{name}_converged", rows[-2][key], rows[-1][key],
                    DEFORMATION / 100)
    # bound: the same; quadrature over the surface knows nothing of the potentials
    results.add("reference_flow_by_surface_abs",
                reference("reference/surface.csv")[-1]["difference"], 0, DEFORMATION / 100)
    # bound: the same; what the shape changes by at a D of 0.4, another way
    results.add("reference_steady_by_directions_abs", rate_by_directions(0.4), 0,
                DEFORMATION / 100)
    # bound: first order in Ca (Goddard and Miller 1967); the next term is Ca^2
    Ca = 0.01
    results.add("reference_small_Ca", steady()[Ca]["D_exact"],
                1.25 * Ca / np.sqrt(1 + 2.25 * Ca**2), Ca**2)


def steady_shapes():
    points = []
    for run in cases("runs/steady*"):
        Ca = float(run.folder.removeprefix("runs/steady"))
        exact = steady()[Ca]
        _, D, angle = run.shape("cell")
        cost = dict(seconds=run.seconds, cells=run.cells)
        # bound: quick, edges of 0.3 radii: nine times that of 0.1, by second order
        results.add(f"deformation_Ca{Ca:g}", D[-1], exact["D_exact"],
                    9 * DEFORMATION if quick else DEFORMATION, **cost)
        # bound: degrees on 22 000 cells (issue); quick: an ellipse known to an error e
        # of its deformation has its axis within e/2 rad, 1.3 degrees; asked is 0.5
        results.add(f"angle_Ca{Ca:g}_abs", angle[-1], exact["theta_deg"],
                    0.5 if quick else 0.2, **cost)
        points.append((Ca, D[-1], angle[-1]))
    if not quick:
        draw_steady(np.array(points))


def draw_steady(points):
    Ca = np.array(sorted(c for c in steady() if c <= 0.3))
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(8.4, 3.6))
    for axes, key, i, label in ((left, "D_exact", 1, "deformation (L-B)/(L+B)"),
                                (right, "theta_deg", 2, "inclination (degrees)")):
        axes.plot(Ca, [steady()[c][key] for c in Ca], color="black", lw=1.2, label="exact")
        axes.plot(points[:, 0], points[:, i], ls="none", marker="o", mfc="white",
                  mew=1.4, color=plots.COLOURS[0], label="fsbiFoam")
        axes.set(xlabel="µγ/G", ylabel=label)
        axes.legend()
    plots.save(figure, "steady.png")


def order():
    runs = cases("runs/order*")
    exact = steady()[0.05]["D_exact"]
    errors = []
    for i, run in enumerate(runs):
        D = run.shape("cell")[1][-1]
        # bound: DEFORMATION at edges of 0.1 radii, by second order
        results.add("deformation", D, exact, DEFORMATION * (SIZES[i] / 0.1)**2,
                    seconds=run.seconds, cells=run.cells, variant=f"mesh{i + 1}")
        errors.append(abs(D / exact - 1))
    observed = orders((SIZES[0], SIZES[-1]), (errors[0], errors[-1]))[0]
    # bound: second order in theory; 0.2 for meshes that are not similar
    results.at_least("order", observed, 1.8)
    plots.convergence("convergence.png", SIZES, {"deformation": np.array(errors)},
                      xlabel="edge length on the sphere / radius",
                      ylabel="error of the deformation",
                      title="Elastic sphere in shear, µγ/G = 0.05")
    return expected_on_fine_mesh(errors[-1])


def fourth_order():
    """Fluid and body by order 4; how the runs "size" end is for sizes_order4()."""
    exact = steady()[0.05]
    edges = {"fourth1": 0.3, "size0.36.Ca0.05.nu0.49": 0.36, "size0.2.Ca0.05.nu0.49": 0.2}
    for name, edge in edges.items():
        if quick and name != "fourth1":
            continue
        run = Case(f"runs/{name}")
        _, D, angle = run.shape("cell")
        cost = dict(seconds=run.processor_seconds, cells=run.cells, variant=name)
        if name == "fourth1":
            # bounds: asked for at 0.2 radii, by fourth order; degrees
            results.add("deformation_order4", D[-1], exact["D_exact"], 0.001 * 1.5**4, **cost)
            results.add("angle_order4_abs", angle[-1], exact["theta_deg"], 0.1 * 1.5**4, **cost)
        stresslet = run.history["elasticBodies/cell/stresslet"]["xy"][-1]
        # bound: that of a rigid sphere with the same edges (B1), the others by fourth
        # order: 0.3 % at 0.2 radii
        results.add("stresslet_order4", stresslet, exact["stresslet_xy"] * RATE * RADIUS**3,
                    0.003 * (edge / 0.2)**4, **cost)


def shape_at(path, Ca):
    """Of the steady shapes at nu 0.133, below a fold."""
    rows = reference(path)
    last = int(np.argmax([row["Ca"] for row in rows])) + 1
    return [float(np.interp(Ca, [row["Ca"] for row in rows[:last]],
                            [row[key] for row in rows[:last]]))
            for key in ("D", "theta_deg")]


def end_time(folder):
    with open(f"{folder}/system/controlDict") as file:
        return float(re.search(r"endTime\s+([^;]+);", file.read())[1])


def towards_fold():
    """By order 4 up to where a law gives way, on 6 000 cells."""
    for folder in sorted(glob.glob("runs/towardsFold*")):
        Ca = float(folder.removeprefix("runs/towardsFold"))
        deformation, inclination = shape_at("reference/StVenantKirchhoff.csv", Ca)
        run = Case(folder)
        time, D, angle = run.shape("cell")
        cost = dict(cells=run.cells, variant=folder.removeprefix("runs/"))
        # bound: all of it
        results.at_least("fold_order4_part_reached", time[-1] / end_time(folder), 0.999, **cost)
        if time[-1] < 0.999 * end_time(folder):
            continue
        # bounds: as of the runs "size" on as many cells
        results.add("fold_order4", D[-1], deformation, 0.005, seconds=run.processor_seconds,
                    **cost)
        results.add("fold_angle_order4_abs", angle[-1], inclination, 0.1 * 1.8**4, **cost)
        iterations_order4("fold", run, cost)


def ratios_order4():
    for run in cases("runs/order4ratio*"):
        variant = run.folder.removeprefix("runs/order4")
        iterations_order4("ratio", run, dict(cells=run.cells, variant=variant))


def sizes_order4():
    """From stiff to soft, strains of 0.02 to 0.6, on 6 000 and on 22 000 cells."""
    for row in reference("reference/compressible.csv"):
        scene = f"Ca{row['Ca']:g}.nu{row['nu']:g}"
        if os.path.isdir(f"runs/size0.36.{scene}"):
            # bounds: asked for at 6 000 and at 22 000 cells
            errors = [size_order4(size, scene, row, bound)
                      for size, bound in ((0.36, 0.005), (0.2, 0.001))]
            # bound: asked for
            results.at_least("size_order4_order", orders((0.36, 0.2), errors)[0], 3,
                             variant=scene)


def size_order4(size, scene, exact, bound):
    """One of the runs; the error of D."""
    run = Case(f"runs/size{size}.{scene}")
    _, D, angle = run.shape("cell")
    cost = dict(cells=run.cells, variant=f"size{size}.{scene}")
    results.add("size_order4", D[-1], exact["D"], bound, seconds=run.processor_seconds, **cost)
    # bound: degrees, asked for at 22 000 cells; at 6 000 by fourth order
    results.add("size_angle_order4_abs", angle[-1], exact["theta_deg"],
                0.1 * (size / 0.2)**4, **cost)
    iterations_order4("size", run, cost)
    return abs(D[-1] / exact["D"] - 1)


def iterations_order4(name, run, cost):
    # bounds: asked for at every stiffness, and that of each of Newton's steps
    record = run.history["cost"]
    results.add(f"{name}_iterations_order4_abs",
                (record["iterations"] / record["corrections"]).max(), 0, 100, **cost)
    results.add(f"{name}_corrections_order4_abs", record["corrections"].max(), 0, 5, **cost)


def expected_on_fine_mesh(error):
    """What second order makes of the finest of the runs "order" at the 0.1 radii
    of the steady shapes: why they have that size."""
    expected = error * (0.1 / SIZES[-1])**2
    # bound: DEFORMATION; edges of 0.105 would just do
    results.add("expected_error_on_fine_mesh_abs", expected, 0, DEFORMATION)
    return expected


def growth(expected):
    """The cells that grow away from the sphere must not hide its own error."""
    coarse, fine = Case("runs/steady0.05"), Case("runs/growth0.05")
    # bound: what DEFORMATION leaves beside the surface's own error
    results.add("growth_adds_Ca0.05", coarse.shape("cell")[1][-1],
                fine.shape("cell")[1][-1], DEFORMATION - expected,
                seconds=fine.seconds, cells=fine.cells)
    # bound: 22 000 cells (issue), and 9 % for what gmsh makes of given edges
    results.add("cells_abs", coarse.cells, 0, 24000)


def start_up():
    run = Case("runs/startUp")
    time, D, _ = run.shape("cell")
    rows = [r for r in reference("reference/startUp.csv") if r["Ca"] == 0.1]
    for row in rows:
        if row["gamma_t"] in (0.1, 0.2, 0.3, 0.5):
            # bound: that of the steady shape, whose mesh this is
            results.add(f"startUp_gt{row['gamma_t']:g}",
                        np.interp(row["gamma_t"], RATE * time, D),
                        row["D_exact_NHinc"], DEFORMATION, seconds=run.seconds, cells=run.cells)


def iterations():
    found = {}
    for folder in glob.glob("runs/ratio*"):
        run = Case(folder)
        r, mesh = folder.removeprefix("runs/ratio").split("_")
        cost = run.history["cost"]
        most = cost["iterations"].max(), cost["corrections"].max()
        found[float(r), int(mesh)] = most
        name, variant = f"ratio{float(r):g}", f"mesh{mesh}"
        # bound: a prototype of the same system in Python, made before, took 75 to
        # 100 iterations and 3 to 5 corrections a step for r = 1e-3 ... 1e3; twice
        # that for another preconditioner, and no more corrections
        results.add(f"iterations_{name}_abs", most[0], 0, 200, cells=run.cells, variant=variant)
        results.add(f"corrections_{name}_abs", most[1], 0, 5, cells=run.cells, variant=variant)
    if not quick:
        draw_iterations(found)


def sinking():
    """Where the fluid leaves no room for a change of volume, stiff spheres move like
    a rigid one."""
    rigid = Case("runs/sinking0").history["bodies/cell/velocity"]["y"][-1] / -1e-3
    for run in cases("runs/sinking1e*"):
        cost = run.history["cost"]
        variant = run.folder.removeprefix("runs/")
        # bounds: as of the runs "ratio"
        results.add("iterations_sinking_abs", cost["iterations"].max(), 0, 200,
                    seconds=run.seconds, cells=run.cells, variant=variant)
        results.add("corrections_sinking_abs", cost["corrections"].max(), 0, 5,
                    cells=run.cells, variant=variant)
        body = "elasticBodies/cell/"
        fallen = run.history[body + "centre"]["y"][-2:]
        speed = np.diff(fallen)[0] / (0.05 / RATE)
        force = -5e-6 * run.history[body + "volume"]["now"][-1]
        # bound: a hundred times the tolerance; strains are below 1e-6
        results.add("mobility_sinking", speed / force, rigid, 1e-4, variant=variant)
        # bound: of the three steps as given none is rejected
        results.at_least("steps_sinking", 3 / len(cost["iterations"]), 1, variant=variant)


def draw_iterations(found):
    figure, axes = plots.plt.subplots()
    for mesh, label in ((1, "coarse mesh"), (2, "fine mesh")):
        keys = sorted(k for k in found if k[1] == mesh)
        axes.plot([k[0] for k in keys], [found[k][0] for k in keys],
                  color=plots.COLOURS[mesh - 1], marker=plots.MARKERS[mesh - 1],
                  mfc="white", label=label)
    axes.set(xscale="log", ylim=(0, None), xlabel="µ/(G Δt)",
             ylabel="Krylov iterations in the worst of three steps")
    axes.set_title("One system: stiff, soft, long or short steps", loc="left")
    axes.legend()
    plots.save(figure, "iterations.png")


def turns():
    run = turns_of("turns", "")
    if quick:
        turns_of("turnsOrder4", "_order4")
        return
    _, D, _ = run.shape("cell")
    settled = D[len(D) // 20:]
    mean = settled.mean()
    # bound: a quarter of the error of this mesh (0.04, edges of 0.3 radii)
    results.add("turns_largest_deviation_abs",
                np.abs(settled / mean - 1).max(), 0, 0.01, cells=run.cells)
    volume = run.history["elasticBodies/cell/volume"]["now"]
    # bound: pressures of viscosity times shear rate = 0.05 G over the bulk modulus,
    # 50 G at nu 0.49
    results.add("turns_volume_change_abs", np.ptp(volume[20:]) / volume[0], 0, 1e-3)

    turned_order4(turns_of("turnsOrder4", "_order4"))


def turned_order4(run):
    """A turn of the surface takes 4 pi shear times."""
    exact = steady()[0.05]["D_exact"]
    time, D, _ = run.shape("cell")
    settled = D[RATE * time > 1]
    cost = dict(cells=run.cells, variant=f"{RATE * time[-1] / (4 * np.pi):.1f} turns")
    # bound: asked for
    results.add("turns_order4_mean_deformation", settled.mean(), exact, 0.002,
                seconds=run.processor_seconds, **cost)
    results.add("turns_order4_largest_deviation_abs", np.abs(settled / exact - 1).max(),
                0, 0.002, **cost)


def turns_of(name, suffix):
    run = Case(f"runs/{name}")
    cost = run.history["cost"]
    # bound: a chosen limit, without theory: no growth, but the mesh of a step may
    # be half as bad again as that of the first, which is new
    results.add(f"turns_iterations_over_first{suffix}_abs",
                cost["iterations"].max() / cost["iterations"][0], 0, 1.5,
                seconds=run.seconds, cells=run.cells)
    return run


def softening():
    """Below the fold the shape becomes steady, above it the run stops with the
    law's own message."""
    below, above = [], []
    for folder in sorted(glob.glob("runs/softening*")):
        run = Case(folder)
        Ca = float(folder.removeprefix("runs/softening"))
        with open(f"{folder}/log.fsbiFoam") as log:
            said = log.read()
        if "FATAL" in said:
            reason = said.split("FATAL")[1]
            # bound: the message is there or it is not
            results.at_least(f"softening_Ca{Ca:g}_says_why",
                             "softens in compression" in reason, 1, cells=run.cells)
            above.append(Ca)
        else:
            time, D, _ = run.shape("cell")
            before = np.interp(time[-1] - 1 / RATE, time, D)
            # bound: a chosen limit, without theory: under 1 % of D, 0.3, in a
            # shear time; above the fold D grows by more in every one
            results.add(f"softening_Ca{Ca:g}_still_changes_abs", abs(D[-1] - before),
                        0, 2e-3, seconds=run.seconds, cells=run.cells)
            below.append(Ca)
    if quick:
        # bound: the one run, at a Ca 1.7 times that of the fold, stops
        results.at_least("softening_stops", len(above), 1)
    else:
        edges = max(below), min(above)
        # bound: half of the bracket, that is, the exact fold is in it
        fold = {row["nu"]: row["Ca"] for row in reference("reference/fold.csv")}[NU]
        results.add("softening_fold", sum(edges) / 2, fold, 0.5 * (edges[1] - edges[0]) / fold)


def main():
    references()
    steady_shapes()
    fourth_order()
    iterations()
    sinking()
    if not quick:
        growth(order())
        start_up()
        sizes_order4()
        ratios_order4()
        towards_fold()
    turns()
    softening()
    results.write()


if __name__ == "__main__":
    main()
