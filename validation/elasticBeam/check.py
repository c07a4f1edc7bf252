# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of a beam on hexahedra and tetrahedra: orders, bounds, a plot.

    check.py S2 "Beam under its own weight"
"""

import sys

from fsbi import plots
from fsbi.errors import Study
from fsbi.results import Results

case, title = sys.argv[1:3]
FIELDS = {"D": "displacement", "sigma": "stress", "sigmazz": "axial stress",
          "pointSigma": "point stress"}
LOWEST = {
    "hexahedra": {"D": 1.95, "sigma": 1.95, "sigmazz": 1.95},
    "tetrahedra": {"D": 1.9, "pointSigma": 1.5},
}
results = Results(case)
curves = {}
for kind, lowest in LOWEST.items():
    study = Study(f"runs/{kind}[0-9]*")
    for field, order in lowest.items():
        name = f"order_of_{FIELDS[field]}_{kind}".replace(" ", "_")
        results.at_least(name, study.order(field), order, **study.cost())
    # edges 1/16 of the width; the quick form ends at 1/8
    results.add(f"displacement_{kind}_abs", study.error("D")[-1], 0,
                1e-3 if len(study.runs) > 2 else 5e-3, **study.cost())
    for field in ("D", "sigma", "pointSigma"):
        curves[f"{FIELDS[field]}, {kind}"] = (study.h / 0.3, study.error(field))
results.write()
plots.convergence("convergence.png", None, curves, xlabel="cell size / width",
                  ylabel="relative error, l2", title=title)
