# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest stress in the sphere over the angle: none in theory."""

from fsbi import plots
from fsbi.case import Case

YOUNG = 0.504e-3        # pg/um/us2
STEP = 10               # degrees

time, stress = Case(".").largest("stress", "sphere")
figure, axes = plots.plt.subplots()
axes.axhline(1e-10, color="black", lw=1.2, label="bound of validation S4")
axes.semilogy(STEP * time, stress / YOUNG, marker="o", mfc="white", label="fsbiFoam")
axes.set(xlabel="angle (degrees)", ylabel="largest stress / E", ylim=(1e-14, 1e-9))
axes.set_title("A sphere turned rigidly: no stress in theory", loc="left")
axes.legend()
plots.save(figure, "stress.png")
print(f"    largest stress / E {max(stress) / YOUNG:.1e}")
