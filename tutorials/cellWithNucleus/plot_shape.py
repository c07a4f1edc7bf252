# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cell's deformation and inclination, and the deformation of a cell without a nucleus."""

import os

from fsbi import cell_shape
from fsbi.case import reference

CA = 0.1            # viscosity times shear rate over the cytoplasm's shear modulus

# Steady shape without a nucleus, incompressible
without = next(row for row in reference(os.path.join(
    os.environ["FSBI_DIR"], "validation/B2-elasticSphere/reference/steady.csv"))
    if row["Ca"] == CA)
cell_shape.draw(rate=5e-5, steady=without["D_exact"], angle=without["theta_deg"],
                label="without a nucleus, exact",
                title="A cell with a stiff nucleus in shear, µγ/G = 0.1")
