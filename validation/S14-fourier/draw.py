# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 3.4-3.8 and 3.10 of Gaskin 2018 and those of the measurements."""

import numpy as np

from fsbi import plots


def table(run, name):
    return np.genfromtxt(f"runs/{run}/fourier/{name}.csv", delimiter=",", names=True)


def over_waves(run, path, title):
    data = table(run, "waves")
    figure, axes = plots.plt.subplots()
    for i, omega in enumerate(np.unique(data["omega"])):
        part = data[data["omega"] == omega]
        axes.plot(part["phi"], part["radius"], color=plots.COLOURS[i],
                  ls=("-", "--", "-.", ":")[i % 4], label=f"ω = {omega:g}")
    axes.set(xlabel="phase between neighbouring cells", ylabel="spectral radius")
    axes.set_title(title, loc="left")
    axes.legend()
    plots.save(figure, path)


def over_factor():
    data = table("SOR", "factors")
    plots.curves("figure3.5.png", [], theory=[("", data["omega"], data["radius"])],
                 xlabel="relaxation factor", ylabel="largest spectral radius",
                 title="SOR, 1-D Laplace, waves from π/64 on (fig. 3.5)")


def plane(number, phix, text):
    data = table("elasticity", "planes")
    part = data[np.isclose(data["phix"], phix)]
    shape = (101, 101)
    figure, axes = plots.plt.subplots()
    shown = axes.contourf(part["phiy"].reshape(shape), part["phiz"].reshape(shape),
                          part["radius"].reshape(shape), 20, cmap="viridis")
    figure.colorbar(shown, label="spectral radius")
    axes.set(xlabel="φy", ylabel="φz")
    axes.set_title(f"Elasticity, ω = 1, φx = {text} (fig. {number})", loc="left")
    plots.save(figure, f"figure{number}.png")


def pairs(best):
    data = table("elasticity", "pairs")
    n = int(round(len(data) ** 0.5))
    gain = np.where(data["gain"] > 0, data["gain"], np.nan).reshape(n, n).T
    figure, axes = plots.plt.subplots()
    axes.grid(False)
    shown = axes.contourf(data["omega1"].reshape(n, n).T, data["omega2"].reshape(n, n).T,
                          gain, np.linspace(0, 2, 21), cmap="viridis")
    figure.colorbar(shown, label="speed per step over the best one factor")
    for x, y, mark, label in (
            (best["pair_lower"], best["pair_upper"], "*",
             f"best pair: +{100 * (best['gain_2'] - 1):.1f} %"),
            (best["capped_lower"], 2.95, "o",
             f"best below 2.95: +{100 * (best['gain_capped'] - 1):.0f} %")):
        axes.plot([x, y], [y, x], mark, color=plots.COLOURS[1], ms=11 if mark == "*" else 7,
                  mfc="white" if mark == "o" else None, label=label)
    axes.set(xlabel="ω1", ylabel="ω2")
    axes.legend(loc="upper right", frameon=True)
    axes.set_title("Two steps, elasticity, waves from π/64 on (fig. 3.10)", loc="left",
                   fontsize=10.5)
    plots.save(figure, "figure3.10.png")


def rates(found):
    m, measured, predicted = np.array(found).T
    figure, axes = plots.plt.subplots()
    axes.plot(m, -predicted, "-", color="black", lw=1.2, label="Fourier analysis")
    axes.plot(m, -measured, "o", mfc="white", mew=1.4, label="smoothSolver")
    axes.set(xlabel="number of factors", ylabel="-ln(residual) per step", ylim=(0, None))
    axes.set_title("Laplace, periodic box of 16³ cells", loc="left")
    axes.legend()
    plots.save(figure, "rates.png")


def seconds(rows):
    figure, axes = plots.plt.subplots()
    names = [name for _, name, _ in rows]
    axes.barh(names, [s for s, _, _ in rows],
              color=[plots.COLOURS[1 if "factors" in n else 0] for n in names])
    axes.set(xlabel="seconds of the processor", xscale="log")
    axes.invert_yaxis()
    axes.set_title("Laplace, 64³ cells, residual 1e-6", loc="left")
    plots.save(figure, "seconds.png")


def symbols(best):
    over_waves("SOR", "figure3.4.png", "SOR, 1-D Laplace (fig. 3.4)")
    over_factor()
    plane("3.6", np.pi / 64, "π/64")
    plane("3.7", np.pi, "π")
    over_waves("elasticity", "figure3.8.png", "Elasticity, φx = φy = φz (fig. 3.8)")
    pairs(best)
