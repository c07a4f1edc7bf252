# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The capsule's deformation and inclination, and the steady ones of theory."""

from fsbi import cell_shape

# At first order in the deformation: capsule(5, "Skalak", 20, 60) of
# validation/E3-cells/small_deformation.py
cell_shape.draw(rate=5e-5, steady=0.0912, angle=30.6, label="small deformations",
                title="A capsule in shear, µγa/G = 0.05")
