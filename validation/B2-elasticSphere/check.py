# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the runs with the exact solution; write results.csv and draw."""

import glob
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case, cases, reference
from fsbi.results import Results

RATE = 5e-5
FOLD = 0.2353       # largest Ca with a steady ellipsoid, St.Venant-Kirchhoff, nu 0.133
quick = sys.argv[1] == "true"
results = Results("B2")
steady = {row["Ca"]: row for row in reference("reference/steady.csv")}


def steady_shapes():
    points = []
    for run in cases("runs/steady*"):
        Ca = float(run.folder.removeprefix("runs/steady"))
        exact = steady[Ca]
        _, D, angle = run.shape("cell")
        cost = dict(seconds=run.seconds, cells=run.cells)
        results.add(f"deformation_Ca{Ca:g}", D[-1], exact["D_exact"],
                    0.05 if quick else 0.005, **cost)
        results.add(f"angle_Ca{Ca:g}_abs", angle[-1], exact["theta_deg"],
                    0.5 if quick else 0.2, **cost)
        points.append((Ca, D[-1], angle[-1]))
    if not quick:
        draw_steady(np.array(points))


def draw_steady(points):
    Ca = np.array(sorted(c for c in steady if c <= 0.3))
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(8.4, 3.6))
    for axes, key, i, label in ((left, "D_exact", 1, "deformation (L-B)/(L+B)"),
                                (right, "theta_deg", 2, "inclination (degrees)")):
        axes.plot(Ca, [steady[c][key] for c in Ca], color="black", lw=1.2, label="exact")
        axes.plot(points[:, 0], points[:, i], ls="none", marker="o", mfc="white",
                  mew=1.4, color=plots.COLOURS[0], label="fsbiFoam")
        axes.set(xlabel="µγ/G", ylabel=label)
        axes.legend()
    plots.save(figure, "steady.png")


def order():
    runs, sizes = cases("runs/order*"), np.array([0.3, 0.2, 0.135])
    exact = steady[0.05]["D_exact"]
    errors = []
    for i, run in enumerate(runs):
        D = run.shape("cell")[1][-1]
        results.add(f"deformation_mesh{i + 1}", D, exact, 0.05,
                    seconds=run.seconds, cells=run.cells)
        errors.append(abs(D / exact - 1))
    observed = np.log(errors[0] / errors[-1]) / np.log(sizes[0] / sizes[-1])
    results.at_least("order", observed, 1.8)
    plots.convergence("convergence.png", sizes, {"deformation": np.array(errors)},
                      xlabel="edge length on the sphere / radius",
                      ylabel="error of the deformation",
                      title="Elastic sphere in shear, µγ/G = 0.05")


def growth():
    """The cells that grow away from the sphere must not hide its own error."""
    coarse, fine = Case("runs/steady0.05"), Case("runs/growth0.05")
    results.add("growth_adds_Ca0.05", coarse.shape("cell")[1][-1],
                fine.shape("cell")[1][-1], 0.002,
                seconds=fine.seconds, cells=fine.cells)
    results.add("cells_abs", coarse.cells, 0, 24000)


def start_up():
    run = Case("runs/startUp")
    time, D, _ = run.shape("cell")
    rows = [r for r in reference("reference/startUp.csv") if r["Ca"] == 0.1]
    for row in rows:
        if row["gamma_t"] in (0.1, 0.2, 0.3, 0.5):
            results.add(f"startUp_gt{row['gamma_t']:g}",
                        np.interp(row["gamma_t"], RATE * time, D),
                        row["D_exact_NHinc"], 0.005, seconds=run.seconds, cells=run.cells)


def iterations():
    found = {}
    for folder in glob.glob("runs/ratio*"):
        run = Case(folder)
        r, mesh = folder.removeprefix("runs/ratio").split("_")
        cost = run.history["cost"]
        most = cost["iterations"].max(), cost["corrections"].max()
        found[float(r), int(mesh)] = most
        name = f"ratio{float(r):g}_mesh{mesh}"
        results.add(f"iterations_{name}_abs", most[0], 0, 200, cells=run.cells)
        results.add(f"corrections_{name}_abs", most[1], 0, 5, cells=run.cells)
    if not quick:
        draw_iterations(found)


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
    run = Case("runs/turns")
    cost = run.history["cost"]
    results.add("turns_iterations_over_first_abs",
                cost["iterations"].max() / cost["iterations"][0], 0, 1.5,
                seconds=run.seconds, cells=run.cells)
    if quick:
        return
    _, D, _ = run.shape("cell")
    settled = D[len(D) // 20:]
    mean = settled.mean()
    results.add("turns_largest_deviation_abs",
                np.abs(settled / mean - 1).max(), 0, 0.01, cells=run.cells)
    volume = run.history["elasticBodies/cell/volume"]["now"]
    results.add("turns_volume_change_abs", np.ptp(volume[20:]) / volume[0], 0, 1e-3)


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
            results.at_least(f"softening_Ca{Ca:g}_says_why",
                             "softens in compression" in reason, 1, cells=run.cells)
            above.append(Ca)
        else:
            time, D, _ = run.shape("cell")
            before = np.interp(time[-1] - 1 / RATE, time, D)
            results.add(f"softening_Ca{Ca:g}_still_changes_abs", abs(D[-1] - before),
                        0, 2e-3, seconds=run.seconds, cells=run.cells)
            below.append(Ca)
    if quick:
        results.at_least("softening_stops", len(above), 1)
    else:
        edges = max(below), min(above)
        results.add("softening_fold", sum(edges) / 2, FOLD, 0.5 * (edges[1] - edges[0]) / FOLD)


steady_shapes()
iterations()
if not quick:
    order()
    growth()
    start_up()
turns()
softening()
results.write()
