# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Best values of entries of a case: the parts of applications/utilities/fsbiOptimise.
Runs, and the numbers out of them, are those of fsbi.studies; what varies, seeds and
intervals those of fsbi.ensemble.

dictionary   system/optimiseDict, checked         search     where to measure next
study        points, their runs, the best one     report     table, picture, what is printed
"""
