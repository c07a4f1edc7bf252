# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Best relaxation factors of m Jacobi steps on linear elasticity, from nothing
but the symbol of the equations: own code, that of src/fourier is not used.

    best_factors.py [references.csv]

The range of the eigenvalues kappa of D^-1 A over all waves, phi >= phiMin, is
looked for on grids of waves and then by Nelder and Mead's method. The product
p(kappa) = (1 - w_1 kappa)...(1 - w_m kappa), p(0) = 1, whose largest magnitude
over that range is least is found by exchange (Remez): solve for the p that
takes +r and -r in turn at m + 1 points, move these to the extremes of p, until
none is higher than r. No formula of Chebyshev's is used. How far it has
converged is printed, and written as error_gain_*: what half as many samples
of kappa change.
"""

import sys

import numpy as np
from scipy.optimize import minimize, minimize_scalar

NU = 0.3
STEPS = (2, 3, 4, 5, 8)
CAP = 2.95              # where the search behind figure 3.10 seems to have ended


def eigenvalues(phi):
    """Of D^-1 A for waves, rows of phi; equal spacings; (3.84-3.98) for w = 1:
    mu grad^2 u + (mu + lambda) grad div u by central differences."""
    mu, lam = 1.0, 2 * NU / (1 - 2 * NU)
    c, s = np.cos(phi), np.sin(phi)
    A = np.empty((len(phi), 3, 3))
    for i in range(3):
        for j in range(3):
            A[:, i, j] = (mu + lam) * s[:, i] * s[:, j]
        A[:, i, i] = 2 * mu * (3 - c.sum(axis=1)) + 2 * (mu + lam) * (1 - c[:, i])
    return np.linalg.eigvalsh(A / (6 * mu + 2 * (mu + lam)))


def ends_on_grid(low, n):
    """Lowest and highest eigenvalue of n^3 waves amid cells of the grid."""
    edge = low + (np.pi - low) * (np.arange(n) + 0.5) / n
    phi = np.stack(np.meshgrid(edge, edge, edge, indexing="ij"), -1).reshape(-1, 3)
    kappa = eigenvalues(phi)
    return (kappa[:, 0].min(), phi[kappa[:, 0].argmin()],
            kappa[:, 2].max(), phi[kappa[:, 2].argmax()])


def polish(function, start, low):
    """The least value in the box; coordinates beyond it are brought back."""
    def inside(x):
        return np.clip(x, low, np.pi)

    for _ in range(3):
        found = minimize(lambda x: function(inside(x)), start, method="Nelder-Mead",
                         options=dict(xatol=1e-13, fatol=1e-16, maxiter=4000))
        start = inside(found.x)
    return found.fun


def ends(low, table=False):
    for n in (8, 16, 32, 64):
        least, at_least, most, at_most = ends_on_grid(low, n)
        if table:
            print(f"    {n:3d}^3 waves: kappa from {least:.8f} to {most:.8f}")
    return (polish(lambda x: eigenvalues(x[None])[0, 0], at_least, low),
            -polish(lambda x: -eigenvalues(x[None])[0, 2], at_most, low))


def extremes(p, a, b, samples):
    """Ends of the range and where |p| has a local maximum, by parabolas."""
    x = np.linspace(a, b, samples)
    y = np.abs(np.polyval(p, x))
    top = np.nonzero((y[1:-1] >= y[:-2]) & (y[1:-1] > y[2:]))[0] + 1
    d1, d2 = (y[top + 1] - y[top - 1]) / 2, y[top + 1] - 2 * y[top] + y[top - 1]
    return np.r_[a, x[top] - d1 / d2 * (x[1] - x[0]), b]


def best_product(m, a, b, samples):
    """(largest magnitude, factors)"""
    x = np.linspace(a, b, m + 1)
    sign = (-1.0) ** np.arange(m + 1)
    for _ in range(60):
        # 1 + c_1 x + ... + c_m x^m = r sign
        matrix = np.column_stack([*(x**k for k in range(1, m + 1)), -sign])
        *c, r = np.linalg.solve(matrix, -np.ones(m + 1))
        p = np.r_[c[::-1], 1.0]
        x = extremes(p, a, b, samples)
        highest = np.abs(np.polyval(p, x)).max()
        if len(x) != m + 1 or highest < abs(r) * (1 + 1e-14):
            break
    return highest, np.sort(1 / np.roots(p).real)


def capped_pair(a, b, cap):
    """(largest magnitude, lower factor) of two steps, one of them the cap."""
    def highest(w):
        p = np.polymul([-cap, 1], [-w, 1])
        return np.abs(np.polyval(p, extremes(p, a, b, 4001))).max()
    grid = np.linspace(0.3, 1, 701)
    start = grid[np.argmin([highest(w) for w in grid])]
    # there is one minimum, with a kink: golden section
    found = minimize_scalar(highest, bracket=(start - 1e-3, start, start + 1e-3),
                            method="golden", tol=1e-13)
    return found.fun, found.x


def main(path):
    rows = []
    low = np.pi / 64
    print("Range of the eigenvalues, phi from pi/64 on")
    a, b = ends(low, table=True)
    print(f"    looked for further: {a:.12f} to {b:.12f}")
    one = np.log(best_product(1, a, b, 4001)[0])
    print("Steps, gain a step, by half as many samples more or less")
    for m in STEPS:
        gains = []
        for samples in (2001, 4001, 8001):
            highest, factors = best_product(m, a, b, samples)
            gains.append(np.log(highest) / m / one)
        error = abs(gains[2] - gains[1])
        print(f"    {m} {gains[2]:.10f} {gains[0] - gains[2]:.1e} {gains[1] - gains[2]:.1e}")
        rows += [(f"gain_{m}", gains[2]), (f"error_gain_{m}", error)]
        if m == 2:
            rows += [("pair_lower", factors[0]), ("pair_upper", factors[1]),
                     ("radius_pair", highest)]
    highest, lower = capped_pair(a, b, CAP)
    rows += [("capped_lower", lower), ("gain_capped", np.log(highest) / 2 / one)]
    coarse = ends(np.pi / 4.5)
    rows.append(("gain_coarse", np.log(best_product(2, *coarse, 8001)[0]) / 2
                 / np.log(best_product(1, *coarse, 8001)[0])))
    with open(path, "w") as file:
        file.write("quantity,value\n")
        file.writelines(f"{name},{value:.15g}\n" for name, value in rows)
    for name, value in rows:
        print(f"{name} {value:.12g}")


if __name__ == "__main__":
    main(*(sys.argv[1:] or ["references.csv"]))
