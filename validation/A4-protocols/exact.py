# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""That no receptor of the block (scene.py) has bound after a time, in closed form.

    none = (1 - phi q(GAP))^N (1 - phi <q>)^M,      q(g) = 1 - exp(-n K(g) t)

phi: part that is free, n: density of ligands; N receptors at the bottom, M on the sides,
where <q> is the mean of q over the height. Of a bond that breaks no sooner when stretched
(sts = s) a receptor at g over a plane has, with the thermal length l and m = roughness +
lambda,

    K = 2 pi k0on int_g exp(-(r - m)^2/2l^2) r dr
      = 2 pi k0on (l^2 exp(-(g - m)^2/2l^2) + m l sqrt(pi/2) erfc((g - m)/(l sqrt 2)))"""

import math

import numpy as np
from scipy import integrate, optimize

import scene

BOLTZMANN = 1.380649e-23
# of one dose, after its half-life in a volume of 10
UNIT, DISSOCIATION = 0.5 / 10, 1.0


def rate(g):
    """Of one receptor, 1/us."""
    thermal = math.sqrt(BOLTZMANN * scene.TEMPERATURE * 1e15 / scene.STIFFNESS)
    m = scene.STALKS + scene.REST
    x = (g - m) / thermal
    return scene.LIGANDS * 2 * math.pi * scene.RATE * (
        thermal**2 * math.exp(-0.5 * x * x)
        + m * thermal * math.sqrt(math.pi / 2) * math.erfc(x / math.sqrt(2)))


def none(time, density, free=1.0):
    bottom, sides = scene.SIDE**2, 4 * scene.SIDE * scene.HEIGHT
    heights = np.linspace(0, 0.3, 3001)         # the rate is nothing further up
    over = integrate.simpson([-math.expm1(-rate(scene.GAP + z) * time) for z in heights],
                             x=heights) / scene.HEIGHT
    q = -math.expm1(-rate(scene.GAP) * time)
    return (1 - free * q) ** (density * bottom) * (1 - free * over) ** (density * sides)


def mean_time(density):
    """Of the first bond, or the end of the run."""
    times = np.linspace(0, scene.END, 401)
    return integrate.simpson([none(t, density) for t in times], x=times)


def free(dose):
    return DISSOCIATION / (DISSOCIATION + dose * UNIT)


def bond(density, dose):
    return 1 - none(scene.AT, density, free(dose))


def smallest(density, wanted):
    return optimize.brentq(lambda dose: bond(density, dose) - wanted, 0, 1e4)
