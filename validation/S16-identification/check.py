# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Add noise and outliers to the surfaces, identify, compare with what they were
made with; write results.csv and draw. Rows of data and trial body on one mesh say
same_mesh: they show that the method finds its own numbers, no more."""

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
CELL = {"E": 2e-3, "nu": 0.3}
NOISE = 0.01            # of the root mean square
WRONG, OFF = 0.05, 1.0  # a share of all points is off by this, over the mean square, one way

# bound: below the optimiser's own tolerance in a coordinate, 1e-7 of a range of 4.6
# in ln E, 0.46 in nu
EXACTLY = 1e-6
# bound: of another mesh: 8 cells across leave 0.3 % of E, 0.4 % of nu (README), noise
# 0.2 % and 0.5 %; three times the sum is beyond chance in ten samples. Asked for is
# 1 % of E; nu has less to do with the shape
OTHER_MESH = {"E": 0.01, "nu": 0.03}

quick = sys.argv[1:2] == ["true"]
results = Results("S16")


def surface(run, name, noise=0.0, seed=0, follower=None, wrong=None):
    """A file for the tool: with noise; what holds the root is not known. wrong: where
    some points are off, 'displacement' or 'traction'."""
    data = np.genfromtxt(f"runs/{run}/surface.csv", delimiter=",", skip_header=1)
    root, end = data[:, 2] < 1e-6, data[:, 2] > 16 - 1e-6
    if follower is not None:
        data[end, 6:] = follower
    random = np.random.default_rng(seed)
    for columns in (slice(3, 6), slice(6, 9)):
        size = np.sqrt(np.mean(data[~root, columns]**2))
        data[:, columns] += noise*size*random.standard_normal((len(data), 3))
    if wrong:
        columns = slice(3, 6) if wrong == "displacement" else slice(6, 9)
        off = (random.random(len(data)) < WRONG) & ~root
        size = np.sqrt(np.mean(data[~root, columns]**2))
        data[off, columns] += OFF*size*(1 + random.standard_normal((off.sum(), 3)))
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
    """Every norm and objective finds the constants of exact data."""
    path = surface("same", "exact")
    variants = {"": {}, "_norm1": {"norm": 1}, "_tractions_norm8":
                {"objective": "traction", "norm": 8}}
    if not quick:
        variants |= {"_norm2_power1": {"norm": 2, "power": 1}, "_norm8": {"norm": 8},
                     "_tractions": {"objective": "traction"},
                     "_tractions_norm1": {"objective": "traction", "norm": 1}}
    for label, entries in variants.items():
        found, _, seconds = fit("same", path, **entries)
        for name, exact in EXACT.items():
            results.add(f"{name}_same_mesh{label}", found[name]["value"], exact, EXACTLY,
                        seconds=seconds, cells=432)


def check_deformed():
    path = surface("deformed", "deformed", follower=(3.125e-5, 0, 1.25e-4))
    found, _, seconds = fit("trial", path, areas="deformed")
    for name, exact in EXACT.items():
        results.add(f"{name}_per_deformed_area", found[name]["value"], exact,
                    OTHER_MESH[name], seconds=seconds)


def check_noise():
    """On another mesh than that of the data."""
    errors = {name: [] for name in EXACT}
    for seed in range(2 if quick else 10):
        found, _, seconds = fit("trial", surface("fine", "noise", NOISE, seed))
        for name, exact in EXACT.items():
            errors[name].append(found[name]["value"] / exact - 1)
    for name, bound in OTHER_MESH.items():
        e = errors[name]
        print(f"    {name}, other mesh, noise: error {100*np.mean(e):.2f} % on average,"
              f" {100*np.abs(e).max():.2f} % at most")
        results.add(f"{name}_other_mesh_noise_largest_error_abs", np.abs(e).max(), 0, bound,
                    seconds=seconds)


def check_outliers():
    """Noise, and some displacements that are wrong, on another mesh: l1 against l2."""
    seeds = 1 if quick else 10
    error = {}
    norms = {"least_squares": {}, "norm1": {"norm": 1}}
    if not quick:
        norms["norm2_power1"] = {"norm": 2, "power": 1}
    for label, entries in norms.items():
        found = [fit("trial", surface("fine", "outliers", NOISE, s, wrong="displacement"),
                     **entries)[0] for s in range(seeds)]
        error[label] = {n: np.array([f[n]["value"] / exact - 1 for f in found])
                        for n, exact in EXACT.items()}
        print(f"    5 % of the displacements off by 100 %, {label}: " + ", ".join(
            f"{n} {100*np.abs(e).mean():.2f} % on average" for n, e in error[label].items()))
    for name, bound in OTHER_MESH.items():
        # bound: as without outliers: a share s of them moves a median by
        # s/(2 (1 - s) 0.4) = 0.07 of the noise's deviation, which is nothing beside it
        results.add(f"{name}_outliers_norm1_mean_error_abs", np.abs(error["norm1"][name]).mean(),
                    0, bound)
    # bound: the mean moves by s = 5 % of the displacement, so does E, by some per cent;
    # what the mesh leaves, 1 % at most, is half of that or less
    ratio = np.abs(error["least_squares"]["E"]).mean() / np.abs(error["norm1"]["E"]).mean()
    results.at_least("E_outliers_least_squares_over_norm1", ratio, 2)


def check_wrong_tractions():
    """Some tractions are wrong, the displacement is exact: compare tractions."""
    path = surface("same", "wrongTractions", wrong="traction")
    error = {label: abs(fit("same", path, **entries)[0]["E"]["value"] / EXACT["E"] - 1)
             for label, entries in {
                 "displacement": {}, "least_squares": {"objective": "traction"},
                 "norm1": {"objective": "traction", "norm": 1}}.items()}
    print("    5 % of the tractions off by 100 %: error of E " + ", ".join(
        f"{label} {100*e:.3g} %" for label, e in error.items()))
    # bound: springs of 1000 E/R give way by a thousandth of what is wrong; a median does
    # not see the rest
    results.add("E_same_mesh_wrong_tractions_norm1_error_abs", error["norm1"], 0, 1e-3)


def check_flow():
    """An adhering cell, observed on one mesh; fluid and trial body have others."""
    law, find = "type neoHookean;", "E (2e-4 2e-2); nu (0 0.45);"
    held = np.genfromtxt("runs/flowObserved/surface.csv", delimiter=",", skip_header=1)
    held[held[:, 1] < 4.5, 6:] = np.nan
    np.savetxt("runs/flowRun.csv", held, delimiter=",", header=HEADER, comments="", fmt="%.12g")
    own, _, _ = identify("flowTrial", law, find, file=f'"{os.path.abspath("runs/flowRun.csv")}"')
    found, misfits, seconds = identify(
        "flowTrial", law, find, file=f'"{os.path.abspath("runs/flow.csv")}"',
        traction=f'"{os.path.abspath("runs/flowFlow/postProcessing/tractions.cell.csv")}"')
    for name, exact in CELL.items():
        value, given = found[name]["value"], own[name]["value"]
        print(f"    adhering cell: {name} {value:.4g} with the traction of the flow around its"
              f" shape, {given:.4g} with that of its own run, exact {exact:g}")
        # bound: the edge of what is held is known to half a triangle of 0.8 um, the
        # cell above it is 4.5 um high: 9 %; 1.15 um in the quick form: 13 %
        results.add(f"{name}_flow_matched", value, exact, 0.13 if quick else 0.09,
                    seconds=seconds)
    # bound: E goes with the force, and forces on bodies on meshes of this size are good
    # to 3 % (B1, shells); both runs have such a mesh. nu has no such bound
    results.add("E_flow_over_own_traction", found["E"]["value"], own["E"]["value"], 0.06)
    # bound: a model error of the displacement that is a tenth would be another law's
    results.add("model_error_flow_matched_abs", misfits["modelError"], 0, 0.1)


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
        # bound: three deviations of the spread of so many samples, 1/sqrt(2 n)
        results.add(f"{name}_same_mesh_deviation_over_claimed", spread / claimed, 1,
                    0.87 if quick else 0.27)
    # bound: of 12 (120) intervals of 95 %, binomial: fewer once in 500 (100) times
    results.at_least("same_mesh_intervals_that_hold", np.mean(hits), 0.75 if quick else 0.9)
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
    # bound: a wrong law must stand out from what a mesh does to the right one, (8/6)^2
    # between the trial's meshes of the two forms; Hooke's by ten times, for it does
    # not know of the rotation of the block's end, 0.2 rad, whose square is 4 % of the
    # displacement beside a mesh error of 0.3 %
    for law, times in (("StVenantKirchhoff", 1.78), ("linearElastic", 10)):
        for noise in (0, NOISE):
            results.at_least(f"model_error_{law}_over_right_noise{noise:g}",
                             bars[law, noise] / bars["neoHookean", noise], times)
    draw_laws(bars)


def check_bead():
    found, misfits, seconds = identify("microbead", "type neoHookean;",
                                       "E (1e-5 1e-1); nu (0 0.45);")
    for name, exact in BEAD.items():
        # bound: the run's tolerance is 1e-6 a step of the fluid's force, its traction
        # a hundred times less certain where it is small
        results.add(f"{name}_microbead_same_mesh", found[name]["value"], exact, 1e-4,
                    seconds=seconds)
    # bound: as above
    results.add("misfit_microbead_same_mesh_abs", misfits["displacement"], 0, 1e-4)
    found, misfits, _ = identify("microbead", "type linearElastic;",
                                 "E (1e-5 1e-1); nu (0 0.45);")
    # bound: the bead turns and halves its height: a small-strain law is off by tenths
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


def main():
    check_exact()
    check_deformed()
    check_noise()
    if not quick:           # half a minute; applications/test/identification has a small one
        check_outliers()
    check_wrong_tractions()
    check_intervals()
    check_laws()
    check_bead()
    check_flow()
    if not quick:
        study_springs()
    results.write()


if __name__ == "__main__":
    main()
