# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Energies, momenta, frequencies and decay against theory; results.csv."""

import glob
import itertools
import os
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, curve_fit
from scipy.spatial.transform import Rotation

from fsbi import convergence, plots
from fsbi.case import Case
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
results = Results("elasticDynamics")
PERIOD = 619.0478
BODY = "elasticBodies/beam/"
NAMES = {"Newmark": "Newmark", "generalisedAlpha0.8": "generalised α 0.8",
         "Fornberg2": "Fornberg 2"}


def found(pattern):
    return [Case(folder) for folder in sorted(
        glob.glob(f"runs/{pattern}"), key=lambda f: (len(f), f))]


# A free spinning brick

SPIN = np.array([0.02, 0.096, 0.02])
SIDES, CELLS = np.array([2, 1, 0.5]), np.array([8, 4, 2])


def initial(cells):
    """Angular momentum and energy of masses at the centres of hexahedra."""
    square = SIDES**2 / 12 * (1 - 1 / cells**2)
    momentum = np.prod(SIDES) * (square.sum() - square) * SPIN
    return momentum, momentum @ SPIN / 2


# bound: twice the error of the angle in a turn of n steps, 2 pi c (2 pi/n)^2, with
# the error constants of the schemes' frequencies: 1/12 of the mean acceleration,
# which generalisedAlpha's nearly is, 11/24 of the second difference over four
# levels. The body's angular momentum errs as its axes do
def spin_bound(scheme, step):
    return 2 * (2 * np.pi)**3 * (11 / 24 if scheme == "Fornberg2" else 1 / 12) * step**2


# bound: second order; on the quick form's long steps nearer to that than to first
SECOND = 1.5 if quick else 1.8


class Spinning:
    def __init__(self, folder):
        self.run = Case(folder)
        self.name = os.path.basename(folder)
        self.variant = self.name.split(".")[-1]
        table = self.run.history[BODY + "angularMomentum"]
        self.turns = table["time"] * 0.1 / (2 * np.pi)
        self.steps = int(round(1 / self.turns[0]))
        energy = self.run.history[BODY + "energy"]
        self.energy = energy["elastic"] + energy["kinetic"]
        momentum, start = initial(CELLS * (2 if "hexahedra2" in folder else 1))
        if "tetrahedra" in folder:
            momentum, start = table.array[0, 1:], self.energy[0]
        self.momentum = table.array[:, 1:] / np.linalg.norm(momentum)
        self.start = momentum / np.linalg.norm(momentum)
        self.change = np.linalg.norm(self.momentum - self.start, axis=1)
        self.energy = self.energy / start

    def over(self, turns, values):
        """Largest in the first turns."""
        return np.abs(values[self.turns < turns + 1e-6]).max()

    def difference(self, other):
        """Of the angular momenta in the first turn, at common times."""
        every = other.steps // self.steps
        mine = self.momentum[:self.steps]
        return np.linalg.norm(mine - other.momentum[every - 1::every][:len(mine)],
                              axis=1).max()


def scheme_of(spin):
    return spin.name.split(".", 1)[1].rsplit(f".{spin.steps}", 1)[0]


def spinning():
    runs = [Spinning(f) for f in sorted(glob.glob("runs/spin.*"),
                                        key=lambda f: (len(f), f))]
    plain = [r for r in runs if r.variant.isdigit()]
    fourth_spinning([r for r in runs if r.variant.startswith("order4")])
    finest = max(plain, key=lambda r: r.steps)
    for r in runs:
        last = r.turns > r.turns[-1] - 1
        drift = np.polyfit(r.turns[last], r.energy[last], 1)[0]
        print(f"    {r.name}: angular momentum changes by {r.over(1, r.change):.1e}"
              f" in the first turn, {r.change.max():.1e} in {r.turns[-1]:.0f};"
              f" energy {r.energy.min():.5f} to {r.energy.max():.5f}, in the last"
              f" turn by {drift:.1e}")
    steps, errors = [], {}
    for scheme, name in NAMES.items():
        these = [r for r in plain if scheme_of(r) == scheme and r is not finest]
        steps = np.array([1 / r.steps for r in these])
        errors[name] = np.array([r.difference(finest) for r in these])
        for r, step, error in zip(these, steps, errors[name]):
            results.add(f"spin_{scheme}_angular_momentum_abs", error, 0, spin_bound(scheme, step),
                        seconds=r.run.seconds, cells=r.run.cells, variant=f"step_{step:g}tau")
            # what is damped may not come back; bound: none of the schemes gains
            # energy in a linear body, one with strains of 5e-3 is within a fifth
            # of that linear (chosen)
            results.add(f"spin_{scheme}_energy_gain_abs", max(0, r.energy.max() - 1), 0, 1e-3,
                        variant=f"step_{step:g}tau")
    orders = plots.convergence(
        "angularMomentum.png", steps, errors, xlabel="step / turn",
        ylabel="error in time of the angular momentum",
        title="A tumbling elastic brick")
    for scheme, name in NAMES.items():
        results.at_least(f"spin_{scheme}_angular_momentum_order",
                         orders[name][-1], SECOND)
    kept(runs, finest)


