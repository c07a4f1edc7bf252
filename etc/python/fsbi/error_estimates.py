# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What estimates of errors are worth where the errors are known.

    worth_of_estimates(results, [(0.004, 0.0021), ...])     # estimate, error
"""

import numpy as np


def worth_of_estimates(results, pairs):
    """Over runs that the estimate's constant was not found by."""
    ratios = np.array([estimate / error for estimate, error in pairs])
    # bound: seldom below the error: in one of ten runs
    results.add("errors_above_estimate_abs", (ratios < 1).mean(), 0, 0.1,
                variant=f"{len(ratios)} runs")
    # bound: mostly not above three times the error: in half of all runs
    results.at_least("estimates_below_3_errors", (ratios <= 3).mean(), 0.5,
                     variant=f"{len(ratios)} runs")
