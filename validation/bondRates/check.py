# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of bonds on all meshes against sums over the triangles of the same
two surfaces, computed here; write results.csv and draw."""

import functools
import math

import numpy as np

from fsbi import plots
from fsbi.results import Results

# of the program: um, pg, us
HALF, GAP, RADII, DENSITY = 0.6, 0.045, (4.0, 8.0), 3000.0
KT, REST, STIFFNESS, OFF = 1.380649e-8 * 310, 0.05, 0.2, 1e-3
ON = {"none": 1e-7, "global": 5e-11, "conserving": 5e-11}
ON_ONE = 2e-10            # of the scene with one receptor on each face


def boltzmann(length):
    return np.exp(-0.5 * STIFFNESS * (length - REST) ** 2 / KT)


def surface(n, top):
    """Centroids and areas of the triangles of a square grid on a sphere."""
    radius = RADII[top]
    line = HALF * (2 * np.arange(n + 1) / n - 1)
    x, y = np.meshgrid(line, line, indexing="ij")
    z = np.sqrt(radius**2 - x**2 - y**2)
    z = z - radius if top else radius + GAP - z
    p = np.stack([x, y, z], axis=-1)
    a, b, c, d = p[:-1, :-1], p[:-1, 1:], p[1:, :-1], p[1:, 1:]
    corners = [np.concatenate([u.reshape(-1, 3), v.reshape(-1, 3)])
               for u, v in ((a, b), (c, c), (b, d))]
    area = np.linalg.norm(np.cross(corners[1] - corners[0], corners[2] - corners[0]),
                          axis=1) / 2
    return sum(corners) / 3, area


@functools.lru_cache
def face_sums(n):
    """Areas of the receptors' faces, and of each the sum over the ligands' faces
    of their area times the Boltzmann factor of the distance [2.62]."""
    (upper, areas), (lower, others) = surface(n, 0), surface(n, 1)
    sums = np.array([boltzmann(np.linalg.norm(lower - x, axis=1)) @ others for x in upper])
    return areas, others, sums


def smooth():
    """Exact spheres and no faces: the integral over both surfaces, the ligands'
    being flat over the reach of a bond."""
    a = 0.5 * STIFFNESS / KT
    zones = 20000
    height = 0.08
    z = (np.arange(zones) + 0.5) * height / zones
    gap = np.sqrt((RADII[1] + GAP + z) ** 2 + 2 * RADII[0] * z - z * z) - RADII[1]
    x = gap - REST
    erfc = np.array([math.erfc(math.sqrt(a) * v) for v in x])
    rate = 2 * math.pi * (np.exp(-a * x * x) / (2 * a)
                          + 0.5 * REST * math.sqrt(math.pi / a) * erfc)
    return DENSITY**2 * ON["none"] / OFF * 2 * math.pi * RADII[0] * height * rate.mean()


def expected(sites, correction, one_per_face, n):
    """Mean number of bonds while nearly all molecules are free: the sum of all
    rates over the rate at which bonds break."""
    areas, others, sums = face_sums(n)
    ligands = DENSITY * others.sum()
    receptors = DENSITY * areas.sum()
    if correction == "none":
        return smooth() if sites == "molecules" else (
            DENSITY**2 * ON["none"] / OFF * areas @ sums)
    nearest = boltzmann(GAP if sites == "faces" else REST)
    if sites == "faces" and correction == "global":
        density = 2 * (n / (2 * HALF)) ** 2 if one_per_face else DENSITY
        receptors = density * len(areas) * (areas @ sums) / sums.sum()
    on = ON_ONE if one_per_face else ON[correction]
    return on / OFF * receptors * ligands * nearest


def main():
    results = Results("bondRates")
    rows = [line.split() for line in open("runs/log.meshes")
            if line.startswith(("molecules ", "faces "))]
    finest = max(int(row[3]) for row in rows)
    series = {}
    for sites, correction, one, n, bonds, deviation in rows:
        one, n, bonds, deviation = one == "1", int(n), float(bonds), float(deviation)
        law = expected(sites, correction, one, n)
        series.setdefault((sites, correction, one), []).append((n, bonds, deviation, law))
        # molecules that are not scaled see the flat triangles: only the finest
        if (sites, correction) != ("molecules", "none") or n == finest >= 24:
            name = f"{sites}_{correction}" + ("_one_a_face" if one else "")
            # bound: three standard deviations of the mean over the seeds
            results.add(f"{name}_sigmas_abs", (bonds - law) / deviation, 0, 3,
                        variant=f"{n}across")
    grown = np.array(series["faces", "global", True])
    slope = np.log(grown[-1, 1] / grown[0, 1]) / np.log(grown[-1, 0] / grown[0, 0]) / 2
    noise = np.hypot(grown[0, 2] / grown[0, 1], grown[-1, 2] / grown[-1, 1])
    # bound: the sum of rates is (number of faces) k_g: power 1, three deviations
    results.add("power_one_a_face_abs", slope, 1,
                3 * noise / np.log(grown[-1, 0] / grown[0, 0]) / 2)
    draw(series)
    results.write()


def draw(series):
    figure, axes = plots.plt.subplots(figsize=(7.2, 4.8))
    for i, ((sites, correction, one), points) in enumerate(series.items()):
        n, bonds, deviation, _ = np.array(points).T
        if correction == "none":
            mesh_free = expected("molecules", "none", False, 6)
        else:
            mesh_free = expected(sites, "conserving", False, int(n[-1])) * (
                ON_ONE / ON["global"] if one else 1)
        colour = plots.COLOURS[i % len(plots.COLOURS)] if not one else plots.INK
        name = sites + ", " + correction + (", one receptor a face" if one else "")
        axes.errorbar(2 * n**2 * 1.04 ** (i - 3), bonds / mesh_free, deviation / mesh_free,
                      color=colour, marker=plots.MARKERS[i % len(plots.MARKERS)], ls="",
                      capsize=3, mfc="white", label=name)
        if (sites, correction) != ("molecules", "none"):
            finer = np.array([6, 12, 24, 48])
            law = np.array([expected(sites, correction, one, k) for k in finer])
            axes.plot(2 * finer**2, law / mesh_free, color=colour, lw=1)
    axes.set(xscale="log", yscale="log", xlabel="triangles of a surface",
             ylabel="bonds, over those of no mesh")
    axes.set_title("Bonds in equilibrium; lines: theory on the same triangles", loc="left")
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize=8.5)
    plots.save(figure, "bondRates.png")


if __name__ == "__main__":
    main()
