# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Relative speed of the cells with its moving mean, and the bonds between
them."""

import math

from fsbi import adhesion, plots
from fsbi.history import History

INTERVAL, SAMPLES = 30, 75      # us; of the mean
STOPPED = 0.1                   # of the speed at the start

history = History("postProcessing/history.h5")
bonds = history["effects/bonds/LFA1-ICAM1"]
time, speed = adhesion.relative_speed(history, "tumourCell", "leukocyte", INTERVAL)
mean = adhesion.moving_mean(speed, SAMPLES)
start = adhesion.aggregate_time(time, mean, STOPPED * speed[0])

figure, (fast, many) = plots.plt.subplots(2, 1, figsize=(6.4, 6.4), sharex=True)
fast.plot(1e-3 * time, 1e3 * speed, color=plots.COLOURS[0], label="speed")
fast.plot(1e-3 * time, 1e3 * mean, color=plots.COLOURS[1], ls="--",
          label=f"mean of {SAMPLES} samples")
fast.axhline(1e3 * STOPPED * speed[0], color="black", lw=1, ls=":",
             label="below: aggregate")
fast.set(ylabel="relative speed (mm/s)", ylim=(0, None))
fast.set_title("The tumour cell against the leukocyte", loc="left")
fast.legend()
many.step(1e-3 * bonds["time"], bonds["number"], where="post", color=plots.COLOURS[0])
many.set(xlabel="time (ms)", ylabel="bonds", ylim=(0, None))
many.set_title("Bonds between them", loc="left")
plots.save(figure, "aggregate.png")

print(f"    formed {bonds['formed'].sum():.0f}, broken {bonds['broken'].sum():.0f}, "
      f"at most {bonds['number'].max():.0f} bonds")
print("    no aggregate" if math.isnan(start) else
      f"    aggregate from {1e-3 * start:.1f} ms on")
