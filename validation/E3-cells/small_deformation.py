# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small deformation of a sphere with a membrane on it in a slow shear flow.

A sphere of radius 1 in a flow of rate E, slow enough for it to keep nearly its shape, turns
with the flow; a fluid of viscosity mu pulls at it by 5 mu E.n, as at a rigid one. What it
answers by is the displacement

    u = P E.n + Q (n.E.n) n

of its surface, and by the energies of the membrane and of the inside. That of the membrane
is integrated here over the deformed surface itself, by Gauss' rule, for E = diag(1, -1/2,
-1/2); isotropy makes the same of any other E. The inside is an elastic solid, whose
displacement is one linear and one cubic solution of Navier's equation, or a liquid, which
resists no slow change of shape, of a volume that stays. Taylor's parameter is (P + Q) times
half the rate of shear, first order in it.

With a membrane of rubber of modulus G around a liquid this is 25/12 mu rate/G, as
D. Barthes-Biesel and J. M. Rallison found (J. Fluid Mech. 113 (1981) 251), and with no
membrane 5/4 mu rate/G, as of an elastic sphere.

The shape of a capsule follows its flow in the time that liquids take, while it turns at half
the rate of shear: with P and Q as complex amplitudes exp(-i rate t) of what turns, their rates
P', Q' are those of a velocity of the surface, for which flows outside (a stresslet and a
potential flow) and inside (as the solid, with velocities) are known, and tractions of both and
of the membrane balance. Of a tension alone this is the deformation of a drop (G. I. Taylor
1932; R. G. Cox, J. Fluid Mech. 37 (1969) 601): it is first order in the deformation, at any
ratio of viscosities and any rate of following."""

import numpy as np

COS, WEIGHT = np.polynomial.legendre.leggauss(200)
E = np.array([1, -0.5])         # along the axis and across


def energy_per_area(law, shear, area, tension):
    """Of the trace T and determinant d of C, as of membraneLaw; by what its papers say, not
    by its derivatives."""
    def energy(T, d):
        J = np.sqrt(d)
        work = tension * J
        if law == "Skalak":
            C = (area / shear - 1) / 2
            work = work + shear / 4 * ((T - 2)**2 + 2 * (T - 2) - 2 * (d - 1) + C * (d - 1)**2)
        elif law == "neoHookeanMembrane":
            work = work + shear / 2 * (T + 1 / d - 3)
        elif law == "EvansSkalak":
            work = work + shear * (T / J / 2 - 1) + area / 2 * (J - 1)**2
        return work
    return energy


def surface_energy(W, P, Q, pressure, bending=0):
    """Of the displaced sphere, less pressure times its volume; bending: the modulus, of
    Helfrich's energy with the curvature of the sphere as the spontaneous one."""
    def place(angle):
        c, s = np.cos(angle), np.sin(angle)
        radial = Q * (E[0] * c**2 + E[1] * s**2)
        return c * (1 + P * E[0] + radial), s * (1 + P * E[1] + radial)
    angle, step = np.arccos(COS), 1e-5
    _, r = place(angle)
    above, below = place(angle + step), place(angle - step)
    dz, dr = ((a - b) / (2 * step) for a, b in zip(above, below))
    meridian, ring = np.hypot(dz, dr), r / np.sin(angle)
    area = np.sum(WEIGHT * W(meridian**2 + ring**2, (meridian * ring)**2)) * 2 * np.pi
    volume = np.sum(WEIGHT * np.pi * r**2 * -dz / np.sin(angle))
    bent = np.sum(WEIGHT * (curvature(place, angle) - 2)**2 * meridian * ring) * 2 * np.pi
    return area - pressure * volume + bending / 2 * bent


def curvature(place, angle, step=1e-3):
    """Sum of the principal curvatures of a surface of revolution."""
    before, here, after = (np.array(place(angle + k * step)) for k in (-1, 0, 1))
    first, second = (after - before) / (2 * step), (after - 2 * here + before) / step**2
    length = np.hypot(*first)
    along = (first[1] * second[0] - first[0] * second[1]) / length**3
    return -along - first[0] / length / here[1]


def surface_stiffness(W, pressure, bending=0):
    """Second derivatives of the energy by P and Q."""
    h = 1e-2

    def at(p, q):
        return surface_energy(W, p * h, q * h, pressure, bending)
    mixed = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / 4
    return np.array([[at(1, 0) - 2 * at(0, 0) + at(-1, 0), mixed],
                     [mixed, at(0, 1) - 2 * at(0, 0) + at(0, -1)]]) / h**2


def works():
    """Integrals over the sphere of products of the vectors E.n and (n.E.n) n."""
    q = E[0] * COS**2 + E[1] * (1 - COS**2)
    square = E[0]**2 * COS**2 + E[1]**2 * (1 - COS**2)
    return 2 * np.pi * np.array([[np.sum(WEIGHT * square), np.sum(WEIGHT * q * q)],
                                 [np.sum(WEIGHT * q * q), np.sum(WEIGHT * q * q)]])


