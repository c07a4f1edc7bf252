# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the cell is, how long it is, and the flow that it lets through."""

import numpy as np
from make_vessel import STRAIGHT, THROAT, resistance

from fsbi import plots
from fsbi.history import History

PRESSURE = 2e-2         # pg/(um us2), over the whole channel
VISCOSITY = 1           # pg/(um us)
CELL = 3.6              # um, its radius

history = History("postProcessing/history.h5")
centre = history["elasticBodies/cell/centre"]
axes = history["elasticBodies/cell/semiAxes"]
flow = history["flow/inlet"]
flow = {key: flow[key][:len(centre)] for key in ("time", "in")}
x = centre["x"]
ms = centre["time"] / 1000

figure, (above, middle, below) = plots.plt.subplots(3, 1, figsize=(6.8, 7.4), sharex=True)
above.plot(ms, x, color=plots.COLOURS[0], marker="o", mfc="white", markevery=4)
above.axhspan(-STRAIGHT, STRAIGHT, color="0.9", label="the throat")
above.set_ylabel("centre (µm)")
above.legend()
middle.plot(ms, axes["longest"], color=plots.COLOURS[0], label="longest semi-axis")
middle.plot(ms, axes["shortest"], color=plots.COLOURS[1], label="shortest")
middle.axhline(THROAT, color="black", lw=1.2, label="radius of the throat")
middle.set_ylabel("(µm)")
middle.legend()
below.plot(ms, flow["in"], color=plots.COLOURS[0], label="fsbiFoam")
below.axhline(PRESSURE / (VISCOSITY * resistance()), color="black", lw=1.2,
              label="Poiseuille's law, no cell")
below.set(xlabel="time (ms)", ylabel="flow (µm³/µs)", ylim=(0, 0.08))
below.legend()
above.set_title("A soft cell passes a throat", loc="left")
plots.save(figure, "passage.png")

# the surface touches the throat's entrance first, and is free when its end has left it
enters = np.interp(-STRAIGHT, x + axes["longest"], centre["time"])
leaves = np.interp(STRAIGHT, x - axes["longest"], centre["time"])
through = (x > -STRAIGHT) & (x < STRAIGHT)
free = PRESSURE / (VISCOSITY * resistance())
print(f"    the cell, {2 * CELL} um wide, passes the throat, {2 * THROAT} um wide, from "
      f"{enters / 1000:.1f} to {leaves / 1000:.1f} ms")
print(f"    and is {axes['longest'][through].max() / axes['shortest'][through].min():.2f} times "
      "as long as wide in it")
print(f"    flow at least {flow['in'][5:].min():.4f} um3/us with the cell in the throat, "
      f"{flow['in'][-1]:.4f} when it has left (Poiseuille's law {free:.4f})")
