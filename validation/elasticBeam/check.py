# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of a beam on hexahedra and tetrahedra: orders, bounds, a plot.

    check.py S2 "Beam under its own weight" quick|full
"""

import sys

from fsbi import plots
from fsbi.errors import Study
from fsbi.results import Results

case, title = sys.argv[1:3]
quick = sys.argv[3] == "quick"
FIELDS = {"D": "displacement", "sigma": "stress", "sigmazz": "axial stress",
          "pointSigma": "point stress"}
# bound: the project's table of cases, S2 and S3
LOWEST = {
    "hexahedra": {"D": 1.95, "sigma": 1.95, "sigmazz": 1.95},
    "tetrahedra": {"D": 1.9, "pointSigma": 1.5},
}
# bound: of the quick form, whose meshes are not yet in the asymptotic range:
# nearer to second order than to first (stress on tetrahedra: nearer to 1.5 than
# to 1). The displacement on tetrahedra is judged by its size only
QUICK = {
    "hexahedra": {"D": 1.5, "sigma": 1.5, "sigmazz": 1.5},
    "tetrahedra": {"pointSigma": 1.25},
}
# bound: the table of cases, 0.1 % with 16 cells across; four times that with
# the 8 of the quick form, by second order
DISPLACEMENT = 0.001 * (4 if quick else 1)
results = Results(case)
curves = {}
for kind, lowest in (QUICK if quick else LOWEST).items():
    study = Study(f"runs/{kind}[0-9]*")
    for field, order in lowest.items():
        name = f"order_of_{FIELDS[field]}_{kind}".replace(" ", "_")
        results.at_least(name, study.order(field), order, **study.cost())
    results.add(f"displacement_{kind}_abs", study.error("D")[-1], 0,
                DISPLACEMENT, **study.cost())
    for field in FIELDS:
        curves[field, kind] = (study.h / 0.3, study.error(field))
results.write()


def draw(picture, fields, what):
    plots.convergence(
        picture, None, {f"{FIELDS[f]}, {k}": curves[f, k] for f, k in curves
                        if f in fields},
        xlabel="cell size / width", ylabel="relative error, l2",
        title=f"{title}: {what}")


if not quick:
    draw("displacement.png", ["D"], "displacement")
    draw("stress.png", ["sigma", "pointSigma"], "stress")
