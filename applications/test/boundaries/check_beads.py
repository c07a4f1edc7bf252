"""Velocities of beads in the middle of a periodic Couette flow of shear 0.5."""
import sys

import numpy as np

from fsbi.history import History

turns = []
for case in sys.argv[1:]:
    history = History(f"{case}/postProcessing/history.h5")
    V = history["bodies/bead/velocity"].array[-1, 1:]
    omega = history["bodies/bead/angularVelocity"].array[-1, 1:]
    print(case, "V", V, "omega", omega)
    turns.append(omega[1])
    if np.abs(V).max() > 2e-3:
        sys.exit(f"{case}: the bead drifts with {V}")
    # walls four radii away, images sixteen
    if abs(omega[1]/0.25 - 1) > 0.05 or abs(omega[[0, 2]]).max() > 2e-3:
        sys.exit(f"{case}: the bead turns with {omega}")
if abs(turns[0]/turns[1] - 1) > 0.01:
    sys.exit(f"{turns}: the place matters")
# solved to 1e-9
if np.abs(np.array(turns[2:])/turns[1] - 1).max() > 1e-7:
    sys.exit(f"{turns}: the number of processes matters")
