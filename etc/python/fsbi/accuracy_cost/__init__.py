# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs: the parts of applications/utilities/fsbiAccuracyCost. Runs,
and the numbers out of them, are those of fsbi.studies.

parameters   what is varied, and how              predict      seconds of a run to come
study        plan, errors, advice                 draw         the picture
report       variants.csv, report.md
multilevel   cheapest levels and seeds for a mean over chance
pilot        runs of some seeds on all levels, for these
"""
