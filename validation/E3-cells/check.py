# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells with a cortex against small_deformation.py, capsule_in_strain.py and
measurements; write results.csv."""

import os
import sys

import numpy as np
from capsule_in_strain import CapsuleInStrain
from small_deformation import COS, WEIGHT, capsule, curvature, deformation, laplace_stretch

from fsbi.case import Case, reference
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
RADIUS = 4
PULL = 5e-5                     # viscosity times rate of shear
EDGE = 0.3 if quick else 0.2    # over the radius
# bound: of the deformation by order 2, as of the elastic sphere of B2
MESH = 0.005 * (EDGE / 0.1)**2
# bound: walls at 5 radii stretch a cell by 3 %, those at 20 by the third power of that less
BOX = 0.03 / 4**3
# Law, its tension over the shear modulus and the capillary number of what a flow stretches
STRETCHED = {"Rubber": ("neoHookeanMembrane", 0.3, 0.16), "Skalak": ("Skalak", 0.2, 0.3)}
results = Results("E3")


def theory():
    """The expansion against what others have found."""
    # bound: differences of the energy with steps h of 0.01, by h^2, with factors of some tens
    results.add("rubber_small_deformation", deformation("neoHookeanMembrane", 1), 25 / 12, 1e-2)
    results.add("solid_small_deformation", deformation(solid=(1, 0.4999999)), 1.25, 1e-4)
    # bound: differences as above; a core of the same material is none
    results.add("core_of_the_same_small_deformation",
                deformation(solid=(1, 0.49), core=(0.6, 1, 0.49)),
                deformation(solid=(1, 0.49)), 1e-9)
    tension = 1000
    for ratio in (1, 5):
        taylor = (19 * ratio + 16) / (16 * ratio + 16) / tension
        # bound: the turning, (0.95 ratio Ca)^2/2 (Cox 1969), and differences as above
        results.add("drop_small_deformation", capsule(ratio, tension=tension)[0], taylor, 1e-3,
                    variant=f"ratio{ratio}")


def laplace():
    run = Case("runs/squeezed")
    volume = run.history["elasticBodies/cell/volume"]["now"][-1]
    radius = (3 * volume / (4 * np.pi))**(1 / 3)
    stretch = laplace_stretch(8e-4, RADIUS, 1.49e-3, 0.3)
    # bound: triangles of edges h around the volume of a sphere have an area too large by
    # 0.042 (h/a)^2 where they are equilateral; twice that for others. The inside is uniform
    results.add("laplace_contraction", 1 - radius / RADIUS, 1 - stretch, 0.084 * EDGE**2,
                seconds=run.seconds, cells=run.cells)
    skin = run.history["elasticBodies/cell/cortex"]
    # bound: as above, the area of the mesh over that of the sphere
    results.add("laplace_area", skin["area"][-1], 4 * np.pi * radius**2, 0.084 * EDGE**2)
    # bound: a tension has no other energy than with the area
    results.add("laplace_energy", skin["energy"][-1], 8e-4 * skin["area"][-1], 1e-12)


def in_shear(name, expected, inclination=None, more=0):
    run = Case(f"runs/{name}")
    _, D, angle = run.shape("cell")
    # bound: the mesh's, and what is left out of the expansion, D^2
    bound = MESH + expected**2 + more
    results.add("deformation", D[-1], expected, bound, variant=name,
                seconds=run.seconds, cells=run.cells)
    if inclination:
        # bound: an ellipse known to an error e of its deformation has its axis within e/2 rad;
        # what is left out is of the order of D, as of elastic spheres in B2's reference:
        # 45 degrees less 1.5 D rad at first, 0.15 D rad from there on
        results.add("angle_abs", angle[-1], inclination,
                    np.degrees(MESH / 2 + 0.15 * expected), variant=name)
    # bound: the last third of the run changes it by no more than that
    results.add("steady", D[-1], D[2 * len(D) // 3], bound, variant=name)
    iterations = float(np.mean(run.history["cost"]["iterations"][2:]))
    # bound: an elastic sphere of the same stiffness takes 45 in three corrections (B2), a
    # membrane that the preconditioner does not know three times as many
    results.add("iterations_abs", iterations, 0, 150, variant=name)


def stretching_theory():
    """What capsule_in_strain.py finds, against small deformations and by more coefficients."""
    for law, tension in (("neoHookeanMembrane", 0), ("Skalak", 0.2)):
        strengths = np.array([1e-3, 2e-3])
        D = [c.taylor(c.steady(), of_ellipsoid=False) for c in
             (CapsuleInStrain(Ca, law, tension, 8) for Ca in strengths)]
        first, second = D / strengths
        # stretching along an axis at a rate is 3/2 of what shear does at that rate
        small = 25 / 8 if tension == 0 else 1.5 * deformation(law, 1, 3, tension)
        # bound: the third order, 2 (6 Ca)^2, and differences of the energy as above
        results.add("stretched_small_deformation", 2 * first - second, small, 3e-3, variant=law)
    for name, (law, tension, Ca) in STRETCHED.items():
        coarse, fine = (c.taylor(c.steady()) for c in
                        (CapsuleInStrain(Ca, law, tension, n) for n in (8, 16)))
        # bound: what is asked of it
        results.add("stretched_resolution_abs", coarse, fine, 1e-3, variant=name)


def stretched(name, edge, loads="", variant=None):
    """At the end, and on the way at half a time of the flow; the error at the end."""
    variant = variant or f"{name}{edge}{loads}"
    run = Case(f"runs/stretched{variant}")
    theory = CapsuleInStrain(STRETCHED[name][2], *STRETCHED[name][:2])
    time, D, _ = run.shape("cell")
    time = time * PULL
    half = np.argmin(np.abs(time - 0.5))
    way, end = (theory.taylor(y) for y in theory.after(time[[half, -1]]))
    steady = theory.steady()
    if variant == "Thick":              # slower, to the same shape
        way, end = None, theory.taylor(steady)
    label = dict(variant=variant)
    # bound: the mesh's, with edges over radii of curvature as they are when stretched
    bound = 0.005 * (edge / 0.1)**2 * theory.sharpness(steady) + BOX
    results.add("stretched", D[-1], end, bound, seconds=run.seconds, cells=run.cells, **label)
    if way:
        # bound: a first step by Euler's rule and others of order 2, of what decays by
        # exp(-s t), lose (s dt)^2 (1/2 + s t/3) of it
        still = 1 - way / end
        decay = -np.log(still) / time[half]
        late = still * (decay * (time[1] - time[0]))**2 * (1 / 2 + decay * time[half] / 3)
        results.add("stretched_halfway", D[half], way, bound + late, **label)
    # bound: the mesh's, of what the flow does
    axes = run.history["elasticBodies/cell/semiAxes"]
    results.add("stretched_roundness", axes["middle"][-1], axes["shortest"][-1], bound * end,
                **label)
    volume = run.history["elasticBodies/cell/volume"]["now"][-1]
    # bound: solved to 1e-6 of what the flow does, in each of 60 to 80 steps
    results.add("stretched_volume", volume, 4 / 3 * np.pi * RADIUS**3, 1e-4, **label)
    return D[-1] / end - 1


def stretching():
    edges = (0.4, 0.3) if quick else (0.4, 0.3, 0.2)
    for name in STRETCHED:
        errors = np.abs([stretched(name, edge) for edge in edges])
        order = np.log(errors[0] / errors[-1]) / np.log(edges[0] / edges[-1])
        # bound: order 2; half of one for the few meshes
        results.at_least("stretched_order", order, 1.5, variant=name)
        for edge in edges[1:] if quick else edges:
            stretched(name, edge, "Corners")
    stretched("Rubber", 0.4, variant="Thick")


def tweezers():
    """Diameters of a red cell by the force that pulls at it, within the scatter of measured
    ones."""
    run = Case("runs/tweezers")
    force = 1000 * run.history["effects/opticalTweezers/right/force"]["x"]      # pN
    lengths = run.history["elasticBodies/redCell/extents"]
    for row in reference(os.path.join(os.environ["FSBI_DIR"],
                                      "tutorials/redCellStretched/measured.csv")):
        if row["force"] > force[-1]:
            break
        for name, direction in (("axial", "x"), ("transverse", "y")):
            if quick and name == "transverse":
                continue                # not met, see README.md
            # bound: the error bars of the measurement
            middle = (row[name + "High"] + row[name + "Low"]) / 2
            results.add(f"red_cell_{name}", np.interp(row["force"], force, lengths[direction]),
                        middle, row[name + "High"] / middle - 1,
                        variant=f"{row['force']:.0f}pN", cells=run.cells)
    area = run.history["elasticBodies/redCell/cortex"]["area"]
    # bound: the force over a circumference of pi 4 um, by the area modulus
    results.add("red_cell_area", area[-1], area[0], force[-1] / 1000 / (4 * np.pi) / 0.1)
    volume = run.history["elasticBodies/redCell/volume"]["now"]
    # bound: as of capsules
    results.add("red_cell_volume", volume[-1], volume[0], 1e-4)


def tumbling():
    """Half a turn of a red cell in slow shear, against the rigid body of its shape."""
    rigid, soft = Case("runs/tumblingRigid"), Case("runs/tumbling")
    w, x, y, z = rigid.history["bodies/cell/orientation"].array[:, 1:].T
    path = "elasticBodies/cell/"
    halves = {}
    for name, run, axis in (
            ("rigid", rigid, (2 * (x * z + w * y), 2 * (y * z - w * x))),
            ("soft", soft, soft.history[path + "shortestAxis"].array[:, 1:3].T)):
        # an axis has no sense
        angle = np.unwrap(np.arctan2(axis[1], axis[0]) % np.pi, period=np.pi)
        begin, end = np.interp([0, np.pi], -angle, run.time())
        halves[name] = end - begin
    # bound: a membrane in shear is strained by 25/12 Ca, as of spheres; the period goes with
    # the ratio of the axes, of which both change
    capillary = 2e-5 * 3.91 / 4e-3
    results.add("tumbling_half_turn", halves["soft"], halves["rigid"], 2 * 25 / 12 * capillary,
                seconds=soft.seconds, cells=soft.cells)
    volume = soft.history[path + "volume"]["now"]
    # bound: as of capsules
    results.add("tumbling_volume", volume[-1], volume[0], 1e-4)


def red_cell():
    """Helfrich's energy of a modulus of 1 of the biconcave disc as it is described."""
    angle = np.arccos(COS)

    def meridian(angle):
        s, c = np.sin(angle), np.cos(angle)
        thickness = 0.207161 + 2.002558 * s**2 - 1.122762 * s**4
        return 3.91 / 2 * thickness * c, 3.91 * s
    before, after = (np.array(meridian(angle + h)) for h in (-1e-4, 1e-4))
    length = np.hypot(*(after - before)) / 2e-4
    area = 2 * np.pi * WEIGHT * meridian(angle)[1] * length / np.sin(angle)
    energy = np.sum(area * curvature(meridian, angle)**2) / 2
    errors = []
    sizes = (0.6, 0.4)
    for size in sizes:
        run = Case(f"runs/red{size}")
        found = run.history["elasticBodies/cell/cortex"]["energy"][-1]
        errors.append(abs(found / energy - 1))
        # bound: a quadratic through points at a distance h of a curve of radius r is wrong by
        # (h/r)^2/4 of its curvature, as of a circle; twice that of its square. At the rim r is
        # 1.1 um
        results.add("bending_energy", found, energy, (size / 1.1)**2 / 2, variant=f"size{size}",
                    seconds=run.seconds, cells=run.cells)
    order = np.log(errors[0] / errors[1]) / np.log(sizes[0] / sizes[1])
    # bound: order 2; half of one for the few meshes and their rims' points
    results.at_least("bending_order", order, 1.5)


