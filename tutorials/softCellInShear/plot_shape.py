# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell's deformation and inclination against the exact values."""

import os

from fsbi import cell_shape
from fsbi.case import reference

CA = 0.1            # viscosity times shear rate over the shear modulus

# Steady shape, incompressible
exact = next(row for row in reference(os.path.join(
    os.environ["FSBI_DIR"], "validation/B2-elasticSphere/reference/steady.csv"))
    if row["Ca"] == CA)
cell_shape.draw(rate=5e-5, steady=exact["D_exact"], angle=exact["theta_deg"], label="exact",
                title="A soft cell in shear, µγ/G = 0.1")
