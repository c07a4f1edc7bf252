# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How soft the leukocyte may be with the law of the source, against neoHookean.
Appends to results.csv and draws."""

import glob
import os
import sys

import numpy as np

from fsbi import plots
from fsbi.history import History
from fsbi.results import Results

END = 9320          # us
SCENE = 0.225       # capillary number of the scene
LAWS = ("StVenantKirchhoff.totalLagrangian", "neoHookean.totalLagrangian",
        "StVenantKirchhoff.slowProcess")
quick = sys.argv[1:2] == ["true"]
results = Results("S10")


def measures(folder):
    """Smallest principal stretch, and the way downstream (um), at the end; nan if
    the run was lost."""
    with open(folder + "/log.fsbiFoam") as log:
        said = log.read()
    if "FATAL" in said:
        name = os.path.basename(folder).removeprefix("law_")
        # bound: it stops with the law's message, or should not have stopped
        results.at_least(name + "_says_why", "softens in compression" in said, 1)
        return np.nan, np.nan
    history = History(folder + "/postProcessing/history.h5")
    leukocyte = "elasticBodies/leukocyte/"
    x = history[leukocyte + "centre"]["x"]
    return history[leukocyte + "deformation"]["minStretch"][-1], x[-1] - x[0]


def series(law):
    """Ca and measures of the runs with the less flattened start."""
    rows = []
    for folder in glob.glob(f"runs/law_{law}_0.3_*"):
        rows.append((float(folder.split("_")[-1]), *measures(folder)))
    return np.array(sorted(rows)).T


def compare(found):
    """Where the law is lost, and what the others carry; the quick form has one run,
    of the first at the scene's stiffness."""
    Ca, stretch, _ = found[LAWS[0]]
    kept = np.isfinite(stretch)
    # bound: the law fails before the scene's stiffness
    results.at_least("scene_over_lost_Ca", SCENE / Ca[~kept].min(initial=np.inf), 1)
    if quick:
        return
    # bound: softer is always worse: below the first run lost all end, above none
    results.add("kept_after_lost_abs", np.sum(np.diff(kept.astype(int)) > 0), 0, 0)
    for law, name in zip(LAWS[1:], ("neoHookean", "slowProcess")):
        Ca, stretch, _ = found[law]
        # bound: the capillary number of the scene
        results.at_least(name + "_carries_Ca", Ca[np.isfinite(stretch)].max(initial=0), SCENE)


def draw(found):
    figure, axes = plots.plt.subplots(1, 2, figsize=(9.6, 4.0))
    for i, (law, (Ca, stretch, way)) in enumerate(found.items()):
        law = law.removesuffix(".totalLagrangian").replace(".", ", ")
        lost = Ca[~np.isfinite(stretch)]
        for axis, values in zip(axes, (stretch, way)):
            axis.plot(Ca, values, color=plots.COLOURS[i], marker=plots.MARKERS[i],
                      mfc="white", label=law)
            if len(lost):
                axis.axvspan(lost[0], 0.24, color=plots.COLOURS[i], alpha=0.15, lw=0,
                             label=f"{law}: no such state")
    axes[0].axhline(1 / np.sqrt(3), color="black", lw=0.8, ls=":")
    axes[0].set(xlabel="µγ/G", ylabel="smallest principal stretch", ylim=(0, 0.9))
    axes[1].set(xlabel="µγ/G", ylabel="centre, downstream (µm)")
    axes[0].legend(fontsize=9)
    axes[0].set_title(f"Leukocyte at {END / 1000:g} ms; dotted: 1/√3", loc="left")
    plots.save(figure, "softening.png")


def main():
    for folder in sorted(glob.glob("runs/law_*_0.5_*")):
        stretch, _ = measures(folder)
        if "slowProcess" in folder:
            # bound: the source's scene, law and formulation reach the source's end
            results.at_least("slowProcess_own_start_ends", np.isfinite(stretch), 1)
    found = {law: series(law) for law in LAWS if glob.glob(f"runs/law_{law}_0.3_*")}
    compare(found)
    if not quick:
        draw(found)
    results.write(append=True)


if __name__ == "__main__":
    main()
