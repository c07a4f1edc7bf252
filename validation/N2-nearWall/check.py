# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of a sphere that falls onto a wall and of one that rolls along it:
results.csv, nearWall.png."""

import sys

import numpy as np
from scipy.integrate import solve_ivp

from fsbi import plots
from fsbi.bispherical import wall
from fsbi.case import Case
from fsbi.results import Results


RADIUS, SPEED = 4, 1e-3                 # speed without a wall
APPROACH, SAG = 0.1, 0.025              # maxApproach of system/controlDict, gapSag
GAPS = (0.5, 0.2, 0.1, 0.05, 0.04, 0.03, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4)
# Forces Ft, Fr and torques Tt, Tr of a sphere 0.01 radii beside a wall that moves
# along it or turns; from the series of ../N1-gaps/reference.csv
FT, TT, FR, TR = 3.42253297, 0.276517403, 0.36868987, 2.24079765
results = Results("N2")


def exact_fall(first, times):
    """Gaps in radii, by Brenner's resistance."""
    found = solve_ivp(lambda t, gap: [-SPEED / RADIUS / wall(gap[0])], (0, times[-1]), [first],
                      t_eval=times, rtol=1e-9, atol=1e-12)
    return found.y[0]


def count(folder, text):
    with open(f"{folder}/log.fsbiFoam") as log:
        return sum(text in line for line in log)


def fall(quick):
    run = Case("runs/fall")
    gap = run.position("a")[:, 1] / RADIUS - 1
    first = 0.05 if quick else 1
    exact = exact_fall(first, run.time())
    cost = dict(seconds=run.seconds, cells=run.cells)
    for wanted in GAPS:
        if exact[-1] <= wanted < first:
            i = np.argmin(abs(np.log(exact / wanted)))
            # bound: the project's goal: 2 %
            results.add("gap_of_a_falling_sphere", gap[i] / exact[i], 1, 0.02,
                        variant=f"at {wanted:g} radii", **cost)
    # bound: the same at every step's end, not only near these gaps
    results.add("largest_error_of_its_gap_abs", abs(gap / exact - 1).max(), 0, 0.02, **cost)
    closed = 1 - gap[1:] / gap[:-1]
    # bound: what maxApproach allows at the speed of a step's beginning, which is the
    # largest, of a gap that triangles show but for their sag
    results.add("part_of_the_gap_in_a_step_abs", closed.max(), 0, APPROACH * (1 + SAG))
    results.add("rejected_steps_falling_abs", count("runs/fall", "rejected"), 0, 0)
    print(f"    {len(gap)} steps, {run.iterations.mean():.0f} iterations each, {run.seconds:.0f} s")
    return run.time(), gap, exact


def roll():
    run = Case("runs/roll")
    cost = dict(seconds=run.seconds, cells=run.cells)
    velocity, spin = run.velocity("a")[:, 0], -run.spin("a")[:, 2] * RADIUS
    exact = SPEED / (FT - FR * TT / TR)
    # bound: asked for, 1 %; the spin is an eighth of the velocity, by a difference of
    # torques: eight times as much
    results.add("velocity_rolling", velocity[0], exact, 0.01, **cost)
    results.add("spin_rolling", spin[0] / velocity[0], TT / TR, 0.08)
    # bound: asked for
    results.add("velocity_changes_rolling_abs", np.ptp(velocity) / exact, 0, 0.01)
    # bound: asked for, 15 % of the seconds
    results.add("share_of_meshing_rolling_abs", run._seconds("meshing") / run.seconds, 0, 0.15)
    results.add("rejected_steps_rolling_abs", count("runs/roll", "rejected"), 0, 0)
    travel = np.ptp(run.position("a")[:, 0]) / RADIUS
    lift = (run.position("a")[-1, 1] - RADIUS) / RADIUS
    print(f"    rolled {travel:.1f} radii, the gap is {lift:.5f} radii then, "
          f"{run.iterations.mean():.0f} iterations a step, {run.seconds:.0f} s")


def draw(time, gap, exact):
    figure, axes = plots.plt.subplots(1, 2, figsize=(9, 3.8))
    axes[0].semilogy(time / 1e3, exact, color="0.6", label="exact")
    axes[0].semilogy(time / 1e3, gap, "o", color=plots.COLOURS[0], mfc="white", ms=4,
                     label="order 4")
    axes[0].set(xlabel="time (ms)", ylabel="gap over the radius")
    axes[0].legend()
    axes[1].semilogx(exact, 100 * (gap / exact - 1), color=plots.COLOURS[0])
    axes[1].invert_xaxis()
    axes[1].set(xlabel="gap over the radius", ylabel="gap over exact - 1 (%)")
    plots.save(figure, "nearWall.png")


def main():
    quick = sys.argv[1:2] == ["true"]
    history = fall(quick)
    roll()
    if not quick:
        draw(*history)
    results.write()


if __name__ == "__main__":
    main()
