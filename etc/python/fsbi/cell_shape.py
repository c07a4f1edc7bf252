# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor's parameter and the inclination of a cell in shear, drawn over time."""

import numpy as np

from fsbi import plots
from fsbi.history import History


def draw(rate, steady, angle, label, title, body="cell"):
    """shape.png of the run in this folder; steady, angle (degrees): of theory, by this name;
    rate: of shear."""
    history = History("postProcessing/history.h5")
    axes = history[f"elasticBodies/{body}/semiAxes"]
    direction = history[f"elasticBodies/{body}/longestAxis"]
    D = (axes["longest"] - axes["shortest"]) / (axes["longest"] + axes["shortest"])
    angles = np.degrees(np.arctan2(direction["y"], direction["x"])) % 180

    figure, (above, below) = plots.plt.subplots(2, 1, figsize=(6.4, 5.6), sharex=True)
    for plot, y, value, name in ((above, D, steady, "deformation (L-B)/(L+B)"),
                                 (below, angles, angle, "inclination (degrees)")):
        plot.axhline(value, color="black", lw=1.2, label=f"{label}, steady")
        plot.plot(rate * axes["time"], y, color=plots.COLOURS[0], marker="o", mfc="white",
                  markevery=4, label="fsbiFoam")
        plot.set_ylabel(name)
        plot.legend()
    below.set_xlabel("time × shear rate")
    above.set_title(title, loc="left")
    plots.save(figure, "shape.png")

    print(f"    deformation   {D[-1]:.4f}   ({label} {steady:.4f})")
    print(f"    inclination   {angles[-1]:.2f}    ({label} {angle:.2f})")