def own_inertia(variant):
    """Of the cells of the brick about their own centres, per volume."""
    side = SIDES[0] / CELLS[0]
    square = side**2 / 12 * np.eye(3)
    if "tetrahedra" in variant:
        # around the long diagonal of a cube
        square = np.zeros((3, 3))
        for order in itertools.permutations(range(3)):
            x = side * np.cumsum([np.zeros(3), *np.eye(3)[list(order)]], axis=0)
            d = x - x.mean(axis=0)
            square += d.T @ d / 20 / 6
    return np.trace(square) * np.eye(3) - square


def tumbling(times, own):
    """Angular momentum and energy of a rigid brick less those of its cells about
    their own centres, which the history's sums over the cells' means leave out;
    over the brick's."""
    square = SIDES**2 / 12
    inertia = np.diag(square.sum() - square)
    J = inertia @ SPIN

    def spin(q):
        R = Rotation.from_quat(q).as_matrix()
        return R, R @ np.linalg.solve(inertia, R.T @ J)

    def rate(_, q):
        w = spin(q)[1]
        return 0.5 * np.array([*(w * q[3] + np.cross(w, q[:3])), -w @ q[:3]])

    found = solve_ivp(rate, (0, times[-1]), [0, 0, 0, 1], t_eval=times, rtol=1e-10,
                      atol=1e-12)
    momenta, energies = [], []
    for q in found.y.T:
        R, w = spin(q)
        lacking = R @ own @ R.T @ w
        momenta.append((J - lacking) / np.linalg.norm(J))
        energies.append(1 - w @ lacking / (SPIN @ J))
    return np.array(momenta), np.array(energies), np.linalg.norm(J), SPIN @ J / 2


def fourth_spinning(runs):
    """By order 4 the whole angular momentum is kept, not that of the means."""
    for r in runs:
        table = r.run.history[BODY + "angularMomentum"]
        energy = r.run.history[BODY + "energy"]
        momenta, energies, J, start = tumbling(table["time"], own_inertia(r.variant))
        variant = r.name.removeprefix("spin.Newmark.")
        # bound: of the scheme, see above: of the mesh nothing is left of it
        results.add("spin_order4_angular_momentum_abs",
                    np.linalg.norm(table.array[:, 1:] / J - momenta, axis=1).max(), 0,
                    spin_bound("Newmark", 1 / r.steps), seconds=r.run.seconds,
                    cells=r.run.cells, variant=variant)
        # bound: as of order 2
        gain = (energy["elastic"] + energy["kinetic"]) / start - energies
        results.add("spin_order4_energy_gain_abs", max(0, gain.max()), 0, 1e-3,
                    variant=variant)


def without_time_error(coarse, fine):
    """Largest change in the first turn, extrapolated from two step lengths."""
    a, b = coarse.momentum[:coarse.steps], fine.momentum[1:2 * coarse.steps:2]
    limit = convergence.richardson((2, 1), (a[:len(b)], b))
    return np.linalg.norm(limit - fine.start, axis=1).max()


def kept(runs, finest):
    """What the mesh does to the angular momentum in a turn."""
    # bound: chosen: a thousandth in a turn, on tetrahedra a hundredth
    results.add("spin_angular_momentum_kept_hexahedra_abs",
                finest.over(1, finest.change), 0, 1e-3)
    if quick:
        return
    by_name = {r.name.removeprefix("spin.Newmark."): r for r in runs}
    size = {"hexahedra": ("200", "400"),
            "hexahedra of half the size": ("200.hexahedra2", "400.hexahedra2")}
    for kind, (coarse, fine) in size.items():
        change = without_time_error(by_name[coarse], by_name[fine])
        print(f"    {kind}: angular momentum changes in a turn by {change:.1e}")
    for kind in ("200.tetrahedra1", "200.tetrahedra2"):
        print(f"    {kind}: {by_name[kind].over(1, by_name[kind].change):.1e}")
    coarse = by_name["200.tetrahedra1"]
    results.add("spin_angular_momentum_kept_tetrahedra_abs",
                coarse.over(1, coarse.change), 0, 1e-2)


