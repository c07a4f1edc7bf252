# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Transport of a solute by theory, and by other ways of computing it.

Sphere of radius 1 and concentration 1 in a Stokes flow of speed 1, Pe = U a/D,
Sherwood number Sh = 2 a k/D (twice the mean gradient at the surface):

    sherwood_fit        Clift, Grace and Weber, Bubbles, Drops, and Particles
                        (1978), eq. 3-49: Sh = 1 + (1 + 2 Pe)^(1/3), with a stated
                        accuracy of 2 % of numerical solutions
    sherwood_thin       Acrivos and Goddard, J. Fluid Mech. 23 (1965) 273: of thin
                        boundary layers, Sh = 1.249 Pe^(1/3) + 0.922
    sherwood            the equation itself, by Legendre polynomials in the angle and
                        fourth-order differences in the radius
"""

import numpy as np
from scipy import sparse, special
from scipy.linalg import solve_banded
from scipy.sparse.linalg import spsolve


def sherwood_fit(pe):
    return 1 + (1 + 2 * pe) ** (1 / 3)


def sherwood_thin(pe):
    return 1.249 * pe ** (1 / 3) + 0.922


def _products(n, f):
    """Matrix of the integrals (2 k + 1)/2 int P_k f(mu, P_m, P_m') dmu."""
    mu, w = np.polynomial.legendre.leggauss(2 * n)
    p = np.array([special.eval_legendre(k, mu) for k in range(n)])
    one = 1 - mu**2
    slope = np.array([k * (special.eval_legendre(k - 1, mu) - mu * p[k]) / one if k else 0 * mu
                      for k in range(n)])
    factor = (2 * np.arange(n) + 1)[:, None] / 2
    return factor * ((p * w) @ f(mu, p, slope).T)


def sherwood(pe):
    """u_r = cos(t) (1 - 3/(2 r) + 1/(2 r^3)),
    u_t = -sin(t) (1 - 3/(4 r) - 1/(4 r^3)); r = exp(s), c = sum f_k(r) P_k.
    With twice the modes, or twice as far, it is the same to seven digits."""
    modes, points, far = ((30, 400, 60) if pe < 3 else (60, 300, 10) if pe < 30
                          else (90, 300, 3))
    s = np.linspace(0, np.log(far), points)
    h = s[1] - s[0]
    r = np.exp(s)
    radial = r * (1 - 1.5 / r + 0.5 / r**3)
    along = r * (1 - 0.75 / r - 0.25 / r**3)
    cosine = _products(modes, lambda mu, p, slope: mu * p)
    turning = _products(modes, lambda mu, p, slope: (1 - mu**2) * slope)
    first, second = differences(points, h)
    inner = sparse.diags(np.r_[0, np.ones(points - 2), 0])
    k = np.arange(modes)
    # r^2 lap c = f'' + f' - k(k+1) f;  r^2 u.grad c = Pe (U_r mu f' + U_t f)
    left = (sparse.kron(inner @ (second + first), sparse.eye(modes))
            - sparse.kron(inner, sparse.diags(k * (k + 1.0)))
            - pe * sparse.kron(inner @ sparse.diags(radial) @ first, cosine)
            - pe * sparse.kron(inner @ sparse.diags(along), turning))
    # c = 1 at the sphere; far away 0 in front of it, and behind what flows out
    begin = sparse.diags(np.r_[1, np.zeros(points - 1)])
    end = sparse.diags(np.r_[np.zeros(points - 1), 1])
    front = _products(modes, lambda mu, p, slope: (mu < 0) * p)
    back = _products(modes, lambda mu, p, slope: (mu > 0) * p)
    left = (left + sparse.kron(begin, sparse.eye(modes)) + sparse.kron(end, front)
            + sparse.kron(end @ first, back))
    rhs = np.zeros(points * modes)
    rhs[0] = 1
    f = spsolve(left.tocsc(), rhs).reshape(points, modes)
    return -2 * (first @ f[:, 0])[0]


def differences(n, h):
    """First and second derivatives on n points, of fourth order, one-sided at the
    ends."""
    first, second = sparse.lil_matrix((n, n)), sparse.lil_matrix((n, n))
    for i in range(n):
        a = min(max(i - 2, 0), n - 6) if i in (0, 1, n - 2, n - 1) else i - 2
        width = 6 if i in (0, 1, n - 2, n - 1) else 5
        x = (np.arange(a, a + width) - i) * h
        powers = np.vander(x, width, increasing=True).T
        for k, matrix in ((1, first), (2, second)):
            e = np.zeros(width)
            e[k] = k
            matrix[i, a:a + width] = np.linalg.solve(powers, e)
    return first.tocsr(), second.tocsr()


def surface_at_constant_flux(t):
    """Concentration at a sphere of radius 1 that has released a flux of 1 since
    t = 0 into D = 1, Carslaw and Jaeger (1959), 9.10."""
    return 1 - special.erfcx(np.sqrt(t))


def flux_at_constant_concentration(t):
    """Flux from a sphere of radius 1 and concentration 1, D = 1."""
    return 1 + 1 / np.sqrt(np.pi * t)


def leveque(length, pe):
    """Mean flux into a shear flow u = y over a plate of concentration 1 and this
    length, D = 1/Pe, over D: 3/(2 Gamma(4/3)) (Pe/(9 L))^(1/3)."""
    return 1.5 / special.gamma(4 / 3) * (pe / (9 * length)) ** (1 / 3)


def graetz(length, pe, points=1200, steps=4000):
    """The same into u = y (1 - y), in a channel whose wall y = 0 has the
    concentration 1 and whose other wall lets nothing pass; without diffusion along
    x, marched along it with steps that grow, cells that shrink towards the wall."""
    edge = np.linspace(0, 1, points + 1) ** 2
    y, width = (edge[1:] + edge[:-1]) / 2, np.diff(edge)
    u = (edge[1:]**2 / 2 - edge[1:]**3 / 3 - edge[:-1]**2 / 2 + edge[:-1]**3 / 3) / width
    g = np.zeros(points + 1)
    g[1:-1] = 1 / np.diff(y) / pe
    g[0] = 1 / y[0] / pe
    x = length * np.linspace(0, 1, steps + 1) ** 3
    c, total = np.zeros(points), 0.0
    for dx in np.diff(x):
        m = np.zeros((3, points))
        m[0, 1:] = -g[1:-1]
        m[2, :-1] = -g[1:-1]
        m[1] = u * width / dx + g[:-1] + g[1:]
        b = u * width / dx * c
        b[0] += g[0]
        c = solve_banded((1, 1), m, b)
        total += dx * g[0] * (1 - c[0])
    return total * pe / length


def bound(t, k_on, k_off, points=2000):
    """Part of the sites taken on a wall along which the concentration is linear from
    0 to 1, by Langmuir's law at every place, in the mean."""
    c = (np.arange(points) + 0.5) / points
    rate = k_on * c + k_off
    return np.mean(k_on * c / rate * -np.expm1(-rate * t))
