# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Healed meshes beside whole ones: results.csv, healing.png."""

import re
import sys

import numpy as np

from fsbi import plots
from fsbi.case import Case
from fsbi.results import Results

DRIFT = 0.7                             # degrees, as meshHealing allows
quick = sys.argv[1:2] == ["true"]
results = Results("N3")


def log(name):
    with open(f"runs/log.{name}") as file:
        return file.read()


def record(text, how):
    """The closing line of a travel, by the names in it."""
    words = re.search(rf"^{how}: (.*)$", text, re.M)[1].split()
    return dict(zip(words[::2], map(float, words[1::2])))


def travel(scene):
    text = log(scene)
    healed, whole = record(text, "healed"), record(text, "whole")
    new = float(re.search("^new mean (.*)$", text, re.M)[1])
    cost = dict(seconds=healed["seconds"], cells=healed["cells"], variant=scene)
    # bound: asked for: 12 %. Small meshes are cheap to make
    if not quick:
        results.add("seconds_of_healing_over_whole_meshes_abs",
                    healed["seconds"] / whole["seconds"], 0, 0.12, **cost)
    # bound: below what degrades a mesh
    results.add("largest_nonorthogonality_abs", healed["largest"], 0, 70, **cost)
    results.add("mean_nonorthogonality_healed_over_new_abs",
                max(healed["mean"] - new, 0), 0, DRIFT, **cost)
    print(f"    {scene}: healed {healed['events']:.0f} times in {healed['seconds']:.2f} s, "
          f"made anew {whole['events']:.0f} times in {whole['seconds']:.2f} s; mean "
          f"at most {healed['mean']:.2f}, new {new:.2f}; "
          f"{text.count('Not healed')} were not healed")
    return text


def processes(names):
    """Meshes of the same travel on several processes."""
    marks = [re.search("^fingerprint (.*)$", log(name), re.M)[1] for name in names]
    results.add("meshes_that_differ_between_processes_abs", len(set(marks)) - 1, 0, 0)


def loads(name):
    run = Case(f"runs/{name}")
    force, torque = run.force("a")[-1], run.torque("a")[-1]
    return force, torque, run


def drag():
    """At the same place, on a mesh that was healed all the way and on others."""
    force, torque, run = loads("healed")
    new = loads("new")
    other = loads("other")

    def change(of):
        return (np.linalg.norm(of[0] - new[0]) / np.linalg.norm(new[0]),
                np.linalg.norm(of[1] - new[1]) / np.linalg.norm(new[1]))

    text = open("runs/healed/log.fsbiFoam").read()
    print(f"    ellipsoid: healed {text.count('Healing:')} times, made anew "
          f"{text.count('Remeshing:')} times; forces change by {change((force, torque))}, "
          f"on another new mesh by {change(other)}")
    if not quick:
        fine = loads("fine")
        print(f"    a finer mesh: {change(fine)}")
        error = change(fine)
        for i, name in enumerate(("force", "torque")):
            # bound: the error of this size of cells
            results.add(f"{name}_on_a_healed_mesh_abs", change((force, torque))[i], 0, error[i],
                        cells=run.cells)


def restart():
    whole, halves = (Case(f"runs/{name}").force("a") for name in ("healed", "halfway"))
    change = np.abs(whole - halves).max(axis=1) / np.abs(whole).max()
    # bound: the flow's tolerance: its preconditioner is made anew at a start
    results.add("force_after_a_restart_abs", change.max(), 0, 1e-7)
    # bound: the same to the last bit once there has been a new mesh, made or healed
    results.add("force_at_the_end_after_a_restart_abs", change[-1], 0, 0)


def draw(texts):
    figure, axes = plots.plt.subplots(1, len(texts), figsize=(9, 3.4), sharey=True)
    pattern = r"at ([\d.]+): ([\d.e-]+) s, \d+ cells, non-orthogonality ([\d.]+) mean ([\d.]+)"
    for (scene, text), ax in zip(texts.items(), axes):
        for i, part in enumerate((text[:text.index("healed:")], text[text.index("healed:"):])):
            rows = np.array([[float(x) for x in m] for m in re.findall(pattern, part)])
            ax.plot(rows[:, 0], np.cumsum(rows[:, 1]), ".-", color=plots.COLOURS[i],
                    label=("healed", "whole meshes")[i])
        ax.set_title(scene, loc="left")
        ax.set(xlabel="way (rad)" if scene == "turning" else "way (radii)")
    axes[0].set(ylabel="seconds of meshing", yscale="log")
    axes[0].legend()
    plots.save(figure, "healing.png")


def main():
    scenes = ["passing"] if quick else ["turning", "wall", "passing"]
    texts = {scene: travel(scene) for scene in scenes}
    processes([f"passing.np{n}" for n in ((1, 2) if quick else (1, 2, 4))])
    drag()
    restart()
    results.write()
    if not quick:
        draw(texts)


if __name__ == "__main__":
    main()
