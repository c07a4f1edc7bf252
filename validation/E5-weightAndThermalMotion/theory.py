# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact Stokes flow of free bodies and beside a wall, and Brownian motion there:
independent of fsbiFoam. Units pg, um, us; viscosity 1."""

import numpy as np
from scipy.integrate import quad

KT = 1.380649e-8 * 310


def ellipsoid_diffusion(axes):
    """Of a free ellipsoid, along its axes and about them (Lamb; Perrin 1936):
    three numbers each."""
    a = np.array(axes, float)

    def delta(s):
        return np.sqrt(np.prod(a**2 + s))

    chi = quad(lambda s: 1 / delta(s), 0, np.inf)[0]
    alpha = np.array([quad(lambda s: 1 / ((q**2 + s) * delta(s)), 0, np.inf)[0] for q in a])
    drag = 16 * np.pi / (chi + alpha * a**2)
    couple = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        couple.append(16 * np.pi / 3 * (a[j]**2 + a[k]**2)
                      / (a[j]**2 * alpha[j] + a[k]**2 * alpha[k]))
    return KT / drag, KT / np.array(couple)


def pair_mobility(distance):
    """Along the line of centres of two spheres of radius 1: of one by its own
    force and by the other's, times 6 pi (Jeffrey & Onishi 1984, terms to the
    power -7)."""
    r = distance
    return 1 - 15/4 * r**-4 + 11/2 * r**-6, 3/2/r - r**-3 + 75/4 * r**-7


def wall_mobility(gap):
    """Of a sphere of radius 1 along the normal of a wall (Brenner 1961)."""
    alpha = np.arccosh(1 + gap)
    terms = int(20 / alpha) + 10
    n = np.arange(1, terms)
    x = (n + 0.5) * alpha
    # over exp(2 x), which would overflow
    small = np.exp(-2 * x)
    up = (1 - small**2) + (2*n + 1) * np.sinh(2*alpha) * small
    down = (1 - small)**2 - (2*n + 1)**2 * np.sinh(alpha)**2 * small
    factor = n * (n + 1) / ((2*n - 1) * (2*n + 3))
    series = np.sum(factor * (up / down - 1))
    return 1 / (6 * np.pi * 4/3 * np.sinh(alpha) * series)


class BesideWall:
    """A heavy sphere that a wall repels: F(gap), its potential, Boltzmann's
    distribution."""

    def __init__(self, weight, strength, reach):
        self.weight, self.strength, self.reach = weight, strength, reach
        gaps = np.linspace(0.02, 6, 6000)
        work = np.concatenate([[0], np.cumsum(0.5*(self.force(gaps)[1:] + self.force(gaps)[:-1])
                                              * np.diff(gaps))])
        density = np.exp((work - work.max()) / KT)
        self.gaps, self.density = gaps, density / np.trapz(density, gaps)
        nodes = np.geomspace(0.005, 6, 400)
        self._log_gap = np.log(nodes)
        self._mobility = np.array([wall_mobility(g) for g in nodes])

    def force(self, gap):
        """The repulsion's pressure over the zones of the sphere, 2 pi dd."""
        d = np.maximum(gap, 0.01 * self.reach)
        push = 2*np.pi*self.strength * ((1/d**2 - 1/self.reach**2) / 2
                                        - (self.reach - d) / self.reach**3)
        return np.where(gap < self.reach, push, 0) - self.weight

    def mobility(self, gap):
        return np.interp(np.log(gap), self._log_gap, self._mobility)

    def slope(self, gap):
        return (self.mobility(1.001*gap) - self.mobility(0.999*gap)) / (0.002*gap)

    def mean(self):
        return np.trapz(self.gaps * self.density, self.gaps)

    def deviation(self, start, dt, steps, runs=300, parts=8):
        """Standard deviation of the mean gap over a run, from runs of the
        Langevin equation in shorter steps."""
        random = np.random.default_rng(5)
        gap = np.full(runs, float(start))
        sums = np.zeros(runs)
        h = dt / parts
        for _ in range(steps):
            for _ in range(parts):
                M = self.mobility(gap)
                gap = gap + h*(M*self.force(gap) + KT*self.slope(gap)) \
                    + np.sqrt(2*KT*M*h) * random.standard_normal(runs)
                gap = np.maximum(gap, 0.02)
            sums += gap
        return np.std(sums / steps)
