# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of a beam on hexahedra and tetrahedra: orders, bounds, a plot.

    check.py S2 "Beam under its own weight" quick|full
"""

import sys

from fsbi import plots
from fsbi.errors import Study
from fsbi.results import Results

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
# bound: asked of order 4
FOURTH = {
    "hexahedra": {"pointD": 3.5, "sigma": 2.5, "sigmazz": 2.5, "pointSigma": 2.5},
    "tetrahedra": {"pointD": 3.5, "sigma": 2.8, "sigmazz": 2.8, "pointSigma": 2.8},
}


def name_of(field):
    return FIELDS.get(field, "displacement").replace(" ", "_")


def fourth_order(results, quick):
    """By order 4: cells' displacements are means there, those at vertices count."""
    for kind, lowest in FOURTH.items():
        study, second = Study(f"runs/order4.{kind}[0-9]*"), Study(f"runs/{kind}[0-9]*")
        # on the finest mesh of both
        i, j = max((i, j) for i, h in enumerate(study.h) for j, g in enumerate(second.h)
                   if abs(g / h - 1) < 1e-6)
        for field, order in lowest.items():
            cost = dict(study.cost(i), variant=kind)
            error = study.error(field)[i]
            if results.case == "S2":
                # bound: quadratic displacements are exact; the solver's tolerance, 1e-10
                results.add(f"order4_{name_of(field)}_abs", error, 0, 1e-8, **cost)
                continue
            # bound: asked: four times smaller on equal cells
            results.add(f"order4_{name_of(field)}_over_order2_abs",
                        error / second.error(field)[j], 0, 0.25, **cost)
            if not quick:
                results.at_least(f"order4_order_of_{name_of(field)}", study.order(field),
                                 order, variant=kind)


def check(case, quick):
    """Sizes and errors by field and kind of mesh."""
    # bound: the table of cases, 0.1 % with 16 cells across; four times that with
    # the 8 of the quick form, by second order
    displacement = 0.001 * (4 if quick else 1)
    results = Results(case)
    curves = {}
    for kind, lowest in (QUICK if quick else LOWEST).items():
        study = Study(f"runs/{kind}[0-9]*")
        for field, order in lowest.items():
            name = f"order_of_{FIELDS[field]}_{kind}".replace(" ", "_")
            results.at_least(name, study.order(field), order, **study.cost())
        results.add(f"displacement_{kind}_abs", study.error("D")[-1], 0, displacement,
                    **study.cost())
        for field in FIELDS:
            curves[field, kind] = (study.h / 0.3, study.error(field))
    fourth_order(results, quick)
    results.write()
    return curves


def draw(picture, curves, fields, title):
    plots.convergence(
        picture, None, {f"{FIELDS[f]}, {k}": curves[f, k] for f, k in curves if f in fields},
        xlabel="cell size / width", ylabel="relative error, l2", title=title)


def main(case, title, form):
    curves = check(case, form == "quick")
    if form != "quick":
        draw("displacement.png", curves, ["D"], f"{title}: displacement")
        draw("stress.png", curves, ["sigma", "pointSigma"], f"{title}: stress")


if __name__ == "__main__":
    main(*sys.argv[1:])
