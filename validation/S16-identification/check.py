# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add noise to the surfaces, identify, compare with what they were made with;
write results.csv and draw."""

import csv
import os
import re
import subprocess
import sys

import numpy as np

from fsbi import plots
from fsbi.results import Results

HEADER = "x,y,z,ux,uy,uz,tx,ty,tz"
EXACT = {"E": 1e-3, "nu": 0.3}
BEAD = {"E": 0.504e-3, "nu": 0.133}
FIND = "E (1e-4 1e-2); nu (0 0.46);"
NOISE = 0.01            # of the root mean square

quick = sys.argv[1] == "true"
results = Results("S16")


def surface(run, name, noise=0.0, seed=0, follower=None):
    """A file for the tool: with noise; what holds the root is not known."""
    data = np.genfromtxt(f"runs/{run}/surface.csv", delimiter=",", skip_header=1)
    root, end = data[:, 2] < 1e-6, data[:, 2] > 16 - 1e-6
    if follower is not None:
        data[end, 6:] = follower
    random = np.random.default_rng(seed)
    for columns in (slice(3, 6), slice(6, 9)):
        size = np.sqrt(np.mean(data[~root, columns]**2))
        data[:, columns] += noise*size*random.standard_normal((len(data), 3))
    data[root, 6:] = np.nan
    path = os.path.abspath(f"runs/{name}.csv")
    np.savetxt(path, data, delimiter=",", header=HEADER, comments="", fmt="%.12g")
    return path


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def identify(case, law, find=FIND, **entries):
    """({constant: row}, misfits, seconds) of a run of the tool."""
    given = "".join(f"{key} {value};\n" for key, value in entries.items())
    with open(f"runs/{case}/system/identifyDict", "w") as file:
        file.write("FoamFile { version 2.0; format ascii; class dictionary;"
                   f" object identifyDict; }}\nmaterial {{ {law} }}\n"
                   f"find {{ {find} }}\n{given}")
    done = subprocess.run(["fsbiIdentifyMaterial", "-case", f"runs/{case}"],
                          capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
    folder = f"runs/{case}/postProcessing/identification"
    constants = {row["constant"]: {k: float(v) for k, v in row.items() if k != "constant"}
                 for row in rows(f"{folder}/constants.csv")}
    misfits = {k: float(v) for k, v in rows(f"{folder}/misfits.csv")[0].items()}
    return constants, misfits, float(re.search(r"solutions, ([0-9.]+) s", done.stdout)[1])


def fit(case, path, law="StVenantKirchhoff", **entries):
    return identify(case, f"type {law};", file=f'"{path}"', **entries)


def check_exact():
    found, _, seconds = fit("same", surface("same", "exact"))
    for name, exact in EXACT.items():
        results.add(f"{name}_same_mesh", found[name]["value"], exact, 1e-6, seconds=seconds,
                    cells=432)


def check_deformed():
    path = surface("deformed", "deformed", follower=(3.125e-5, 0, 1.25e-4))
    found, _, seconds = fit("trial", path, areas="deformed")
    for name, exact in EXACT.items():
        results.add(f"{name}_per_deformed_area", found[name]["value"], exact,
                    0.01 if name == "E" else 0.03, seconds=seconds)


def check_noise():
    """On another mesh than that of the data."""
    errors = {name: [] for name in EXACT}
    for seed in range(2 if quick else 10):
        found, _, seconds = fit("trial", surface("fine", "noise", NOISE, seed))
        for name, exact in EXACT.items():
            errors[name].append(found[name]["value"] / exact - 1)
    for name, bound in (("E", 0.01), ("nu", 0.03)):
        e = errors[name]
        print(f"    {name}, other mesh, noise: error {100*np.mean(e):.2f} % on average,"
              f" {100*np.abs(e).max():.2f} % at most")
        results.add(f"{name}_other_mesh_noise_largest_error_abs", np.abs(e).max(), 0, bound,
                    seconds=seconds)


def check_intervals():
    """How often do they hold the truth, and are they too wide?"""
    seeds = 6 if quick else 60
    found = [fit("same", surface("same", "noise", NOISE, 100 + s))[0] for s in range(seeds)]
    hits = []
    for name, exact in EXACT.items():
        hits += [f[name]["lowest"] < exact < f[name]["highest"] for f in found]
        errors = np.array([f[name]["value"] - exact for f in found])
        claimed = np.mean([f[name]["deviation"] for f in found])
        spread = np.sqrt(np.mean(errors**2))
        print(f"    {name}: standard deviation {claimed:.3g} claimed, {spread:.3g} in"
              f" {seeds} samples")
        results.add(f"{name}_deviation_over_claimed", spread / claimed, 1,
                    0.7 if quick else 0.3)
    results.at_least("intervals_that_hold", np.mean(hits), 0.75 if quick else 0.9)
    draw_intervals(found)


def check_laws():
    """Data of neoHookean at large strain: the wrong laws give themselves away."""
    bars = {}
    for noise in (0, NOISE):
        path = surface("neoHookean", "laws", noise, 1)
        for law in ("neoHookean", "StVenantKirchhoff", "linearElastic"):
            found, misfits, _ = fit("trial", path, law)
            bars[law, noise] = misfits["modelError"]
            print(f"    {law} on data of neoHookean, noise {noise:g}: E "
                  f"{found['E']['value']:.4g}, nu {found['nu']['value']:.3f}, model error "
                  f"{misfits['modelError']:.4f}, traction {misfits['traction']:.3f}")
    for law, times in (("StVenantKirchhoff", 1.7), ("linearElastic", 10)):
        for noise in (0, NOISE):
            results.at_least(f"model_error_{law}_over_right_noise{noise:g}",
                             bars[law, noise] / bars["neoHookean", noise], times)
    draw_laws(bars)


def check_bead():
    found, misfits, seconds = identify("microbead", "type neoHookean;",
                                       "E (1e-5 1e-1); nu (0 0.45);")
    for name, exact in BEAD.items():
        results.add(f"{name}_microbead", found[name]["value"], exact, 1e-4, seconds=seconds)
    results.add("misfit_microbead_abs", misfits["displacement"], 0, 1e-4)
    found, misfits, _ = identify("microbead", "type linearElastic;",
                                 "E (1e-5 1e-1); nu (0 0.45);")
    results.at_least("model_error_linearElastic_microbead", misfits["modelError"], 0.1)


def study_springs():
    """Soft springs compare displacements, stiff ones tractions: which is better?"""
    ratios = (1e-3, 1e-2, 0.1, 1, 10, 100)
    values = {r: [fit("same", surface("same", "noise", NOISE, 200 + s), springs=r)[0]
                  for s in range(5)] for r in ratios}
    figure, axes = plots.plt.subplots()
    for i, (name, exact) in enumerate(EXACT.items()):
        errors = [100*(np.array([f[name]["value"] for f in values[r]]) / exact - 1)
                  for r in ratios]
        axes.plot(ratios, [np.sqrt(np.mean(e**2)) for e in errors], "o-", mfc="white",
                  color=plots.COLOURS[i], label=name)
        print(f"    {name}, error in % for springs of", ", ".join(
            f"{r:g}: {np.sqrt(np.mean(e**2)):.2f}" for r, e in zip(ratios, errors)))
    axes.set(xscale="log", yscale="log", xlabel="stiffness of the springs / (E/radius)",
             ylabel="error (%), root mean square")
    axes.set_title("Noise of 1 %: compare displacements (left) or tractions", loc="left",
                   fontsize=10.5)
    axes.legend()
    plots.save(figure, "springs.png")


def draw_intervals(found):
    figure, parts = plots.plt.subplots(2, 1, sharex=True, figsize=(6.4, 5.6))
    for axes, (name, exact) in zip(parts, EXACT.items()):
        for i, f in enumerate(found):
            row = f[name]
            right = row["lowest"] < exact < row["highest"]
            axes.plot([i, i], [row["lowest"] / exact, row["highest"] / exact], "-",
                      color=plots.COLOURS[0 if right else 1], lw=1.5)
            axes.plot(i, row["value"] / exact, "o", ms=3, color=plots.INK)
        axes.axhline(1, color="black", lw=1)
        axes.set(ylabel=f"{name} / exact")
    parts[0].set_title("95 % intervals, noise of 1 % on displacement and traction", loc="left",
                       fontsize=10.5)
    parts[1].set(xlabel="sample of the noise")
    plots.save(figure, "intervals.png")


def draw_laws(bars):
    laws = list(dict.fromkeys(law for law, _ in bars))
    figure, axes = plots.plt.subplots()
    for i, noise in enumerate((0, NOISE)):
        axes.barh(np.arange(3) + 0.2*(2*i - 1), [bars[law, noise] for law in laws], 0.36,
                  color=plots.COLOURS[i], label=f"noise {100*noise:g} %")
    axes.set_yticks(range(3), laws)
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="relative model error of the displacement")
    axes.set_title("Laws fitted to a neo-Hookean block", loc="left")
    axes.legend()
    plots.save(figure, "laws.png")


check_exact()
check_deformed()
check_noise()
check_intervals()
check_laws()
check_bead()
if not quick:
    study_springs()
results.write()
