# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where an elastic sphere rests on a plane, pressed there by a uniform force per volume,
held off by the barrier of `contact`: linear elasticity, axisymmetric, finite elements
with biquadratic displacements on a polar grid that is finer towards the plane."""

from collections import namedtuple

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import spsolve

Sphere = namedtuple("Sphere", "radius E nu")
Barrier = namedtuple("Barrier", "gap range pressure")

GAUSS = np.polynomial.legendre.leggauss(3)


def shapes(x):
    """Quadratic in one direction, at -1, 0, 1: values and slopes"""
    return (np.array([x * (x - 1) / 2, 1 - x**2, x * (x + 1) / 2]),
            np.array([x - 0.5, -2 * x, x + 0.5]))


class Solid:
    """Stiffness, and the integral of 2 pi r over elements: nodes (r, z) about the
    centre, the pole that faces the plane at z = -radius"""

    def __init__(self, sphere, layers, sectors):
        self.sphere = sphere
        rho = np.linspace(0, 1, 2 * layers + 1)
        rho = 1 - (1 - rho)**2                      # layers are thin at the surface
        part = np.linspace(0, 1, 2 * sectors + 1)
        theta = np.pi * (0.06 * part + 0.94 * part**3)
        # nodes between others where isoparametric elements want them
        for x in (rho, theta):
            x[1::2] = (x[:-1:2] + x[2::2]) / 2
        i, j = np.meshgrid(np.arange(rho.size), np.arange(theta.size), indexing="ij")
        self.number = np.where(i == 0, 0, 1 + (i - 1) * theta.size + j)
        self.r = np.zeros(self.number.max() + 1)
        self.z = np.zeros_like(self.r)
        self.r[self.number] = sphere.radius * rho[i] * np.sin(theta[j])
        self.z[self.number] = -sphere.radius * rho[i] * np.cos(theta[j])
        self.r[np.abs(self.r) < 1e-12 * sphere.radius] = 0
        self.assemble()

    def elements(self):
        n = self.number
        for i in range(0, n.shape[0] - 2, 2):
            for j in range(0, n.shape[1] - 2, 2):
                yield n[i:i + 3, j:j + 3].ravel()

    def assemble(self):
        E, nu = self.sphere.E, self.sphere.nu
        lam, mu = E * nu / (1 + nu) / (1 - 2 * nu), E / 2 / (1 + nu)
        C = lam * np.pad(np.ones((3, 3)), (0, 1)) + mu * np.diag([2, 2, 2, 1])
        n = self.r.size
        rows, columns, values = [], [], []
        self.volume = np.zeros(n)
        for e in self.elements():
            K = np.zeros((18, 18))
            for a, wa in zip(*GAUSS):
                for b, wb in zip(*GAUSS):
                    (A, dA), (B, dB) = shapes(a), shapes(b)
                    N = np.outer(A, B).ravel()
                    slopes = np.array([np.outer(dA, B).ravel(), np.outer(A, dB).ravel()])
                    J = slopes @ np.array([self.r[e], self.z[e]]).T
                    r = N @ self.r[e]
                    Nr, Nz = np.linalg.solve(J, slopes)
                    w = 2 * np.pi * r * abs(np.linalg.det(J)) * wa * wb
                    D = np.zeros((4, 18))
                    D[0, ::2], D[1, 1::2], D[2, ::2] = Nr, Nz, N / r
                    D[3, ::2], D[3, 1::2] = Nz, Nr
                    K += w * D.T @ C @ D
                    np.add.at(self.volume, e, w * N)
            at = np.array([2 * e, 2 * e + 1]).T.ravel()
            rows.append(np.repeat(at, 18))
            columns.append(np.tile(at, 18))
            values.append(K.ravel())
        self.K = coo_matrix((np.concatenate(values),
                             (np.concatenate(rows), np.concatenate(columns))),
                            shape=(2 * n, 2 * n)).tocsr()

    def surface(self, points=6):
        """Quadrature of the surface: weights of nodes, areas, heights"""
        line = self.number[-1]
        rows, weights, areas = [], [], []
        for j in range(0, line.size - 2, 2):
            e = line[j:j + 3]
            for a, wa in zip(*np.polynomial.legendre.leggauss(points)):
                N, dN = shapes(a)
                ds = np.hypot(dN @ self.r[e], dN @ self.z[e])
                rows.append(e)
                weights.append(N)
                areas.append(2 * np.pi * (N @ self.r[e]) * ds * wa)
        S = coo_matrix((np.concatenate(weights),
                        (np.repeat(np.arange(len(rows)), 3), np.concatenate(rows))),
                       shape=(len(rows), self.r.size)).tocsr()
        return S, np.array(areas)


def law(barrier, d):
    """Energy, force and stiffness by area at distances d"""
    s = (d - barrier.gap) / barrier.range
    k = barrier.pressure / 5
    on = s < 1
    x = np.where(on, s, 1)
    return (k * barrier.range * (1 - x)**3 / x**2,
            k * (1 - 3 / x**2 + 2 / x**3),
            6 * k * (1 - x) / x**4 / barrier.range)


def rest(sphere, barrier, load, layers=16, sectors=60):
    """Mean height of the sphere over the plane, its nearest distance, the force"""
    solid = Solid(sphere, layers, sectors)
    S, areas = solid.surface()
    n = solid.r.size
    free = np.ones(2 * n, bool)
    free[2 * np.flatnonzero(solid.r == 0)] = False
    weight = np.zeros(2 * n)
    weight[1::2] = -load * solid.volume / solid.volume.sum()
    up = np.zeros(2 * n)
    up[1::2] = sphere.radius + barrier.gap + 0.9 * barrier.range   # of a rigid one
    P = coo_matrix((np.ones(n), (np.arange(n), 2 * np.arange(n) + 1)), shape=(n, 2 * n)).tocsr()
    Z = S @ P
    height = S @ solid.z

    def energy(u):
        d = height + Z @ u
        if (d <= barrier.gap).any():
            return np.inf
        return 0.5 * u @ (solid.K @ u) + areas @ law(barrier, d)[0] - weight @ u

    u = up
    for _ in range(200):
        _, p, k = law(barrier, height + Z @ u)
        gradient = solid.K @ u - Z.T @ (areas * p) - weight
        H = solid.K + Z.T @ diags(areas * k) @ Z
        du = np.zeros(2 * n)
        du[free] = spsolve(H[free][:, free].tocsc(), -gradient[free])
        part = 1.0
        while energy(u + part * du) > energy(u) and part > 1e-12:
            part /= 2
        u = u + part * du
        if np.abs(du).max() < 1e-12 * sphere.radius:
            break
    d = height + Z @ u
    mean = solid.volume @ (P @ u) / solid.volume.sum()
    return mean, d.min(), areas @ law(barrier, d)[1]


if __name__ == "__main__":
    cell = Sphere(4, 0.01, 0.45)
    for n in ((8, 30), (16, 60), (24, 90)):
        print(n, rest(cell, Barrier(0.1, 0.1, 0.03), 0.0085, *n))
