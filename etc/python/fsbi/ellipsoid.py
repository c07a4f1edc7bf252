# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An elastic sphere in a linear Stokes flow: exact motion, for any law and any
formulation, step by step or in the limit of short steps.

    motion = Motion(saint_venant_kirchhoff(nu=0.3), Ca=0.05)
    times, D, angle, J = motion.march(step=0.05, end=1.5)

The sphere becomes an ellipsoid, and remains one: its strain is uniform, and
what a uniform stress in an ellipsoid does to the flow around it is a uniform
velocity gradient inside (Eshelby's result, for an incompressible fluid). Here
that gradient is an integral over directions, so that no table of elliptic
integrals is needed. A is the mean of n n over the directions n = F^-T m of
all unit vectors m; T_ijkl the mean of (delta_ik - n_i n_k) n_l n_j. The flow
is that of a fluid everywhere, of viscosity 1, with the stress s - 2 D + p in
excess inside, and a source where the body changes its volume,

    L = L_far + T : (2 D - s) + tr L A,      A : (2 D - s) = 2 tr L.

Lengths in radii, times in 1/rate of the flow, stresses in viscosity times rate:
the law's, in units of the shear modulus, are divided by Ca = viscosity rate/G.

    Eshelby, J.D. (1957). Proc. R. Soc. Lond. A 241, 376-396.
    Gao, T., Hu, H.H. & Ponte Castaneda, P. (2011). J. Fluid Mech. 687, 209-237.
"""

import numpy as np
from scipy.optimize import fsolve

UNIT = np.eye(3)
SHEAR = np.outer([1, 0, 0], [0, 1, 0])


# First Piola-Kirchhoff stresses over the shear modulus

def _ratio(nu):
    """Lame's lambda over the shear modulus."""
    return 2 * nu / (1 - 2 * nu)


def saint_venant_kirchhoff(nu):
    def stress(F):
        strain = (F.T @ F - UNIT) / 2
        return F @ (_ratio(nu) * np.trace(strain) * UNIT + 2 * strain)
    return stress


def neo_hookean(nu):
    def stress(F):
        inverse = np.linalg.inv(F).T
        return F - inverse + _ratio(nu) * np.log(np.linalg.det(F)) * inverse
    return stress


def corotational(nu):
    """Hooke's law for Biot's strain."""
    def stress(F):
        left, stretches, right = np.linalg.svd(F)
        R = left @ right
        return 2 * (F - R) + _ratio(nu) * (stretches.sum() - 3) * R
    return stress


# Stress on the mesh before the step, whose deformation is `before`

def general(law, F, before):
    """totalLagrangian and updatedLagrangian."""
    return law(F) @ before.T / np.linalg.det(before)


def slow_process(law, F, before):
    """F'' (S(F') + S(F''))"""
    step = F @ np.linalg.inv(before)
    return step @ np.linalg.inv(before) @ law(before) + law(step)


def slow_process_total_strain(law, F, before):
    """F'' S(F)"""
    return F @ np.linalg.inv(before) @ np.linalg.inv(F) @ law(F)


# The flow

def _directions(n=24):
    z, weight = np.polynomial.legendre.leggauss(n)
    angle = np.pi * np.arange(2 * n) / n
    r = np.sqrt(1 - z**2)
    m = np.stack([np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle)),
                  np.outer(z, np.ones(2 * n))], axis=-1)
    return m.reshape(-1, 3), np.repeat(weight / (4 * n), 2 * n)


DIRECTIONS, WEIGHTS = _directions()


def velocity_gradient(F, sigma, far):
    """In the body F of Cauchy stress sigma, in the flow x -> far x."""
    n = DIRECTIONS @ np.linalg.inv(F)
    n /= np.linalg.norm(n, axis=1)[:, None]
    pairs = np.einsum("pi,pj->pij", n, n).reshape(-1, 9)
    A = (WEIGHTS @ pairs).reshape(3, 3)
    fourth = ((pairs * WEIGHTS[:, None]).T @ pairs).reshape(3, 3, 3, 3)
    T = np.einsum("ik,lj->ijkl", UNIT, A) - fourth.transpose(0, 2, 1, 3)
    T = (T + T.transpose(0, 1, 3, 2)) / 2

    # L, row by row, then its trace
    matrix = np.zeros((10, 10))
    rhs = np.zeros(10)
    matrix[:9, :9] = np.eye(9) - 2 * T.reshape(9, 9)
    matrix[:9, 9] = -A.ravel()
    matrix[9, :9] = 2 * A.ravel()
    matrix[9, 9] = -2
    rhs[:9] = (far - np.einsum("ijkl,kl->ij", T, sigma)).ravel()
    rhs[9] = (A * sigma).sum()
    return np.linalg.solve(matrix, rhs)[:9].reshape(3, 3)


def shape(F):
    """Taylor's deformation in the plane of shear, inclination in degrees of the
    longest axis there, change of volume J."""
    squares, axes = np.linalg.eigh((F @ F.T)[:2, :2])
    short, long = np.sqrt(squares)
    angle = np.degrees(np.arctan2(axes[1, 1], axes[0, 1])) % 180
    return (long - short) / (long + short), angle, np.linalg.det(F)


class Motion:
    def __init__(self, law, Ca, formulation=general, far=SHEAR):
        self.law, self.Ca, self.formulation, self.far = law, Ca, formulation, far

    def velocity(self, F, before):
        """dF/dt where the step began with `before`."""
        step = F @ np.linalg.inv(before)
        P = self.formulation(self.law, F, before)
        sigma = P @ step.T / (np.linalg.det(step) * self.Ca)
        return velocity_gradient(F, sigma, self.far) @ F

    def march(self, step, end):
        """By backward differences of second order, the first step of first
        order, as fsbiFoam does: times, D, angles and J."""
        old = now = UNIT
        found = []
        for i in range(round(end / step)):
            if i == 0:
                rate, known = 1 / step, -now / step
            else:
                rate, known = 1.5 / step, (0.5 * old - 2 * now) / step
            old, now = now, self._solve(rate, known, 2 * now - old, now)
            found.append(((i + 1) * step, *shape(now)))
        return np.array(found).T

    def limit(self, end, n=400):
        """The same in the limit of short steps, by Runge and Kutta's method."""
        F, h = UNIT, end / n
        found = []
        for i in range(n):
            k1 = self.velocity(F, F)
            G = F + h / 2 * k1
            k2 = self.velocity(G, G)
            G = F + h / 2 * k2
            k3 = self.velocity(G, G)
            G = F + h * k3
            F = F + h / 6 * (k1 + 2 * k2 + 2 * k3 + self.velocity(G, G))
            found.append(((i + 1) * h, *shape(F)))
        return np.array(found).T

    def _solve(self, rate, known, F, before):
        """rate F + known = velocity(F)"""
        def defect(entries):
            F = entries.reshape(3, 3)
            return (rate * F + known - self.velocity(F, before)).ravel()
        found, _, status, why = fsolve(defect, F.ravel(), xtol=1e-13, full_output=True)
        if status != 1:
            raise RuntimeError(f"the step has no solution: {why}")
        return found.reshape(3, 3)
