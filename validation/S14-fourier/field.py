# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""0/T of a box of n^3 cells: random waves of all lengths, long ones larger
(amplitude over kappa^2, kappa: eigenvalue), so that none is hidden for long.

    field.py n [periodic|walls]
"""

import os
import sys

import numpy as np


def main():
    n = int(sys.argv[1])
    kind = sys.argv[2] if len(sys.argv) > 2 else "periodic"
    c = np.cos(2 * np.pi * np.arange(n) / n)
    kappa = (3 - c[:, None, None] - c[:, None] - c) / 3
    kappa[0, 0, 0] = np.inf
    waves = np.fft.fftn(np.random.default_rng(1).uniform(-1, 1, (n, n, n)))
    values = np.fft.ifftn(waves / kappa**2).real.ravel()
    patch = {"periodic": "type cyclic;", "walls": "type fixedValue; value uniform 0;"}
    os.makedirs("0", exist_ok=True)
    with open("0/T", "w") as file:
        file.write("FoamFile { version 2.0; format ascii; class volScalarField; "
                   "object T; }\ndimensions [0 0 0 1 0 0 0];\n"
                   f"internalField nonuniform List<scalar> {n**3} (\n")
        file.write("\n".join(f"{v:.16g}" for v in values))
        file.write(f'\n);\nboundaryField {{ ".*" {{ {patch[kind]} }} }}\n')


if __name__ == "__main__":
    main()
