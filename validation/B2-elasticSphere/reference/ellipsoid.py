# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An ellipsoid that deforms homogeneously in a simple shear u = (y, 0, 0).

Stokes flow around it, with a velocity linear in x on its surface, has a
closed solution: forces S n on the surface, S uniform, make inside a flow linear
in x and a uniform pressure (divergence theorem and the potentials of a
homogeneous ellipsoid; Eshelby 1957, in Mura's notation). A surface that carries
the difference of two uniform stresses is all that a homogeneous elastic
body puts there, so that body and fluid are solved exactly.

Lengths: radius of the sphere free of stress. Times: 1/shear rate. Stresses:
viscosity times shear rate, so that the shear modulus is 1/Ca. All in
the principal axes of the ellipsoid, the first at theta to the flow, the
third along the vorticity. The fluid's pressure far away is zero.

fsbi.ellipsoid moves such bodies in time, with another integral for the flow; here
are steady shapes, stable or not, and the largest Ca that has one.
"""

import functools

import numpy as np
from scipy.optimize import fsolve

NODES = 32      # of the Gauss-Legendre quadrature
UNIT = np.zeros((4, 3, 3))
for _i, _j, _k in ((0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 0, 1)):
    UNIT[_i, _j, _k] = UNIT[_i, _k, _j] = 1


@functools.lru_cache
def quadrature(nodes):
    """Gauss-Legendre on 0 ... 1."""
    t, weight = np.polynomial.legendre.leggauss(nodes)
    return 0.5 * (t + 1), 0.5 * weight


def potentials(a, nodes=NODES):
    """I_i and I_ij (Mura, eq. 11.36) of the semi-axes a: 2 pi a1 a2 a3 times the
    integrals over s from 0 of 1/((a_i^2 + s) Delta) and 1/((a_i^2 + s)(a_j^2 + s)
    Delta), with s = c^2 (1/t^2 - 1); equal axes are nothing special."""
    t, weight = quadrature(nodes)
    c = np.prod(a)**(1 / 3)
    g = c**2 + np.subtract.outer(a**2, [c**2]) * t**2           # (a^2 + s) t^2
    common = 4 * np.pi * np.prod(a) * c**2 * weight / np.sqrt(np.prod(g, axis=0))
    return (common * t**2 / g).sum(axis=1), (common * t**4 / g) @ (1 / g).T


def disturbance(a, S, integrals):
    """What symmetric S does inside: the velocity gradient, and the pressure.
    The stress just outside is that inside less S."""
    I, II = integrals
    spread = a[:, None]**2 * II
    gradient = 2 * spread * S - np.diag((I - spread) @ np.diag(S))
    return gradient / (8 * np.pi), -(I @ np.diag(S)) / (4 * np.pi)


def balance(a, theta, stress, nodes=NODES):
    """Velocity gradient of an ellipsoid whose principal stresses are given up
    to a pressure; the pressure to be taken from them, and that of the fluid."""
    c, s = np.cos(theta), np.sin(theta)
    ambient = np.outer([c, -s, 0], [s, c, 0])
    integrals = potentials(a, nodes)
    unit = [disturbance(a, S, integrals)[0] for S in UNIT]
    # 2 sym(ambient + disturbance) - pressure - S is the stress; trace S = 0
    system = np.zeros((4, 4))
    system[:3, :3] = 2 * np.array([np.diag(u) for u in unit[:3]]).T - np.eye(3)
    system[:3, 3], system[3, :3] = -1, 1
    normal = np.linalg.solve(system, [*(stress - 2 * np.diag(ambient)), 0])
    slope = unit[3] + unit[3].T
    shear = (ambient[0, 1] + ambient[1, 0]) / (1 - slope[0, 1])
    S = np.diag(normal[:3]) + shear * UNIT[3]
    gradient, pressure = disturbance(a, S, integrals)
    return ambient + gradient, normal[3], pressure, S


def stresslet(a, theta, stress):
    """In the axes of the flow, over viscosity, shear rate and radius^3: forces S n on
    the surface of a fluid everywhere make the same flow."""
    S = balance(a, theta, stress)[3]
    c, s = np.cos(theta), np.sin(theta)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    return -4 / 3 * np.pi * np.prod(a) * R @ S @ R.T


class StVenantKirchhoff:
    compressible = True

    def __init__(self, nu):
        self.lame = 2 * nu / (1 - 2 * nu)

    def stress(self, a):
        """Principal Cauchy stresses over the shear modulus at stretches a."""
        strain = 0.5 * (a**2 - 1)
        return a**2 * (self.lame * strain.sum() + 2 * strain) / np.prod(a)


class NeoHookean(StVenantKirchhoff):
    """mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2."""

    def stress(self, a):
        J = np.prod(a)
        return (a**2 - 1 + self.lame * np.log(J)) / J


class IncompressibleNeoHookean:
    compressible = False

    def stress(self, a):
        return a**2 - (a**2).mean()


def deformation(a):
    return (a[0] - a[1]) / (a[0] + a[1])


def defects(x, law, nodes=NODES):
    """What vanishes if x = (ln semi-axes, theta, ln Ca) stays as it is: rates
    of two axes and of theta, difference of pressure or volume."""
    a = np.exp(x[:3])
    L, pressure, fluid, _ = balance(a, x[3], law.stress(a) / np.exp(x[4]), nodes)
    # The shape's tensor B changes by L B + B L^T
    return np.array([L[0, 0], L[2, 2], L[0, 1] * a[1]**2 + L[1, 0] * a[0]**2,
                     pressure - fluid if law.compressible else x[:3].sum()])


def root(function, x):
    """Of a function of several numbers, from a guess."""
    found, _, status, why = fsolve(function, x, xtol=1e-13, full_output=True)
    if status != 1:
        raise RuntimeError(f"there is no solution: {why}")
    return found


def start(Ca):
    """First order in Ca: D = 5/4 Ca, theta = pi/4 - 3/4 Ca."""
    return np.array([1.25 * Ca, -1.25 * Ca, 0, np.pi / 4 - 0.75 * Ca, np.log(Ca)])


def steady(law, Ca, x=None, nodes=NODES):
    """At a capillary number, from a neighbour's x."""
    x = start(Ca) if x is None else x
    return root(lambda x: np.append(defects(x, law, nodes), x[4] - np.log(Ca)), x)


def at_deformation(law, D, x=None, nodes=NODES):
    """At (a1 - a2)/(a1 + a2) = D: passes a fold, where Ca is largest."""
    x = start(0.8 * D) if x is None else x
    return root(lambda x: np.append(defects(x, law, nodes),
                                    np.tanh(0.5 * (x[0] - x[1])) - D), x)


def branch(law, D, nodes=NODES):
    """Continuation over rising deformations: one x each."""
    found = []
    for d in D:
        guess = None
        if len(found) == 1:
            guess = found[0]
        elif len(found) > 1:
            guess = 2 * found[-1] - found[-2]
        found.append(at_deformation(law, d, guess, nodes))
    return np.array(found)


def fold(law, step, nodes=NODES, start=0.4, end=0.6):
    """Largest Ca of a branch, and its deformation: parabola through the largest
    value and its neighbours; none if Ca still rises at the end."""
    D = np.arange(start, end, step)
    Ca = np.exp(branch(law, D, nodes)[:, 4])
    k = Ca.argmax()
    if k == len(Ca) - 1:
        raise ValueError(f"no fold below a deformation of {end}")
    left, right = Ca[k] - Ca[k - 1], Ca[k + 1] - Ca[k]
    offset = 0.5 * (left + right) / (left - right)
    return Ca[k] + 0.25 * (left + right) * offset, D[k] + offset * step


def start_up(law, Ca, times, step, nodes=NODES):
    """Semi-axes and theta at multiples of the step, from a sphere at rest, of an
    incompressible law: Runge-Kutta 4 for B, dB/dt = L B + B L^T."""
    def axes(B):
        theta = 0.5 * np.arctan2(2 * B[0, 1], B[0, 0] - B[1, 1])
        c, s = np.cos(theta), np.sin(theta)
        R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        return np.sqrt(np.diag(R.T @ B @ R)), theta, R

    def rate(B):
        a, theta, R = axes(B)
        L = R @ balance(a, theta, law.stress(a) / Ca, nodes)[0] @ R.T
        return L @ B + B @ L.T

    B, found, done = np.eye(3), [], 0
    for count in np.rint(np.asarray(times) / step).astype(int):
        for _ in range(count - done):
            k1 = rate(B)
            k2 = rate(B + 0.5 * step * k1)
            k3 = rate(B + 0.5 * step * k2)
            k4 = rate(B + step * k3)
            B = B + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        done = count
        found.append(axes(B)[:2])
    return found


def by_surface(a, S, x, points):
    """Velocities at points x inside, from the forces S n on the surface by
    quadrature: no potential of an ellipsoid is used."""
    z, weight = np.polynomial.legendre.leggauss(points)
    phi = np.pi * np.arange(2 * points) / points
    r = np.sqrt(1 - z**2)
    sphere = np.stack([np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)),
                       np.outer(z, np.ones_like(phi))], axis=-1).reshape(-1, 3)
    area = np.repeat(weight * np.pi / points, 2 * points)
    force = np.prod(a) * area[:, None] * ((sphere / a) @ S.T)       # S n dA
    u = []
    for point in x:
        d = point - a * sphere
        distance = np.linalg.norm(d, axis=1)[:, None]
        u.append((force / distance + d * (d * force).sum(axis=1)[:, None] / distance**3)
                 .sum(axis=0) / (8 * np.pi))
    return np.array(u)
