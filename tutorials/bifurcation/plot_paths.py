# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which branch each cell takes, and how the flow parts."""

import glob

import numpy as np
from make_vessel import outline, resistance

from fsbi import plots
from fsbi.history import History

CELLS = ("high", "middle", "low")

history = History("postProcessing/history.h5")
figure, axes = plots.plt.subplots(figsize=(6.8, 5.6))
for line in outline():
    axes.plot(*line.T, color="black", lw=1.2)
for colour, name in zip(plots.COLOURS, CELLS):
    path = history[f"bodies/{name}/position"]
    axes.plot(path["x"], path["y"], color=colour, marker="o", mfc="white", markevery=5,
              label=name)
    branch = "upper" if path["y"][-1] > 0 else "lower"
    print(f"    {name:6s} goes into the {branch} branch, to ({path['x'][-1]:.1f}, "
          f"{path['y'][-1]:.1f}) um")
axes.set(xlabel="x (µm)", ylabel="y (µm)", aspect="equal")
axes.set_title("Three cells at a bifurcation", loc="left")
axes.legend()
plots.save(figure, "paths.png")


def flow(branch):
    (file,) = glob.glob(f"postProcessing/**/{branch}/0/*.dat", recursive=True)
    return np.loadtxt(file, comments="#", usecols=-1, ndmin=1, converters=lambda v: float(
        (v.decode() if isinstance(v, bytes) else v).strip("()").split()[-1]))


lower, upper = flow("lower"), flow("upper")
share = lower / (lower + upper)
expected = resistance("upper") / (resistance("lower") + resistance("upper"))
print(f"    {share[0]:.1%} of the flow go down at the start, {share[-1]:.1%} at the end; of "
      f"straight branches {expected:.1%}")
