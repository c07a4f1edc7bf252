# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What runs that chance, or the user, made different say together.

    low, high = proportion(happened, trials, confidence)    # Wilson's
    low, high = mean(values, confidence)                    # bootstrap, BCa
    first, total = sensitivities(f)         # Sobol's indices, see Indices

References
    Wilson, E.B. (1927). Probable inference, the law of succession, and statistical
    inference. J. Am. Stat. Assoc. 22, 209-212.
    Efron, B. (1987). Better bootstrap confidence intervals. J. Am. Stat. Assoc. 82,
    171-185.
    Saltelli, A. et al. (2010). Comput. Phys. Commun. 181, 259-270: first order (b) of
    table 2; total (f), which is Jansen's.
"""

import collections
import warnings

import numpy as np
from scipy import stats

from fsbi import adhesion

RESAMPLES = 2000
SEED = 1                    # the same values have the same interval

# one number a parameter each, and the ends of their intervals
Indices = collections.namedtuple("Indices", "first firstLow firstHigh total totalLow totalHigh")


def proportion(happened, trials, confidence=0.95):
    return adhesion.wilson(happened, trials, stats.norm.ppf(0.5 + confidence / 2))


def mean(values, confidence=0.95):
    """Of the mean; nan of fewer than three values, which say nothing of their spread."""
    values = np.asarray(values, float)
    if len(values) < 3:
        return np.nan, np.nan
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")         # it says so by nan, too
        found = stats.bootstrap((values,), np.mean, confidence_level=confidence,
                                n_resamples=RESAMPLES, batch=200, method="BCa",
                                random_state=np.random.default_rng(SEED))
    low, high = found.confidence_interval
    if not np.isfinite([low, high]).all():       # all are equal, or nearly
        low, high = _percentiles(_resampled(values), confidence)
    return float(low), float(high)


def _resampled(values):
    random = np.random.default_rng(SEED)
    return [values[random.integers(len(values), size=len(values))].mean()
            for _ in range(RESAMPLES)]


def _percentiles(values, confidence):
    tail = 50 * (1 - confidence)
    return np.percentile(values, [tail, 100 - tail], axis=0)


def sensitivities(f):
    """f: columns A, B, A with column i from B, one row of each sample. First-order and
    total indices of every i; nan if nothing varies."""
    a, b, ab = f[:, :1], f[:, 1:2], f[:, 2:]
    both = f[:, :2]
    variance = both.var()
    if variance == 0:
        return np.full((2, ab.shape[1]), np.nan)
    # less scatter of the first-order sum without the mean
    return np.array([((b - both.mean()) * (ab - a)).mean(axis=0),
                     0.5 * ((ab - a) ** 2).mean(axis=0)]) / variance


def indices(f, confidence=0.95):
    """Both, with percentiles of the bootstrap over samples."""
    f = np.asarray(f, float)
    random = np.random.default_rng(SEED)
    again = [sensitivities(f[random.integers(len(f), size=len(f))]) for _ in range(RESAMPLES)]
    again = np.array([s for s in again if np.isfinite(s).all()])
    first, total = sensitivities(f)
    if not len(again):
        return Indices(*[np.full(len(first), np.nan)] * 6)
    low, high = _percentiles(again, confidence)
    return Indices(first, low[0], high[0], total, low[1], high[1])
