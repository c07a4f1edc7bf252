# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of the template maxDrift: drift.py DISTANCE"""

import sys

import numpy as np

from fsbi.history import History

distance = float(sys.argv[1])
end = 4000
velocity = History("drift/postProcessing/history.h5")["bodies/tumourCell/velocity"]
speed = np.sqrt(velocity["x"] ** 2 + velocity["y"] ** 2 + velocity["z"] ** 2)
ends = velocity["time"]
with open("drift/postProcessing/steps/0/steps.dat") as file:
    limits = [line.split(maxsplit=7)[7].strip() for line in file if line[0] != "#"]
with open("drift/log.fsbiFoam") as file:
    told = sum("dt by drift of tumourCell" in line for line in file)

drifts = [i for i, limit in enumerate(limits) if limit == "drift of tumourCell"]
if len(drifts) < 5 or told != len(drifts):
    sys.exit(f"{len(drifts)} steps by drift in the history, {told} in the log")
for i in drifts:
    longest = distance / speed[i - 1]
    left = end - ends[i - 1]
    # a whole number of them up to the end of the run
    wanted = left / np.ceil(left / longest - 1e-6)
    # bound: times are written with 12 digits, steps are a tenth of them
    if not np.isclose(ends[i] - ends[i - 1], wanted, rtol=1e-9):
        sys.exit(f"step {i} is {ends[i] - ends[i - 1]}, not {wanted}")
