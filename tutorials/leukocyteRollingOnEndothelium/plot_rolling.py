# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Way, velocity, pauses and bonds of the leukocyte."""

import numpy as np

from fsbi import adhesion, plots
from fsbi.history import History

WINDOW = 2000           # us, over which a velocity is taken
START = 20000           # us, when it has been caught

history = History("postProcessing/history.h5")
free = History("free/postProcessing/history.h5")["bodies/leukocyte/velocity"]["x"][-1]
position = history["bodies/leukocyte/position"]
bonds = history["effects/bonds/selectin"]
time, way = position["time"], position["x"] - position["x"][0]
rolls = time >= START
motion = adhesion.rolling(time[rolls], way[rolls], free, WINDOW)

figure, (where, fast, many) = plots.plt.subplots(3, 1, figsize=(6.4, 8.2), sharex=True)
where.plot(1e-3 * time, way, color=plots.COLOURS[0], label="with bonds")
where.plot(1e-3 * time, np.minimum(free * time, 1.5 * way[-1]), color="black", lw=1.2,
           ls="--", label="without")
where.set(ylabel="way (µm)", ylim=(0, 1.3 * way[-1]))
where.set_title("A leukocyte on a wall with selectin", loc="left")
where.legend()
fast.plot(1e-3 * motion.time, 1e3 * motion.speed, color=plots.COLOURS[0],
          label=f"mean over {1e-3 * WINDOW:.0f} ms")
fast.axhline(1e3 * free, color="black", lw=1.2, ls="--", label="without bonds")
for i, (first, last) in enumerate(motion.pauses):
    fast.axvspan(1e-3 * first, 1e-3 * last, color=plots.COLOURS[1], alpha=0.25, lw=0,
                 label="pauses" if i == 0 else None)
fast.set(ylabel="velocity (mm/s)")
fast.legend()
many.step(1e-3 * bonds["time"], bonds["number"], where="post", color=plots.COLOURS[0])
many.set(xlabel="time (ms)", ylabel="bonds", ylim=(0, None))
plots.save(figure, "rolling.png")

count = np.trapz(bonds["number"][rolls], time[rolls]) / np.ptp(time[rolls])
print(f"    from {1e-3 * START:.0f} ms on: mean velocity {1e3 * motion.mean:.3f} mm/s, "
      f"without bonds {1e3 * free:.3f}; {len(motion.pauses)} pauses, "
      f"{100 * motion.pause_fraction:.0f} % of the time; {count:.1f} bonds")
