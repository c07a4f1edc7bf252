# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bodies, as solids of gmsh (Open Cascade) in a cube of half width HALF, each
with the distance from its surface as an expression of gmsh: edges grow with that.

    python3 bodies.py box 0.2 box.stl           # triangles of that size
"""

import sys

import gmsh
import numpy as np

HALF = 4
EDGE = 0.8                              # half of the cube's, of the cylinder's length
THIN = 0.1                              # half of the disc's thickness
APART = 1.5                             # centres of the two spheres, from the middle


def sphere(x=0.0):
    return [gmsh.model.occ.addSphere(x, 0, 0, 1)]


def two_spheres():
    return sphere(-APART) + sphere(APART)


def ellipsoid():
    """A surface of revolution: gmsh is several times slower on a sphere that is
    stretched."""
    occ = gmsh.model.occ
    arcs = [occ.addEllipse(0, 0, 0, 3, 1, angle1=a, angle2=a + np.pi / 2) for a in (0, np.pi / 2)]
    made = occ.revolve([(1, arc) for arc in arcs], 0, 0, 0, 1, 0, 0, 2 * np.pi)
    faces = [tag for dimension, tag in made if dimension == 2]
    return [occ.addVolume([occ.addSurfaceLoop(faces, sewing=True)])]


def box():
    return [gmsh.model.occ.addBox(*3 * [-EDGE], *3 * [2 * EDGE])]


def cylinder():
    return [gmsh.model.occ.addCylinder(0, 0, -EDGE, 0, 0, 2 * EDGE, 1)]


def disc():
    return [gmsh.model.occ.addCylinder(0, 0, -THIN, 0, 0, 2 * THIN, 1)]


def positive(a):
    return f"(({a}) + sqrt(({a}) * ({a}))) / 2"


def from_centre(x="x"):
    return f"sqrt(({x})*({x}) + y*y + z*z)"


def outside(*lengths):
    """Distance from what is inside in all of these lengths."""
    return "sqrt(" + " + ".join(f"({positive(a)})^2" for a in lengths) + ")"


LEFT, RIGHT = from_centre(f"x + {APART}"), from_centre(f"x - {APART}")
ROUND = "sqrt(x*x/9 + y*y + z*z)"
BODIES = {
    "sphere": (sphere, f"{from_centre()} - 1"),
    "ellipsoid": (ellipsoid, f"({ROUND}) * ({ROUND} - 1) / sqrt(x*x/81 + y*y + z*z)"),
    "twoSpheres": (two_spheres,
                   f"({LEFT} + {RIGHT} - sqrt(({LEFT} - {RIGHT})^2)) / 2 - 1"),
    "box": (box, outside(*(f"sqrt({x}*{x}) - {EDGE}" for x in "xyz"))),
    "cylinder": (cylinder, outside("sqrt(x*x + y*y) - 1", f"sqrt(z*z) - {EDGE}")),
    "disc": (disc, outside("sqrt(x*x + y*y) - 1", f"sqrt(z*z) - {THIN}")),
}


def in_box(body):
    """The fluid's volume is the current model."""
    whole = gmsh.model.occ.addBox(*3 * [-HALF], *3 * [2 * HALF])
    gmsh.model.occ.cut([(3, whole)], [(3, s) for s in BODIES[body][0]()])
    gmsh.model.occ.synchronize()


def set_sizes(body, size, growth):
    """Edges of that size on the body and growing with the distance; a quarter of it
    at the cube's corners, which no mode of an edge fits."""
    sizes = f"{size} + {growth} * ({BODIES[body][1]})"
    if body == "box":
        corner = "sqrt(" + " + ".join(f"(sqrt({x}*{x}) - {EDGE})^2" for x in "xyz") + ")"
        sizes = f"Min({sizes}, {size / 4} + {corner} / 2)"
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", sizes)
    gmsh.model.mesh.field.setAsBackgroundMesh(field)


def stokes(points):
    """Exact flow past a unit sphere at rest, far velocity 1 along x."""
    r = np.linalg.norm(points, axis=1)
    velocity = -(points[:, 0] / r**2 * (3 / (4 * r) - 3 / (4 * r**3)))[:, None] * points
    velocity[:, 0] += 1 - 3 / (4 * r) - 1 / (4 * r**3)
    return velocity


def uniform(points):
    return np.tile((1.0, 0.0, 0.0), (len(points), 1))


def flow(body):
    """On the cube."""
    return stokes if body == "sphere" else uniform


def triangles(body, size, path):
    gmsh.initialize()
    for option in "General.Terminal", "Mesh.MeshSizeExtendFromBoundary", \
            "Mesh.MeshSizeFromPoints":
        gmsh.option.setNumber(option, 0)
    BODIES[body][0]()
    gmsh.model.occ.synchronize()
    set_sizes(body, size, 0)
    gmsh.model.mesh.generate(2)
    gmsh.write(path)
    gmsh.finalize()


if __name__ == "__main__":
    triangles(sys.argv[1], float(sys.argv[2]), sys.argv[3])
