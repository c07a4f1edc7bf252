# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as it would be observed: no tractions; of what is held, below y = 4.5,
it is only known that it is held (nan).

    hide_held.py surface.csv observed.csv
"""

import sys

import numpy as np


def main():
    data = np.genfromtxt(sys.argv[1], delimiter=",", skip_header=1)
    data[:, 6:] = 0
    data[data[:, 1] < 4.5, 6:] = np.nan
    np.savetxt(sys.argv[2], data, delimiter=",", header="x,y,z,ux,uy,uz,tx,ty,tz", comments="",
               fmt="%.12g")


if __name__ == "__main__":
    main()
