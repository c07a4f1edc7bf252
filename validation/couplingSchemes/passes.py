# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What theory says of one pass of partitioned coupling: an elastic sphere in a
viscous fluid, mode by mode of its surface (spherical harmonics of degree n).

A displacement given to the fluid moves the surface with `rate` times it (1/dt in
the first step, 3/2 of that by BDF2 in others). The fluid answers with the
traction - A mu/a rate d, the body with - B G/a d. With the Robin term robin mu/a
(validation's: 1.5) a pass takes an error d to

    (B + robin r)^-1 (robin - A) r d,       r = mu rate/G.

Torsional modes: A = n + 2, B = n - 1. Of degree 1 they are the body's rotation:
B = 0, so that a pass takes its error to (robin - 3)/robin, -1 at any r. Modes of
degree 2 that a straining flow makes, d = P E.n + Q (n.E.n) n: A and B below, from
the two decaying solutions of Stokes outside and the two of Navier inside.
"""

import numpy as np

ROBIN = 1.5
A = np.array([[3.0, -2.0], [0.0, 8.0]])


def inside(nu):
    """B: of the strain E.x, and of al r^2 E.x + be (x.E.x) x that is in
    equilibrium; tractions by Hooke's law over G."""
    L = 2 * nu / (1 - 2 * nu)
    al, be = 2 * (2 + 5 * (1 + L)), -2 * (5 + 2 * (1 + L))
    traction = np.array([[2, 4 * al + 2 * be],
                         [0, L * (2 * al + 5 * be) + 4 * be + 2 * al]])
    return traction @ np.linalg.inv([[1, al], [0, be]])


def contractions(r, nu, highest):
    """Factors by which a pass multiplies errors, r with the rate of the step."""
    factors = [(ROBIN - n - 2) * r / (n - 1 + ROBIN * r) for n in range(1, highest + 1)]
    strain = np.linalg.solve(inside(nu) + ROBIN * r * np.eye(2), r * (ROBIN * np.eye(2) - A))
    return np.array([*factors, *np.linalg.eigvals(strain).real])


def relaxed_limit(omega, nu, highest):
    """Largest mu/(G dt) at which passes relaxed by omega contract: all factors
    above 1 - 2/omega, with the rate of BDF2."""
    ratios = np.logspace(-4, 4, 2001)
    good = [contractions(1.5 * r, nu, highest).min() > 1 - 2 / omega for r in ratios]
    return ratios[np.argmin(good)] if not all(good) else np.inf


def growth(ratio, A, B):
    """Largest factor by which one pass a step multiplies errors of the steps before:
    the fluid moves with the extrapolated surface, (d_n - d_n-1)/dt, and the Robin
    term is 3/2 robin/dt (d_n+1 - 2 d_n + d_n-1)."""
    A, B = np.atleast_2d(A), np.atleast_2d(B)
    s = 1.5 * ROBIN * ratio * np.eye(len(A))
    left = np.linalg.inv(B + s)
    companion = np.block([[left @ (2 * s - ratio * A), left @ (ratio * A - s)],
                          [np.eye(len(A)), np.zeros_like(A)]])
    return np.abs(np.linalg.eigvals(companion)).max()


def explicit_limit(nu, highest):
    """Largest mu/(G dt) at which one pass a step is stable; the rotation is, at any."""
    ratios = np.logspace(-4, 4, 2001)
    good = [max(growth(r, A, inside(nu)), *(growth(r, n + 2.0, n - 1.0)
                for n in range(2, highest + 1))) < 1 for r in ratios]
    return ratios[np.argmin(good)]


def splitting(ratio, turn, nu, steps):
    """Error of the semi-axes, over the radius, that one pass a step leaves of the
    solution after these steps of gamma dt = turn, from rest; small strain."""
    def axes(explicit):
        d = [np.zeros(2)]
        for n in range(steps):
            rate = 1.5 if n else 1.0
            known = -2 * d[-1] + 0.5 * d[-2] if n else -d[-1]
            # a rigid sphere takes 5 mu E.n from the flow, E = gamma/2
            load = 2.5 * turn * ratio * np.array([1, 0]) - ratio * A @ known
            r = rate * ratio
            if explicit:
                guess = 2 * d[-1] - d[-2] if n else d[-1]
                load = load + r * (ROBIN * np.eye(2) - A) @ guess
                d.append(np.linalg.solve(inside(nu) + ROBIN * r * np.eye(2), load))
            else:
                d.append(np.linalg.solve(inside(nu) + r * A, load))
        return d[-1].sum()
    return abs(axes(True) - axes(False))


if __name__ == "__main__":
    print("semiImplicit, omega 0.5: to", relaxed_limit(0.5, 0.3, 10))
    print("explicit: to", explicit_limit(0.3, 10))
    for r in (1e-3, 1e-2, 1e-1, 1, 10, 100, 1000):
        print(f"r {r:g}: explicit leaves {splitting(r, 0.05, 0.3, 3):.2g}; factors of passes",
              np.sort(contractions(1.5 * r, 0.3, 10))[:3])
