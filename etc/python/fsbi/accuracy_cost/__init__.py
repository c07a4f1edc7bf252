# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs: the parts of applications/utilities/fsbiAccuracyCost.

quantities   a number out of a finished run
parameters   what is varied, and how              predict      seconds of a run to come
runs         copies, runs, keeps what they gave   study        plan, errors, advice
draw         the picture                          report       variants.csv, report.md
"""


class Refused(Exception):
    """Something that the user gave cannot be used; the text says what."""
