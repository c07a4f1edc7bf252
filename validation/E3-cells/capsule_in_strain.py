# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A capsule in a straining flow, of any deformation, by integrals over its membrane.

A sphere of radius 1 in an unbounded flow u = (x, -y/2, -z/2) rate of Stokes' fluid, filled
with a liquid as viscous as the one around it, moves with

    u(x0) = u_flow + 1/(8 pi mu) integral of G(x - x0).f dA,     G = 1/d + d d/d^3,

where f is what the membrane pulls with, by area: the divergence of its tensions. All is
symmetric about the axis, and from end to end: material points at the angle t from the axis at
first are at

    x = sum of a_k cos(k t),   r = sum of b_k sin(k t),   k = 1, 3, 5, ...

and f follows from these exactly, by the principal stretches of the meridian and of the ring
and their derivatives. Integrals around the axis are elliptic ones, those along the meridian
Gauss' on either side of each of the points where the velocity is asked for, with points
crowded at it, t - t0 = l g^3, which leaves nothing of the logarithm there. Differences of
places are those of the sums, not of places.

The steady shape has no velocity at as many points as there are coefficients, and the volume of
the sphere: Newton's method. Nothing flows inside then, so it is that of any ratio of
viscosities. On the way there the rates of the coefficients are those of the points' velocities.

Lengths are over the radius, times times the rate, tensions over the shear modulus; Ca is
mu rate radius/shear modulus."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipe, ellipkm1


def tensions(law, a, b, tension):
    """Along the stretch a where b is the one across, with derivatives by a and b; by the
    papers' formulas for tensions, not by the energies."""
    if law == "neoHookeanMembrane":
        return (a / b - (a * b)**-3 + tension,
                1 / b + 3 * a**-4 * b**-3, -a / b**2 + 3 * a**-3 * b**-4)
    C = 1                       # Skalak's
    return (a / b * (a**2 - 1) + C * a * b * ((a * b)**2 - 1) + tension,
            (3 * a**2 - 1) / b + C * (3 * a**2 * b**3 - b),
            -a * (a**2 - 1) / b**2 + C * (3 * a**3 * b**2 - a))


def ring(X, dr, r0):
    """Velocities at radius r0 by forces on a ring of radius r0 + dr, X further along the axis,
    times the ring's radius: (xx, xr, rx, rr), of x by x, of x by r, ... One around the axis
    over the distance d is `one`, over its cube `three`; with 1 - cos, R and P; with its square
    over the cube, Q."""
    r = r0 + dr
    two, gap = 2 * r * r0, X**2 + dr**2
    A2 = gap + 2 * two
    A, K, E = np.sqrt(A2), ellipkm1(gap / A2), ellipe(2 * two / A2)
    one, three = 4 * K / A, 4 * E / A / gap
    R = (4 * A * E - gap * one) / two
    P = 4 * (K - E) / A / two
    Q = (4 * A * E - 2 * gap * one + 4 * gap * E / A) / two**2
    # near the axis these cancel, and the rule of equal steps is exact
    far = 2 * two < 0.3 * A2
    less = 1 - np.cos(np.pi / 8 * np.arange(16))
    over = (gap[far][:, None] + two[far][:, None] * less)**-0.5
    for found, power, times in ((R, 1, 1), (P, 3, 1), (Q, 3, 2)):
        found[far] = np.pi / 8 * np.sum(over**power * less**times, 1)
    return (r * (one + X**2 * three), r * X * (dr * three + r0 * P),
            r * X * (dr * three - r * P),
            r * (one - R + dr**2 * (three - P) - r * r0 * Q))


class Meridian:
    """Places and their derivatives by the angle, at angles, of coefficients (a, b)."""

    def __init__(self, angle, k):
        self.angle, self.k = angle, k
        self.cos, self.sin = np.cos(angle[..., None] * k), np.sin(angle[..., None] * k)

    def at(self, y):
        k = self.k
        a, b = y.reshape(2, -1)
        return ((self.cos @ a, -self.sin @ (k * a), -self.cos @ (k**2 * a)),
                (self.sin @ b, self.cos @ (k * b), -self.sin @ (k**2 * b)))


