# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare the runs with the exact law; write results.csv and draw."""

import glob
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

BODY, SPEED, RADIUS = "tumourCell", 1.4e-4, 8
TAU = 2 * RADIUS**2 / 9
MASS = 4 / 3 * np.pi * RADIUS**3
quick = sys.argv[1:2] == ["true"]
results = Results("S5")


def law(t, tau=TAU):
    return 1 - np.exp(-t / tau)


def recurrence(z, steps):
    """BDF2 for u' = (1 - u)/tau with steps of z tau; the first step BDF1."""
    u = [0, z / (1 + z)]
    for _ in range(steps - 1):
        u.append((z + 2 * u[-1] - 0.5 * u[-2]) / (1.5 + z))
    return np.array(u[1:])


def drag(run):
    """Force over that of Stokes, from the first step."""
    slip = SPEED - run.velocity(BODY)[0, 0]
    return run.force(BODY)[0, 0] / slip / (6 * np.pi * RADIUS)


def curve(name, bound):
    run = Case(f"runs/{name}")
    u = run.velocity(BODY)[:, 0] / SPEED
    worst = np.abs(u - law(run.time())).max()
    # bound: the project's case table, 1 % of U
    results.add(f"u_over_U_{name}_abs", worst, 0, bound, seconds=run.seconds,
                cells=run.cells)
    return run.time(), u


def domain():
    """Drag in the tutorial's domain against one 8 times as wide."""
    here, wide = Case("runs/curve"), Case("runs/wide")
    # bound: the project's case table, 1 %; twice that on edges twice as long
    results.add("drag", drag(here), 1, 0.02 if quick else 0.01,
                seconds=here.seconds, cells=here.cells)
    # bound: the project's case table, 0.2 %
    results.add("drag_excess_by_domain_abs", drag(here) / drag(wide) - 1, 0, 2e-3,
                seconds=wide.seconds, cells=wide.cells)
    fourth = Case("runs/wideOrder4")
    cost = dict(seconds=fourth.seconds, cells=fourth.cells)
    # bound: a quarter of the case table's 1 % (coarse: 2 %), as fourth order is to have at
    # equal cells; the domain is 12 500 radii wide
    results.add("drag_order4", drag(fourth), 1, 0.005 if quick else 0.0025, **cost)
    results.at_least("drag_error_of_order2_over_order4",
                     abs(drag(wide) - 1) / abs(drag(fourth) - 1), 4, **cost)


def long_and_short_steps(folders, suffix, bound):
    """Every step size against the recurrence; stable and right."""
    found = []
    for folder in glob.glob(f"runs/{folders}*"):
        z = float(folder.removeprefix(f"runs/{folders}"))
        run = Case(folder)
        u = run.velocity(BODY)[:, 0] / SPEED
        expected = recurrence(z, len(u))
        worst = np.abs(u / expected - 1).max()
        found.append((z, worst, run))
    for z, worst, run in sorted(found, key=lambda item: item[0]):
        # bound: that of the drag, to which the recurrence owes its tau
        results.add("recurrence_abs", worst, 0, bound,
                    seconds=run.seconds, cells=run.cells, variant=f"step_{z:g}tau{suffix}")


def order_in_time():
    """Error at 2 tau against the law with the drag of this mesh."""
    steps, errors = [], []
    for n in (4, 8, 16, 32, 64):
        run = Case(f"runs/order{n}")
        tau = MASS / (drag(run) * 6 * np.pi * RADIUS)
        u = run.velocity(BODY)[:, 0] / SPEED
        steps.append(2 / n)
        errors.append(abs(u[-1] - law(run.time()[-1], tau)))
    orders = plots.convergence(
        "order.png", np.array(steps), {"velocity at 2 τ": np.array(errors)},
        xlabel="step / relaxation time τ", ylabel="error of the velocity / U",
        title="Time integration: BDF2")
    # bound: BDF2 is of order 2
    results.at_least("order_in_time", orders["velocity at 2 τ"][-1], 1.8)


def draw(curves):
    figure, axes = plots.plt.subplots()
    t = np.linspace(0, 65.5, 300)
    axes.plot(t, law(t), color="black", lw=1.2, label="1 − exp(−t/τ)")
    for i, (label, (time, u)) in enumerate(curves.items()):
        axes.plot(time, u, ls="none", marker=plots.MARKERS[i], mfc="white",
                  color=plots.COLOURS[i], markevery=max(1, len(u) // 20), label=label)
    axes.set(xlabel="time (µs)", ylabel="velocity / U")
    axes.set_title("A tumour cell set in motion, τ = 14.2 µs", loc="left")
    axes.legend(loc="lower right")
    plots.save(figure, "start.png")


def main():
    curves = {"steps of 1.31 µs" if quick else "steps of 0.655 µs": curve("curve", 0.01)}
    domain()
    long_and_short_steps("step", "", 0.02 if quick else 0.01)
    # bound: order 4's of the drag, and 0.2 % by the domain
    long_and_short_steps("order4step", "_order4", 0.007 if quick else 0.0045)
    if not quick:
        curves["steps of 0.1 µs"] = curve("curveFine", 0.01)
        order_in_time()
        draw(curves)
    results.write()


if __name__ == "__main__":
    main()
