# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights over the axis of two cells that inertia moves to their focusing position."""

from fsbi import plots
from fsbi.history import History

FOCUS = 13.8        # um: where finite elements have no lift, validation/E1-inertia

figure, axes = plots.plt.subplots()
for colour, (case, name) in zip(plots.COLOURS, {".": "inner", "outer": "outer"}.items()):
    path = History(f"{case}/postProcessing/history.h5")["bodies/cell/position"]
    axes.plot(path["time"] / 1000, path["y"], color=colour, marker="o", mfc="white",
              label=f"released at {path['y'][0]:.0f} µm")
    print(f"    {name} cell: from {path['y'][0]:.1f} to {path['y'][-1]:.1f} um")
axes.axhline(FOCUS, color="black", lw=1.2, ls="--", label="no lift, finite elements")
axes.set(xlabel="time (ms)", ylabel="height over the axis (µm)")
axes.set_title("Inertia focuses cells", loc="left")
axes.legend()
plots.save(figure, "focusing.png")