class CapsuleInStrain:
    """n coefficients of each coordinate; law: neoHookeanMembrane or Skalak (C = 1); tension:
    isotropic, the same whatever the stretch."""

    def __init__(self, Ca, law, tension=0, n=12, points=32):
        self.Ca, self.law, self.tension, self.n = Ca, law, tension, n
        k = 2 * np.arange(n) + 1
        angle = (np.arange(n) + 0.5) * np.pi / (2 * n)
        g, w = np.polynomial.legendre.leggauss(points)
        g, w = (g + 1) / 2, w * 3 / 2 * ((g + 1) / 2)**2
        sides = np.stack([-angle, np.pi - angle], 1)[:, :, None]
        steps = (sides * g**3).reshape(n, -1)
        self.weight = (np.abs(sides) * w).reshape(n, -1)
        self.nodes = Meridian(angle, k)
        self.sources = Meridian(angle[:, None] + steps, k)
        half = np.sin(steps[..., None] * k / 2)
        middle = (angle[:, None] + steps / 2)[..., None] * k
        self.cos_change, self.sin_change = -2 * np.sin(middle) * half, 2 * np.cos(middle) * half
        g, w = np.polynomial.legendre.leggauss(6 * n)
        self.whole, self.whole_weight = Meridian((g + 1) * np.pi / 2, k), w * np.pi / 2

    def load(self, on, y):
        """Length by angle, the membrane's pull by area (x, r), and its tensions."""
        (_, x1, x2), (r, r1, r2) = on.at(y)
        sine, cosine = np.sin(on.angle), np.cos(on.angle)
        a, b = np.hypot(x1, r1), r / sine
        a1, b1 = (x1 * x2 + r1 * r2) / a, (r1 - b * cosine) / sine
        along, by_a, by_b = tensions(self.law, a, b, self.tension)
        around = tensions(self.law, b, a, self.tension)[0]
        tx, tr = x1 / a, r1 / a         # the normal outwards is (tr, -tx)
        tangential = (by_a * a1 + by_b * b1) / a + tr / r * (along - around)
        bend = (tx * r2 - tr * x2) / a**2
        normal = -bend * along + tx / r * around
        return a, (tangential * tx + normal * tr, tangential * tr - normal * tx), (along, around)

    def velocity(self, y):
        """Of the nodes: along the axis and from it."""
        length, (fx, fr), _ = self.load(self.sources, y)
        a, b = y.reshape(2, -1)
        x, r = (place[0] for place in self.nodes.at(y))
        xx, xr, rx, rr = ring(self.cos_change @ a, self.sin_change @ b, r[:, None])
        weight = self.weight * length / (8 * np.pi * self.Ca)
        return (x + np.sum(weight * (xx * fx + xr * fr), 1),
                -r / 2 + np.sum(weight * (rx * fx + rr * fr), 1))

    def sphere(self):
        y = np.zeros(2 * self.n)
        y[0] = y[self.n] = 1
        return y

    def moments(self, y):
        """Volume, and its means of x^2 and y^2."""
        (x, x1, _), (r, _, _) = self.whole.at(y)
        weight = self.whole_weight * np.pi * r**2 * -x1
        volume = weight.sum()
        return volume, (weight * x**2).sum() / volume, (weight * r**2).sum() / 4 / volume

    def steady(self, y=None, tolerance=1e-7):
        """Coefficients; y: from where, None: what the flow makes of the sphere in 3 times."""
        def residual(z):
            (_, x1, _), (_, r1, _) = self.nodes.at(z[:-1])
            length = np.hypot(x1, r1)
            u, v = self.velocity(z[:-1])
            # forces along the normal of one size move nothing: volume for one of the equations
            return np.concatenate([u + z[-1] * r1 / length, v - z[-1] * x1 / length,
                                   [self.moments(z[:-1])[0] - 4 * np.pi / 3]])
        z = np.append(self.after([3])[-1] if y is None else y, 0)
        steps = 1e-6 * np.eye(len(z))
        for _ in range(15):
            slope = np.array([residual(z + h) - residual(z - h) for h in steps]).T / 2e-6
            change = np.linalg.solve(slope, -residual(z))
            z = z + change
            if np.abs(change).max() < tolerance:
                return z[:-1]
        raise ArithmeticError("no steady shape was found")

    def after(self, times):
        """Coefficients at times from the start of the flow around the sphere."""
        to_a, to_b = np.linalg.inv(self.nodes.cos), np.linalg.inv(self.nodes.sin)

        def rate(_, y):
            u, v = self.velocity(y)
            return np.concatenate([to_a @ u, to_b @ v])
        found = solve_ivp(rate, (0, times[-1]), self.sphere(), "LSODA", times,
                          rtol=1e-6, atol=1e-7)
        return found.y.T

    def sharpness(self, y):
        """Mean over the surface of the squares of stretches over radii of curvature: 1 of the
        sphere."""
        (_, x1, x2), (r, r1, r2) = self.whole.at(y)
        a, b = np.hypot(x1, r1), r / np.sin(self.whole.angle)
        along, around = (x1 * r2 - r1 * x2) / a**2, b * x1 / a / r
        area = self.whole_weight * a * r
        return (area * (along**2 + around**2)).sum() / 2 / area.sum()

    def taylor(self, y, of_ellipsoid=True):
        """(L - B)/(L + B) of the half length and width, or of the axes of the ellipsoid with
        the shape's second moments, which is what histories have."""
        if of_ellipsoid:
            L, B = np.sqrt(self.moments(y)[1:])
        else:
            a, b = y.reshape(2, -1)
            L, B = a.sum(), (b * (-1)**np.arange(self.n)).sum()
        return (L - B) / (L + B)