def draw_energy():
    figure, axes = plots.plt.subplots()
    shown = (50, 100) if quick else (100, 400)
    for i, (scheme, name) in enumerate(NAMES.items()):
        for n, style in zip(shown, ("-", "--")):
            spin = Spinning(f"runs/spin.{scheme}.{n}")
            axes.plot(spin.turns, spin.energy, style, color=plots.COLOURS[i],
                      lw=1.2, label=f"{name}, {n}")
    axes.set(xlabel="turns", ylabel="energy / energy at the start")
    axes.set_title("A tumbling elastic brick; scheme, steps per turn", loc="left")
    axes.legend(fontsize=9, ncol=3, loc="upper center",
                bbox_to_anchor=(0.45, -0.17))
    plots.save(figure, "energy.png")


# A cantilever

def timoshenko(length=10, thickness=1, share=5 / 6):
    """First angular frequency; E = rho = 1, nu = 0, width 1."""
    area, inertia = thickness, thickness**3 / 12
    shear = share * area / 2

    def ends(w):
        # deflection, rotation, moment, shear force along the beam
        slope = np.zeros((4, 4))
        slope[0, 1], slope[0, 3] = 1, 1 / shear
        slope[1, 2] = 1 / inertia
        slope[2, 1], slope[2, 3] = -inertia * w**2, -1
        slope[3, 0] = -area * w**2
        return np.linalg.det(expm(slope * length)[2:, 2:])

    bending = 1.8751040687**2 * np.sqrt(inertia / area) / length**2
    return brentq(ends, 0.8 * bending, 1.05 * bending), bending


def deflection(run):
    table = run.history[BODY + "centre"]
    return table["time"], table["y"] - 0.5


def wave(t, c, s, w, d):
    return np.exp(-d * t) * (c * np.cos(w * t) + s * np.sin(w * t))


def fit(run):
    """Frequency and rate of decay of the free vibration."""
    t, y = deflection(run)
    free = t > 1.02 * PERIOD
    t, y = t[free] - t[free][0], y[free] / np.abs(y).max()
    return curve_fit(wave, t, y, p0=(1, 0, 2 * np.pi / PERIOD, 0))[0][2:]


def steps_per_period(run):
    return int(run.folder.split(".")[-1])


def true_frequency(run):
    """Without Newmark's own error, (w dt)^2/12; and the rate of decay."""
    dt = PERIOD / steps_per_period(run)
    w, decay = fit(run)
    return 2 / dt * np.tan(w * dt / 2), decay


def frequency():
    theory, bending = timoshenko()
    print(f"    Timoshenko {theory:.7f}, Euler and Bernoulli {bending:.7f}"
          f" ({100 * (bending / theory - 1):.2f} %)")
    across, errors, values = [], [], []
    for run in found("frequency.*"):
        n = int(run.folder.split(".")[-2])
        w = true_frequency(run)[0]
        # bound: n cells take 1/n^2 of a bending moment wrongly (midpoint rule), and
        # the frequency goes with its root
        results.add("frequency", w, theory, 0.5 / n**2, seconds=run.seconds, cells=run.cells,
                    variant=f"mesh{n}")
        across.append(n)
        values.append(w)
    if not quick:
        limit = convergence.richardson(1 / np.array(across), values)
        # bound: half of what Timoshenko's theory takes off Euler's and Bernoulli's
        results.add("frequency_limit_against_Timoshenko", limit, theory,
                    (bending / theory - 1) / 2)
        errors = np.abs(np.array(values) / limit - 1)
        print(f"    limit {limit:.7f}, errors {errors}")


def fourth_frequency():
    theory, bending = timoshenko()
    for run in found("order4.*"):
        # bound: half of what Timoshenko's theory takes off Euler's and Bernoulli's
        results.add("frequency_order4", true_frequency(run)[0], theory,
                    (bending / theory - 1) / 2, seconds=run.seconds, cells=run.cells,
                    variant=f"tetrahedra_{run.folder.split('.')[-2]}_across")


