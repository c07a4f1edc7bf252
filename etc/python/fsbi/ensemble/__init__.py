# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ensembles of runs: the parts of applications/utilities/fsbiEnsemble. Runs, and the
numbers out of them, are those of fsbi.studies.

dictionary   system/ensembleDict, checked         sampling     which values go together
study        which runs, which of them count      statistics   what they say
report       tables and what is printed           draw         the picture
patients     a table of them                      treatment    a drug, and when it is given
smallest     dose for a probability
"""
