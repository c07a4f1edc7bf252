# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hold the analysis against sampled waves and best_factors.py, and the solver
against the analysis; write results.csv and draw figures 3.4-3.8, 3.10 of Gaskin 2018."""

import csv
import glob
import os
import re
import sys

import numpy as np

import draw
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
results = Results("S14")


def references():
    """What best_factors.py found."""
    with open("runs/references.csv", newline="") as file:
        return {row["quantity"]: float(row["value"]) for row in csv.DictReader(file)}


def schedules(name):
    with open(f"runs/{name}/fourier/schedules.csv", newline="") as file:
        return {(row["kind"], int(row["steps"])): row for row in csv.DictReader(file)}


def solves(name):
    """(first, last residual, iterations) of every solve; seconds."""
    with open(f"runs/{name}/log.laplacianFoam") as log:
        text = log.read()
    found = re.findall(r"Initial residual = (\S+), Final residual = (\S+), "
                       r"No Iterations (\d+)", text)
    seconds = float(re.findall(r"^ExecutionTime = ([0-9.]+) s", text, re.M)[-1])
    return np.array(found, float), seconds


def step_matrix(omega, phi, nu):
    """G of one step for many waves, as printed (3.84-3.98), dx = dy = dz."""
    mu, lam = 1.0, 2 * nu / (1 - 2 * nu)
    diagonal = 2 * (4 * mu + lam)
    G = np.zeros((len(phi), 3, 3), complex)
    for i in range(3):
        for j in range(3):
            k = 2 * mu + lam if i == j else mu
            G[:, i, i] += omega / diagonal * k * 2 * np.cos(phi[:, j])
            if i != j:
                plus, minus = phi[:, i] + phi[:, j], phi[:, i] - phi[:, j]
                G[:, i, j] = omega * (mu + lam) / (4 * diagonal) * (
                    2 * np.cos(plus) - 2 * np.cos(minus))
        G[:, i, i] += 1 - omega
    return G


def check_waves():
    # bound: round-off of a few hundred operations on numbers of size 1; asked for
    # is 1e-12, here and in the two below
    planes = draw.table("elasticity", "planes")
    phi = np.column_stack([planes[n] for n in ("phix", "phiy", "phiz")])
    G = step_matrix(1.0, phi, 0.3)
    # G is symmetric for equal spacings
    radius = np.abs(np.linalg.eigvalsh(G)).max(axis=1)
    results.add("radius_20402_waves_abs", np.abs(radius - planes["radius"]).max(), 0, 1e-12)
    sor = draw.table("SOR", "waves")
    w, e = sor["omega"], np.exp(1j * sor["phi"])
    exact = np.abs((w * e + 2 * (1 - w)) / (2 - w / e))
    results.add("radius_SOR_abs", np.abs(exact - sor["radius"]).max(), 0, 1e-12)
    jacobi = draw.table("Jacobi", "waves")
    exact = np.abs(jacobi["omega"] * (np.cos(jacobi["phi"]) - 1) + 1)
    results.add("radius_Jacobi_abs", np.abs(exact - jacobi["radius"]).max(), 0, 1e-12)


def check_schedules():
    # bound: what best_factors.py has converged to itself, 3e-9 (error_gain_8: half
    # as many samples of kappa), a few times over
    bound = 1e-8
    own = references()
    found = schedules("elasticity")
    low, high = sorted(map(float, found["best", 2]["factors"].split()))
    results.add("pair_lower", low, own["pair_lower"], bound)
    results.add("pair_upper", high, own["pair_upper"], bound)
    results.add("radius_pair", float(found["best", 2]["radius"]), own["radius_pair"], bound)
    for m in (2, 3, 4, 5, 8):
        results.add(f"gain_{m}_steps", float(found["best", m]["gain"]), own[f"gain_{m}"], bound)
        results.add(f"own_convergence_gain_{m}_steps_abs", own[f"error_gain_{m}"], 0, bound)
    for name in ("capped", "coarse"):
        gain = float(schedules(name)["best", 2]["gain"])
        # bound: as above; the capped pair is annealed, with last steps of
        # 0.5/2^17 of a factor (annealing.C), whose gain changes by
        # kappa/(2 ln radius) = 0.5 a unit: 1.2e-6, and a half more
        results.add(f"gain_pair_{name}_own", gain, own[f"gain_{name}"],
                    2e-6 if name == "capped" else bound)
        # bound: 78 % is printed with two digits (figure 3.10): half of the last
        results.add(f"gain_pair_{name}", gain, 1.78, 0.005 / 1.78)


def modes(n):
    """All eigenvalues of D^-1 A in a periodic box of n^3 cells but zero."""
    c = np.cos(2 * np.pi * np.arange(n) / n)
    kappa = np.unique(((3 - c[:, None, None] - c[:, None] - c) / 3).round(13))
    return kappa[kappa > 1e-9]


def chebyshev(m, low, high):
    angles = (2 * np.arange(m) + 1) * np.pi / (2 * m)
    return 1 / ((low + high) / 2 + (high - low) / 2 * np.cos(angles))


def check_rates():
    kappa = modes(16)
    rates = []
    for m in sorted(int(name[9:]) for name in glob.glob("runs/rate*")):
        residuals, seconds = solves(f"rate{m}")
        first, last, n = residuals[-1]
        measured = np.log(last / first) / n / m
        factors = chebyshev(m, kappa[0], 2)
        p = np.prod(1 - np.outer(factors, kappa), axis=0)
        predicted = np.log(np.abs(p).max()) / m
        # bound: a wave that is a part x faster than the slowest (rate r a step)
        # adds x exp(-240 x r) after the three solves before, 0.37/(240 r) at most:
        # 1.1 % for 8 factors; with fewer no wave is so near. Asked for is 10 %
        results.add(f"rate_{m}_steps", measured, predicted, 0.02,
                    seconds=seconds, cells=16**3)
        rates.append((m, measured, predicted))
    serial, parallel = (solves(name)[0][-1, 1] for name in ("rate4", "parallel"))
    # bound: two numbers printed with six digits; the rest is round-off
    results.add("residual_two_processors", parallel, serial, 2e-6, cells=16**3, procs=2)
    draw.rates(rates)


def check_use():
    residuals, seconds = solves("multigrid")
    # bound: what Gauss-Seidel takes as smoother in the same multigrid
    results.add("multigrid_cycles_abs", residuals[0, 2], 0,
                solves("multigridGaussSeidel")[0][0, 2], seconds=seconds, cells=32**3)


def seconds_table():
    nothing = solves("seconds_nothing")[1]
    print("    64^3 cells, residual 1e-6: solver, iterations, seconds")
    rows = []
    for folder in glob.glob("runs/seconds_*"):
        name = os.path.basename(folder).removeprefix("seconds_")
        residuals, seconds = solves(f"seconds_{name}")
        if name != "nothing":
            rows.append((seconds - nothing, name, int(residuals[0, 2])))
    for seconds, name, iterations in sorted(rows):
        print(f"    {name:16s} {iterations:6d} {seconds:7.2f}")
    took = {name: seconds for seconds, name, _ in rows}
    # bound: a third of what is gained in iterations, 24 (Chebyshev on waves from
    # pi/64 on); the rest is room for a busy machine
    results.at_least("32_factors_over_1", took["factors1"] / took["factors32"], 8,
                     cells=64**3)
    draw.seconds(sorted(rows))


def beam_run(name):
    """(corrections, seconds, deflection, did it get there)."""
    folder = f"runs/beam_{name}"
    coupled = os.path.exists(f"{folder}/log.fsbiFoam")
    log = f"{folder}/log." + ("fsbiFoam" if coupled else "solidDisplacementFoam")
    with open(log) as file:
        text = file.read()
    seconds = float(re.findall(r"^ExecutionTime = ([0-9.]+) s", text, re.M)[-1])
    deflection = float(re.findall(r"max\(mag\(D\)\) = (\S+)", text)[-1])
    if coupled:
        steps = int(re.findall(r"corrections +(\d+)", text)[-1])
        return steps, seconds, deflection, True
    residuals = np.array(re.findall(r"Solving for D[xyz], Initial residual = (\S+),", text), float)
    steps = len(residuals) // 3
    return steps, seconds, deflection, residuals[-3:].max() < 1e-4


def beam_table():
    """Seconds are ExecutionTime: of the processor, start included."""
    names = [os.path.basename(f).removeprefix("beam_") for f in glob.glob("runs/beam_*")]
    exact = beam_run("NewtonKrylov")[2]
    rows = sorted((*beam_run(name), name) for name in names)
    print("    the beam: method, corrections, seconds, deflection over that of NewtonKrylov")
    for steps, seconds, bent, there, name in sorted(rows, key=lambda row: row[1]):
        print(f"    {name:14s} {steps:6d} {seconds:7.2f}  {bent / exact:.3f}"
              + ("" if there else "  not there"))
    took = {name: seconds for _, seconds, _, _, name in rows}
    others = min(took[n] for n in ("PCG", "GAMG"))
    # bound: src/fourier/README.md gives up relaxation where NewtonKrylov is at
    # hand: that has to be a matter of times, not of what the machine does
    results.at_least("beam_NewtonKrylov_over_PCG_or_GAMG", others / took["NewtonKrylov"], 5,
                     seconds=took["NewtonKrylov"], cells=640)
    with open("runs/beam_tuned8/log.fsbiTuneRelaxation") as log:
        print("    " + log.read().replace("\n", "\n    ").rstrip())
    print(f"    tuned over not tuned, in seconds: {took['factors8'] / took['tuned8']:.2f}")


def main():
    check_waves()
    check_schedules()
    check_rates()
    check_use()
    if not quick:
        seconds_table()
        beam_table()
    draw.symbols(references())
    results.write()


if __name__ == "__main__":
    main()
