# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drag on spheres in tubes; write results.csv."""

import os
import sys

import numpy as np

from fsbi import fields, tube
from fsbi.case import Case, cases
from fsbi.results import Results

U, RADIUS = 1e-3, 8         # um/us, of the sphere or on the axis; um, of the tube
EXACT = {"moving": ("K1", tube.drag_moving), "held": ("K2", tube.drag_held)}
# Multipoles and waves: 1e-6 up to 0.8 of the tube, and at 0.9
TERMS = {0.9: (12, 72)}
# bound: asked for in tubes of any walls; 1 % on edges of 0.3 radii, the default size of a
# sphere, 0.3 % on finer ones; whatever the edges of the walls far from it
BOUND = {"0.3": 1e-2, "0.15": 1e-2, "0.1": 3e-3}
quick = sys.argv[1:2] == ["true"]
results = Results("C1")


class Run(Case):
    def __init__(self, folder):
        super().__init__(folder)
        kind, self.edge, radius, order, self.way = os.path.basename(folder).split("_")
        self.width = float(radius)
        self.variant = f"{kind}_{order}_{radius}_edge{self.edge}"
        stokes = 6 * np.pi * RADIUS * self.width * U
        self.found = abs(self.force("leukocyte")[-1, 0]) / stokes


def over_flow(run):
    """Velocity of the free sphere over that on the axis of a tube with the same flow rate,
    which all sections have: its integral over the tube and the sphere, by the length."""
    u, volume = (fields.internal(os.path.join(run.folder, "4500", "fluid", name))
                 for name in "UV")
    speed = run.history["bodies/leukocyte/velocity"]["x"][-1]
    sphere = 4 / 3 * np.pi * 4**3
    rate = (np.sum(volume[:, 0] * u[:, 0]) + sphere * speed) / 32
    return speed * np.pi * RADIUS**2 / (2 * rate)


def main():
    for run in cases("runs/periodic_*"):
        # bound: as for tubes with ends, of edges of 0.3 radii; images of the sphere are
        # three tube radii away, where its flow has decayed to 1e-5
        results.add("velocity_over_flow", over_flow(run), tube.velocity(0.5), BOUND["0.3"],
                    variant=os.path.basename(run.folder), seconds=run.processor_seconds,
                    cells=run.cells)
    for run in (Run(run.folder) for run in cases("runs/*_*_*_*_*")):
        name, exact = EXACT[run.way]
        results.add(name, run.found, exact(run.width, *TERMS.get(run.width, ())),
                    BOUND[run.edge], variant=run.variant, seconds=run.processor_seconds,
                    cells=run.cells)
    # bound: theory, Haberman and Sayre's tables as Happel and Brenner print them
    # (table 7-3.1), to their last digit where their series has converged
    for radius, k1, k2 in ((0.1, 1.263, 1.255), (0.2, 1.680, 1.635), (0.3, 2.371, 2.231)):
        results.add("table_K1", tube.drag_moving(radius), k1, 1e-3, variant=f"{radius}")
        results.add("table_K2", tube.drag_held(radius), k2, 1e-3, variant=f"{radius}")
    results.write()


if __name__ == "__main__":
    main()
