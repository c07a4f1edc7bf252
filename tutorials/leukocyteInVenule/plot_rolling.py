# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Way of the leukocyte, its bonds, and what it takes of the flow."""

import numpy as np

from fsbi import plots
from fsbi.history import History

LATE = 0.5              # part of the run that counts as rolling

history = History("postProcessing/history.h5")
position = history["bodies/leukocyte/position"]
bonds = history["effects/bonds/selectin"]
flow = history["flow/mean"]
ms = 1e-3 * position["time"]
way = position["x"] - position["x"][0]
free = history["bodies/leukocyte/velocity"]["x"][0]     # nothing is bound yet

figure, (where, many, through) = plots.plt.subplots(3, 1, figsize=(6.4, 8.2), sharex=True)
where.plot(ms, way, color=plots.COLOURS[0], label="with bonds")
where.plot(ms, np.minimum(1e3 * free * ms, 1.5 * way[-1]), color="black", lw=1.2, ls="--",
           label="without")
where.set(ylabel="way (µm)", ylim=(0, 1.3 * way[-1]))
where.set_title("A leukocyte on the wall of a venule", loc="left")
where.legend()
many.step(1e-3 * bonds["time"], bonds["number"], where="post", color=plots.COLOURS[0])
many.set(ylabel="bonds", ylim=(0, None))
through.plot(1e-3 * flow["time"], 100 * flow["x"] / flow["x"][0], color=plots.COLOURS[0])
through.set(xlabel="time (ms)", ylabel="flow (% of that at the start)")
plots.save(figure, "rolling.png")

late = ms >= (1 - LATE) * ms[-1]
speed = np.ptp(way[late]) / np.ptp(ms[late])
print(f"    in the last {ms[late][-1] - ms[late][0]:.0f} ms: {speed:.3f} mm/s, without bonds "
      f"{1e3 * free:.3f}; {bonds['number'][late].mean():.1f} bonds; flow "
      f"{100 * (1 - flow['x'][late].mean() / flow['x'][0]):.1f} % less than at the start")
