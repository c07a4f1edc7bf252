# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the resistance of the helix and how it swims with boundary integrals
(reference/) and with resistive-force theory; write results.csv and draw."""

import csv
import glob
import re
import sys
from functools import cache

import numpy as np

from fsbi import plots, resistive_force
from fsbi.case import Case, reference
from fsbi.convergence import overall_order
from fsbi.results import Results
from reference import boundary_integral

quick = sys.argv[1:2] == ["true"]
results = Results("S7")
NAMES = ("a", "b", "c", "axis_held", "axial_only")
TORQUE, SPIN, TURNS, FILAMENT = 2.03e-2, 6.2832e-5, 5, 0.1


@cache
def integrated():
    """By the pitch, of boundary integrals."""
    return {row["pitch"]: row for row in reference("reference/helix.csv")}


@cache
def abbott():
    """Advance of the tight helix by resistive-force theory."""
    a, b, _ = resistive_force.helix(resistive_force.lighthill)
    return -b / a


def read(folder):
    with open(folder + "/postProcessing/resistance.csv") as file:
        rows = list(csv.reader(file))
    R = np.array([[float(x) for x in row[2:8]] for row in rows[1:]])
    with open(folder + "/log.fsbiResistance") as file:
        log = file.read()
    cells = int(re.search(r"Cells: (\d+)", log)[1])
    seconds = float(re.search(r"^ *total +([0-9.]+) s", log, re.M)[1])
    return R, dict(seconds=seconds, cells=cells)


def measures(R):
    """Axial laws, and advance per angle: only axial motion; any translation."""
    free = np.linalg.solve(R[:3, :3], -R[:3, 5])
    return {"a": R[2, 2], "b": 0.5 * (R[2, 5] + R[5, 2]), "c": R[5, 5],
            "axis_held": free[2], "axial_only": -R[2, 5] / R[2, 2]}


def asymmetry(R):
    scale = np.sqrt(np.outer(np.diag(R), np.diag(R)))
    return np.abs((R - R.T) / scale).max()


def integrals():
    """The reference itself: what its finest meshes leave open, one coarse mesh made
    again, and spheres."""
    # bound: what the independent computation was asked to reach, a sixtieth of the
    # 3 % to be judged by it
    results.add("reference_uncertainty_abs", integrated()[2]["uncertainty"], 0, 5e-4)
    coarse = [row for row in reference("reference/convergence.csv")
              if (row["pitch"], row["around"]) == (2, 4)][0]
    R, _ = boundary_integral.resistance(boundary_integral.Filament(), 4)
    again = boundary_integral.measures(R)
    # bound: digits of the file
    results.add("reference_made_again_abs",
                max(abs(again[q] / coarse[q] - 1) for q in ("a", "b", "c")), 0, 1e-6)
    drags, torques, edges = [], [], (8, 12, 16)
    for around in edges:
        R, _ = boundary_integral.resistance(boundary_integral.Filament(turns=0), around)
        drags.append(R[1, 1] / (6 * np.pi * FILAMENT) - 1)
        torques.append(abs((R[2, 2] - R[0, 0]) / (8 * np.pi * FILAMENT**3) - 1))
    # bound: Stokes's drag, to a fifth of the uncertainty asked for
    results.add("reference_sphere_drag_abs", np.abs(drags).max(), 0, 1e-4)
    # bound: constant tractions are of second order
    results.at_least("reference_sphere_torque_order",
                     -overall_order(edges, torques), 1.8)


def edges():
    second = meshes("edge", "")
    for edge, errors in meshes("fourth", "order4").items():
        for name, error in errors.items():
            # bound: what fourth order is for, a quarter of the error on the same cells
            results.at_least(f"{name}_error_of_order2_over_order4_edge{edge:g}",
                             second[edge][name] / error, 4)
    if len(second) > 2:
        draw_edges(np.array(list(second)),
                   {name: [e[name] for e in second.values()] for name in NAMES})


def meshes(folders, variant):
    """Finer and finer meshes of the tight helix: errors by the edge."""
    lengths = sorted((float(f.removeprefix(f"runs/{folders}"))
                      for f in glob.glob(f"runs/{folders}*")), reverse=True)
    errors = {}
    for edge in lengths:
        R, cost = read(f"runs/{folders}{edge:g}")
        for name, value in measures(R).items():
            # bound: the project's case table, 3 %
            results.add(f"{name}_edge{edge:g}", value, integrated()[2][name], 0.03, **cost,
                        variant=variant)
        errors[edge] = {name: abs(value / integrated()[2][name] - 1)
                        for name, value in measures(R).items()}
        # bound: a fifteenth of the 3 %, so that neither half of the matrix decides
        results.add(f"asymmetry_edge{edge:g}_abs", asymmetry(R), 0, 2e-3, **cost,
                    variant=variant)
    return errors


def draw_edges(lengths, errors):
    figure, axes = plots.plt.subplots()
    for i, (name, error) in enumerate(errors.items()):
        axes.loglog(lengths, error, marker="o", mfc="white", color=plots.COLOURS[i % 5],
                    ls="-" if i < 3 else "--", label=name.replace("_", " "))
    axes.loglog(lengths, 0.02 * (lengths / lengths[0]) ** 2, color="0.6", ls=":",
                label="second order")
    axes.set(xlabel="edge on the filament (radius 0.1 µm)", ylabel="relative error")
    axes.set_title("Helix: resistance and advance", loc="left")
    axes.legend(fontsize=9)
    plots.save(figure, "convergence.png")


def steady():
    """A torque and a given speed, without inertia: Stokes flow is linear, the advance
    per angle is one number of the helix."""
    advance = {}
    for name in ("Torque", "Spin"):
        run = Case(f"runs/steady{name}")
        cost = dict(seconds=run.seconds, cells=run.cells)
        u, w = run.velocity("swimmer")[-1, 2], run.spin("swimmer")[-1, 2]
        advance[name] = u / w
        # bound: the project's case table, 3 %
        results.add(f"advance_by_{name.lower()}", u / w, integrated()[2]["axis_held"], 0.03, **cost)
        # bound: as before. Against Abbott's b/a [4.13] (Gaskin 2018: 1.45 and 0.86)
        results.add(f"advance_by_{name.lower()}_over_Abbott", u / w / abbott(),
                    integrated()[2]["axis_held"] / abbott(), 0.03)
        if name == "Torque":
            # bound: the project's case table, 3 %
            results.add("speed_by_torque", w, TORQUE * mobility()[2], 0.03, **cost)
    # bound: linear on one mesh, so ten times the solver's tolerance of 1e-6
    results.add("advance_by_torque_over_by_spin", advance["Torque"] / advance["Spin"], 1,
                1e-5)


def exact(row):
    """Of (y, z, turning about z)."""
    return np.array([[row["yy"], row["yz"], row["yw"]], [row["yz"], row["a"], row["b"]],
                     [row["yw"], row["b"], row["c"]]])


def mobility():
    """Velocities of the tight helix by a torque of 1."""
    return np.linalg.solve(exact(integrated()[2]), [0, 0, 1])


def inertia():
    """Mass and moment of inertia about z of a tube of density 1: its sections are
    across the centreline, whose sine of the helix angle is sin; the hemispheres are
    left at the radius of the helix."""
    arc = TURNS * np.hypot(2 * np.pi, 2)
    sin = TURNS * 2 * np.pi / arc
    mass = np.pi * FILAMENT**2 * (arc + 4 / 3 * FILAMENT)
    return mass, mass * (1 + FILAMENT**2 / 4 * (2 + sin**2))


def from_rest(R, t, torque):
    """u along z and w after times t at a given torque, or None: with the given
    speed w from the start."""
    m, turned = inertia()
    if torque is None:
        values, modes = np.linalg.eigh(R[:2, :2] / m)
        end = np.linalg.solve(R[:2, :2], -R[:2, 2])
        way = end[:, None] - modes @ (np.exp(-np.outer(values, t)) * (modes.T @ end)[:, None])
        return way[1] * SPIN, np.full(len(t), SPIN)
    root = np.sqrt([m, m, turned])
    values, modes = np.linalg.eigh(R / np.outer(root, root))
    end = np.linalg.solve(R, [0, 0, torque]) * root
    way = end[:, None] - modes @ (np.exp(-np.outer(values, t)) * (modes.T @ end)[:, None])
    return way[1] / root[1], way[2] / root[2]


def starts():
    """From rest with the helix's own inertia: figures 4.22 and 4.23."""
    figure, (left, right) = plots.plt.subplots(1, 2, figsize=(10.4, 4.4))
    t = np.linspace(0, 0.15, 300)
    for axes, name, torque in ((left, "Torque", TORQUE), (right, "Spin", None)):
        run = Case(f"runs/start{name}")
        u = run.velocity("swimmer")[:, 2]
        end = mobility()[1] * TORQUE if torque else integrated()[2]["axis_held"] * SPIN
        made = from_rest(exact(integrated()[2]), run.time(), torque)[0]
        # bound: 3 % of the project's case table, and 2 % for time: BDF2 with steps of 0.4
        # I/c, the first BDF1, is 1.4 % of the end off in an ordinary differential equation
        results.add(f"start_by_{name.lower()}_abs", np.abs(u - made).max() / end, 0, 0.05)
        unit = 1e6 if torque else 1 / (abbott() * SPIN)
        axes.plot(run.time(), unit * u, ls="none", marker="o", mfc="white", markevery=2,
                  color=plots.COLOURS[0], label="fsbiFoam")
        axes.plot(t, unit * from_rest(exact(integrated()[2]), t, torque)[0], color="black", lw=1.2,
                  label="boundary integral and inertia")
        axes.set(xlabel="time (µs)")
        axes.set_title(f"From rest, given {'torque' if torque else 'speed of turning'}",
                       loc="left")
    draw_literature(left, right, t)
    plots.save(figure, "swimming.png")


