# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Orders of convergence, and the limit of a series of values over cell or step sizes.

Errors against an exact solution, h: sizes of cells or steps, coarse to fine:

    orders(h, errors)                   of each pair of neighbours
    overall_order(h, errors)            of a straight line through all logarithms

Values f = limit + C h^p whose limit is not known:

    order_of_three(h, f)                p, by the last three
    richardson(h, f, order=2)           limit, by the last two and a known order
    found = estimate(h, f)              limit, order and how sure they are, by all
    found.limit, found.order, found.uncertainty, found.kind

In an estimate the finer values weigh more (Eca and Hoekstra, J. Comput. Phys. 262,
2014). The uncertainty is that of the limit, as in the grid convergence index
(Roache): a safety factor times the correction from the finest value, with the
order bounded by 2, plus four times the scatter about the fit (few values have
little scatter by chance). The factor is 1.25 where the values behave, else 3. Kinds:

    asymptotic    the fit is good, orders between 0.5 and 4
    monotone      one direction, but not (yet) with one order; two values only
    scattered     the differences change sign: no order; the limit is the finest
                  value, uncertain by twice the range of the finest three, or
                  by that of all up to four times the finest size
    settled       all the same to 1e-12
"""

import collections

import numpy as np
from scipy.optimize import brentq

Estimate = collections.namedtuple("Estimate", "limit order factor uncertainty kind")

LOWEST, HIGHEST, FORMAL = 0.5, 4.0, 2.0
ORDERS = np.linspace(0.05, 6, 1191)
GOOD, POOR = 1.25, 3.0


def orders(h, errors):
    h, errors = np.asarray(h, float), np.asarray(errors, float)
    return np.log(errors[1:] / errors[:-1]) / np.log(h[1:] / h[:-1])


def overall_order(h, errors):
    return np.polyfit(np.log(h), np.log(errors), 1)[0]


def order_of_differences(h, coarse, fine):
    """Of three sizes h and how far the values on the coarser two, and on the finer
    two, are apart; nan outside 0.01 and 20."""
    def lack(p):
        return (h[0]**p - h[1]**p) / (h[1]**p - h[2]**p) - coarse / fine
    low, high = 0.01, 20.0
    return brentq(lack, low, high, xtol=1e-12) if lack(low) < 0 < lack(high) else np.nan


def order_of_three(h, f):
    return order_of_differences(h[-3:], f[-3] - f[-2], f[-2] - f[-1])


def richardson(h, f, order=2):
    """Also of arrays, one for each size."""
    return f[-1] + (f[-1] - f[-2]) / ((h[-2] / h[-1])**order - 1)


def line(h, v, order):
    """Limit, C and the weighted scatter of v = limit + C h^order."""
    weight = np.sqrt((1 / h) / np.sum(1 / h))
    matrix = np.column_stack((np.ones_like(h), h**order))
    found = np.linalg.lstsq(matrix * weight[:, None], v * weight, rcond=None)[0]
    left = (v - matrix @ found) * weight
    return found[0], found[1], float(np.sqrt(np.sum(left**2)))


def fit(h, v):
    """The order of least scatter, and its line."""
    tried = [line(h, v, p) for p in ORDERS]
    # three values have no scatter at their order: the first that is as good
    scatter = np.array([t[2] for t in tried])
    best = int(np.argmin(scatter))
    return float(ORDERS[best]), tried[best]


def estimate(h, values):
    """From sizes and values in any order; two or more."""
    h, v = np.asarray(h, float), np.asarray(values, float)
    if len(h) < 2 or len(set(h)) != len(h):
        raise ValueError("an estimate needs two or more different sizes")
    order = np.argsort(-h)
    h, v = h[order], v[order]
    spread = np.ptp(v)
    if spread <= 1e-12 * max(np.abs(v).max(), 1e-300):
        return Estimate(v[-1], np.nan, 0.0, spread, "settled")
    steps = np.diff(v)
    if len(h) > 2 and not _one_way(steps):
        wide = max(2 * np.ptp(v[-3:]), np.ptp(v[h <= 4 * h[-1]]))
        return Estimate(v[-1], np.nan, np.nan, wide, "scattered")
    if len(h) == 2:
        limit, factor, _ = line(h, v, FORMAL)
        return Estimate(limit, np.nan, factor, POOR * abs(v[-1] - limit), "monotone")
    return _fitted(h, v, spread)


def _one_way(steps):
    """Do all differences have one sign, but for those lost in rounding?"""
    seen = steps[np.abs(steps) > 1e-3 * np.abs(steps).max()]
    return bool(np.all(seen > 0) or np.all(seen < 0))


def _fitted(h, v, spread):
    order, (limit, factor, scatter) = fit(h, v)
    good = LOWEST <= order <= HIGHEST and scatter < 0.02 * spread
    # outside the range an order is chance: not more than the formal one is
    # believed, not less than the lowest used
    used = float(np.clip(order, LOWEST, FORMAL))
    if not LOWEST <= order <= HIGHEST:
        limit, factor, scatter = line(h, v, used)
    careful = line(h[-2:], v[-2:], used)[0]
    distance = max(abs(v[-1] - limit), abs(v[-1] - careful))
    kind = "asymptotic" if good else "monotone"
    return Estimate(limit, order if LOWEST <= order <= HIGHEST else used, factor,
                    (GOOD if good else POOR) * distance + 4 * scatter, kind)