def order_in_time():
    reference = found("order.Newmark.*")[-1]
    exact = deflection(reference)[1]
    scale = np.abs(exact).max()
    steps, errors = [], {}
    for scheme in NAMES:
        runs = [r for r in found(f"order.{scheme}.*")
                if r.folder != reference.folder]
        steps = np.array([1 / steps_per_period(r) for r in runs])
        every = [steps_per_period(reference) // steps_per_period(r) for r in runs]
        errors[NAMES[scheme]] = np.array([
            np.abs(deflection(r)[1] - exact[n - 1::n]).max() / scale
            for r, n in zip(runs, every)])
    orders = plots.convergence(
        "order.png", steps, errors, xlabel="step / period",
        ylabel="largest error / largest deflection", title="A vibrating cantilever")
    for scheme, name in NAMES.items():
        results.at_least(f"vibration_{scheme}_order_in_time", orders[name][-1], SECOND)


# Kelvin and Voigt

def damping():
    """eta = 4.926, mu = 1/2: elastic and viscous forces are proportional, so
    that the decay is w^2 tau/2 with w the frequency without damping."""
    tau = 2 * 4.926
    runs = found("damped.*")
    lacks = {}
    for run in runs:
        n = int(run.folder.split(".")[-2])
        if steps_per_period(run) == 100:
            w = true_frequency(found(f"frequency.Newmark.{n}.*")[0])[0]
            decay = true_frequency(run)[1]
            lacks[n] = 1 - decay / (w**2 * tau / 2)
            # bound: what has no viscosity (see README) is of second order; the
            # factor is chosen
            results.add("damped_decay", decay, w**2 * tau / 2, 2.5 / n**2, seconds=run.seconds,
                        cells=run.cells, variant=f"mesh{n}")
    # bound: second order
    results.at_least("damped_decay_order",
                     convergence.orders((1 / 8, 1 / 16), (lacks[8], lacks[16]))[0], 1.8)
    coarse = [r for r in runs if r.folder.split(".")[-2] == "4"]
    coarse.sort(key=steps_per_period)
    w = true_frequency(found("frequency.Newmark.4.*")[0])[0]
    steps = np.array([1 / steps_per_period(r) for r in coarse])
    shifts = [abs(seen / np.sqrt(w**2 - decay**2) - 1)
              for seen, decay in map(true_frequency, coarse)]
    orders = plots.convergence(
        "damping.png", steps, {"frequency": np.array(shifts)}, order=1,
        xlabel="step / period", title="A damped cantilever, 5 % of critical")
    # bound: first order, of the strain's backward difference, to a tenth
    results.add("damped_frequency_order_in_time", orders["frequency"][-1], 1, 0.1)


def creeping():
    figure, axes = plots.plt.subplots()
    t = np.linspace(0, 3, 200)
    axes.plot(t, 1 - np.exp(-t), color="black", lw=1.2, label="1 − exp(−t/τ)")
    steps, errors = [], []
    for i, run in enumerate(found("creep.*")):
        table = run.history[BODY + "centre"]
        # the end moves twice as far as the centre, 0.04 at last
        u = (table["x"] - 2) / 0.02
        n = steps_per_period(run)
        exact = 1 - np.exp(-table["time"])
        discrete = 1 - (1 + 1 / n) ** -np.arange(1.0, len(u) + 1)
        steps.append(1 / n)
        errors.append(np.abs(u - exact).max())
        # bound: the tolerance of the residual, 1e-12, with room for the matrix
        results.add("creep_recurrence_abs", np.abs(u - discrete).max(), 0, 1e-8,
                    seconds=run.seconds, cells=run.cells, variant=f"step_{1 / n:g}tau")
        if i < 3:
            axes.plot(table["time"], u, ls="none", marker=plots.MARKERS[i],
                      mfc="white", color=plots.COLOURS[i],
                      markevery=max(1, n // 10), label=f"steps of τ/{n}")
    order = convergence.orders(steps, errors)[-1]
    # bound: backward Euler is of first order, to a tenth
    results.add("creep_order", order, 1, 0.1)
    axes.set(xlabel="time / τ", ylabel="length gained / final")
    axes.set_title("A Kelvin-Voigt bar under a constant force", loc="left")
    axes.legend(loc="lower right")
    plots.save(figure, "creep.png")


def main():
    spinning()
    draw_energy()
    frequency()
    fourth_frequency()
    order_in_time()
    creeping()
    if not quick:
        damping()
    results.write()


if __name__ == "__main__":
    main()