def shape(name):
    axes = Case(f"runs/{name}").history["elasticBodies/cell/semiAxes"]
    return np.array([axes[key][-1] for key in ("longest", "middle", "shortest")])


def main():
    theory()
    stretching_theory()
    laplace()
    in_shear("cortex", PULL * deformation("Skalak", 1e-3, 3e-3, solid=(2e-3, 0.49)))
    for ratio in (1, 5):
        in_shear(f"capsule{ratio}", *capsule(ratio, "Skalak", 50, 150, 2.5))
    # bound: the mesh's of another surface, too
    in_shear("nucleus", PULL * deformation(solid=(2e-3, 0.49), core=(0.6, 2e-2, 0.49)), more=MESH)
    # the modulus over viscosity, rate and radius^3: 5. bound: curvatures of a displacement of
    # order 2, by (2.4 h/a)^2/12, and bending is half of the stiffness
    in_shear("bent", *capsule(1, "Skalak", 50, 150, 2.5, 5), more=0.24 * EDGE**2)
    in_shear("closed", *capsule(1, "Skalak", 50, 150, 2.5))
    stretching()
    tweezers()
    if not quick:
        tumbling()
    red_cell()
    whole = shape("whole")
    # bound: a restart knows all
    results.add("continued_difference_abs", np.abs(shape("continued") - whole).max(), 0, 0)
    # bound: other processes, other coordinates and sums, solved to 1e-6
    for name in ("parallel", "spread"):
        results.add(f"{name}_difference_abs", np.abs(shape(name) / whole - 1).max(), 0, 1e-5)
    # bound: as above
    whole = shape("wholeNucleus")
    results.add("continued_difference_abs", np.abs(shape("continuedNucleus") - whole).max(), 0, 0,
                variant="nucleus")
    results.add("parallel_difference_abs", np.abs(shape("parallelNucleus") / whole - 1).max(), 0,
                1e-5, variant="nucleus")
    results.write()


if __name__ == "__main__":
    main()
