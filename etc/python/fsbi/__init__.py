# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading, checking and drawing the results of fsbiFoam's cases.

history   time series of a run      results   results.csv and its bounds
plots     curves, convergence       picture   meshes, bodies and fields
movie     films of those            pictures  small files of all of them
case      a finished run            errors    distance from an exact solution
convergence    orders, limits       accuracy_cost  the parts of fsbiAccuracyCost
studies   runs of many copies       ensemble       the parts of fsbiEnsemble
                                    optimise       the parts of fsbiOptimise

In a shell, `python3 -m fsbi history CASE` prints a history.
"""