def on_sphere(kind, G, nu, radius):
    """Of a solution of Navier's equation, displacement and traction on a sphere, each of E.n
    and of (n.E.n) n. Of the four the first two are finite in the middle."""
    lam = 2 * G * nu / (1 - 2 * nu)
    # f r^m E.x + g r^n x (x.E.x) with (lam + G) grad div u + G laplace u = 0
    f, g, m, n = [
        (1, 0, 0, 0), (1, -(4 * (lam + G) + 10 * G) / (10 * (lam + G) + 4 * G), 2, 0),
        (2, -5, -5, -7), (1, 1.5 * (lam + G) / G, -3, -5)][kind]
    f, g = f * radius**m, g * radius**(n + 2)
    divergence = m * f + (n + 5) * g
    return np.array([radius * f, radius * g, G * ((m + 2) * f + 2 * g),
                     lam * divergence + G * (m * f + (2 * n + 4) * g)])


def solid_stiffness(G, nu, core=None):
    """Tractions (of E.n, of (n.E.n) n) for displacements (P, Q) of an elastic sphere; core:
    radius, shear modulus and Poisson's ratio of another one bonded to it inside."""
    if core is None:
        values = np.column_stack([on_sphere(kind, G, nu, 1) for kind in (0, 1)])
        return values[2:] @ np.linalg.inv(values[:2])
    radius, other, its_nu = core
    inside = [on_sphere(kind, other, its_nu, radius) for kind in (0, 1)]
    around = [-on_sphere(kind, G, nu, radius) for kind in range(4)]
    # what of the four around it goes with each of the two inside
    joined = np.linalg.solve(np.column_stack(around), -np.column_stack(inside))
    values = np.column_stack([on_sphere(kind, G, nu, 1) for kind in range(4)]) @ joined
    return values[2:] @ np.linalg.inv(values[:2])


def deformation(law=None, shear=0, area=0, tension=0, solid=None, core=None):
    """Taylor's parameter over viscosity times rate of shear; moduli over the radius; solid:
    shear modulus and Poisson's ratio of the inside, None: a liquid; core: see there."""
    W = energy_per_area(law, shear, area, tension)
    # a liquid: the limit of a soft, incompressible solid
    G, nu = solid or (1e-8 * max(shear, tension), 0.4999999)
    stiffness = surface_stiffness(W, 2 * tension) + works() @ solid_stiffness(G, nu, core)
    P, Q = np.linalg.solve(stiffness, works() @ np.array([5, 0]))
    return (P + Q) / 2


def outside():
    """Tractions (of E.n, of (n.E.n) n) for velocities of the surface of a sphere, of the
    fluid around it, at rest far away, of viscosity 1."""
    # x (x.E.x)/r^5 with the pressure 2 x.E.x/r^5, and the gradient of x.E.x/r^5
    shapes = np.array([[0, 2], [1, -5]])
    tractions = np.array([[2, -16], [-8, 40]])
    return tractions @ np.linalg.inv(shapes)


def capsule(ratio, law=None, shear=0, area=0, tension=0, bending=0):
    """Taylor's parameter and the inclination (degrees) of a capsule in shear; moduli over
    viscosity, radius and rate of shear; ratio: of the viscosities inside and outside; bending:
    modulus over viscosity, rate of shear and the third power of the radius."""
    W = energy_per_area(law, shear, area, tension)
    membrane = np.linalg.inv(works()) @ surface_stiffness(W, 2 * tension, bending)
    resistance = outside() - solid_stiffness(ratio, 0.4999999)
    # resistance (P', Q') = membrane (P, Q) + what the flow without a capsule pulls
    pull = outside() @ np.array([1, 0]) - np.array([2, 0])
    rates = np.linalg.solve(resistance, np.column_stack([membrane, pull]))
    P, Q = np.linalg.solve(1j * np.eye(2) - rates[:, :2], rates[:, 2])
    return abs(P + Q) / 2, 45 + np.degrees(np.angle(P + Q)) / 2


def laplace_stretch(tension, radius, young, nu):
    """Of a neo-Hookean sphere with a surface tension, in a fluid without pressure: its stress
    mu (s - 1/s) + 3 lambda ln(s)/s bears 2 tension s/radius, by area of the sphere free of
    stress."""
    from scipy.optimize import brentq
    mu = young / 2 / (1 + nu)
    lam = 2 * mu * nu / (1 - 2 * nu)
    return brentq(lambda s: mu * (s - 1 / s) + 3 * lam * np.log(s) / s
                  + 2 * tension * s / radius, 0.2, 1)
