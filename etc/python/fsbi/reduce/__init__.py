# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A table of resistances for method 'reduced': the parts of
applications/utilities/fsbiReduce. Runs of samples are those of fsbi.studies.

dictionary   system/reduceDict, checked           surrogate    splines, and their error
study        samples and their runs               table        constant/reduced.h5
frames       where bodies stand, and axes of a wall and of a body beside it
"""