def draw_literature(left, right, t):
    a, b, c = resistive_force.helix(resistive_force.lighthill)
    w = TORQUE / (c - b**2 / a) * (1 - np.exp(-t * (c - b**2 / a) / inertia()[1]))
    left.plot(t, 1e6 * abbott() * w, color=plots.COLOURS[1], ls="--",
              label="Abbott, with his viscous torque")
    ramp = 1e6 * abbott() * TORQUE / inertia()[1] * t
    left.plot(t, ramp, color=plots.COLOURS[2], ls="-.", label="Abbott, ω = T t/I [4.19]")
    left.set(ylabel="velocity along the axis (µm/s)", ylim=(0, 40))
    right.axhline(1, color=plots.COLOURS[1], ls="--", label="Abbott [4.13]")
    right.axhline(0.86, color="0.5", ls=":", label="Gaskin 2018, figure 4.23")
    right.set(ylabel="velocity / that of Abbott", ylim=(0, 1.1))
    for axes in (left, right):
        axes.legend(fontsize=8, loc="lower right")


def pitches():
    """Other coils: where resistive-force theory is meant to hold."""
    found = {2: measures(read("runs/edge0.045")[0])}
    for pitch in (1.5, 4, 8):
        R, cost = read(f"runs/pitch{pitch:g}")
        found[pitch] = measures(R)
        for name, value in found[pitch].items():
            # bound: the project's case table, 3 %
            results.add(f"{name}_pitch{pitch:g}", value, integrated()[pitch][name], 0.03, **cost)
    figure, axes = plots.plt.subplots(1, 3, figsize=(12, 4))
    p = np.linspace(1.3, 9, 200)
    for k, (axis, what) in enumerate(zip(axes, ("advance per angle −b/a (µm)",
                                                "drag a (µm)", "coupling −b (µm²)"))):
        for i, (law, label) in enumerate(((resistive_force.lighthill, "Abbott (Lighthill)"),
                                          (resistive_force.gray_hancock, "Gray and Hancock"))):
            a, b, _ = np.array([resistive_force.helix(law, pitch=x) for x in p]).T
            axis.plot(p, (-b / a, a, -b)[k], color=plots.COLOURS[i + 1], ls=("--", "-.")[i],
                      label=label)
        ref = [integrated()[x] for x in sorted(integrated())]
        axis.plot([r["pitch"] for r in ref],
                  [(r["axial_only"], r["a"], -r["b"])[k] for r in ref], ls="none",
                  marker="+", ms=11, color="black", label="boundary integral")
        axis.plot(sorted(found), [(found[x]["axial_only"], found[x]["a"], -found[x]["b"])[k]
                                  for x in sorted(found)],
                  ls="none", marker="o", mfc="none", color=plots.COLOURS[0], label="fsbiFoam")
        axis.set(xlabel="pitch / radius of the helix", ylabel=what, ylim=(0, None))
    axes[0].set_title("A helix of five turns, filament 0.1", loc="left")
    axes[0].legend(fontsize=8)
    plots.save(figure, "pitch.png")


def main():
    integrals()
    edges()
    steady()
    if not quick:
        starts()
        pitches()
    results.write()


if __name__ == "__main__":
    main()
