# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of many copies of a case: what fsbiAccuracyCost, fsbiEnsemble and
fsbiOptimise share.

entries      of a case's dictionaries     quantities   a number out of a finished run
runs         copies, runs, keeps what they gave        spread       some at a time
command      line of a study                    formula      of the numbers of a run
"""


class Refused(Exception):
    """Something that the user gave cannot be used; the text says what."""
