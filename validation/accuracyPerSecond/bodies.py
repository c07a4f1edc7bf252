# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bodies, as solids of gmsh (Open Cascade) in a box, each with the distance from
its surface as an expression of gmsh: edges grow with that.

    python3 bodies.py box 0.2 box.stl           # triangles of that size
"""

import sys

import numpy as np

try:
    import gmsh
except ModuleNotFoundError:     # the exact flow of a sphere needs no meshes
    gmsh = None

HALF = 4                                # width of the box
PLATES = 1.5                            # half of their distance, around the capsule
EDGE = 0.8                              # half of the cube's, of the cylinder's length
THIN = 0.1                              # half of the disc's thickness
APART = 1.5                             # centres of the two spheres, from the middle
LONG = 1                                # half of the capsule's cylinder
WIRE, PITCH, TURNS = 0.3, 2, 1.5        # of the helix, wound on radius 1


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


def capsule():
    occ = gmsh.model.occ
    middle = [(3, occ.addCylinder(0, 0, -LONG, 0, 0, 2 * LONG, 1))]
    ends = [(3, occ.addSphere(0, 0, z, 1)) for z in (-LONG, LONG)]
    return [tag for _, tag in occ.fuse(middle, ends)[0]]


def winding(angles):
    """Centres of the wire, the end at angle 0 on the x axis."""
    return np.transpose(
        (np.cos(angles), np.sin(angles), PITCH * (angles / (2 * np.pi) - TURNS / 2)))


def to_wire(points):
    """On the helix's surface: out from the nearest centre."""
    rise = PITCH / (2 * np.pi)
    x, y, z = points.T
    turned = np.arctan2(y, x)
    around = (z / rise + np.pi * TURNS - turned) / (2 * np.pi)
    angles = turned + 2 * np.pi * np.round(around)
    for _ in range(5):
        angles = np.clip(angles, 0, 2 * np.pi * TURNS)
        along = np.transpose((-np.sin(angles), np.cos(angles), np.full_like(z, rise)))
        inward = np.transpose((-np.cos(angles), -np.sin(angles), np.zeros_like(z)))
        arm = points - winding(angles)
        angles += (arm * along).sum(1) / ((along**2).sum(1) - (arm * inward).sum(1))
    centres = winding(np.clip(angles, 0, 2 * np.pi * TURNS))
    arm = points - centres
    return centres + WIRE * arm / np.linalg.norm(arm, axis=1)[:, None]


def helix():
    """A wire with round ends, like fsbiFoam's shape."""
    occ = gmsh.model.occ
    points = winding(np.linspace(0, 2 * np.pi * TURNS, 16 * int(TURNS) + 17))
    wire = occ.addWire([occ.addSpline([occ.addPoint(*p) for p in points])])
    disc = occ.addDisk(*points[0], WIRE, WIRE)
    start = points[0]
    along = np.array((0, 1, PITCH / (2 * np.pi)))
    axis, angle = np.cross((0, 0, 1), along), np.arccos(along[2] / np.linalg.norm(along))
    occ.rotate([(2, disc)], *start, *axis, angle)
    pipe = occ.addPipe([(2, disc)], wire)
    occ.remove([(2, disc)])
    ends = [(3, occ.addSphere(*p, WIRE)) for p in (points[0], points[-1])]
    return [tag for _, tag in occ.fuse(pipe, ends)[0]]


def positive(a):
    return f"(({a}) + sqrt(({a}) * ({a}))) / 2"


def from_centre(x="x"):
    return f"sqrt(({x})*({x}) + y*y + z*z)"


def outside(*lengths):
    """Distance from what is inside in all of these lengths."""
    return "sqrt(" + " + ".join(f"({positive(a)})^2" for a in lengths) + ")"


def beside_winding():
    """Distance from the helix, nearly: from its next turn along the axis, foreshortened,
    from radius 1, and from its ends."""
    rise = PITCH / (2 * np.pi)
    angle = f"(z / {rise} + {np.pi * TURNS})"
    cosine = f"(x * Cos({angle}) + y * Sin({angle})) / (0.001 + sqrt(x*x + y*y))"
    axial = f"{2 * rise / np.hypot(1, rise)} * Asin(sqrt({positive(f'0.5 - 0.4999 * ({cosine})')}))"
    ends = positive(f"sqrt(z*z) - {PITCH * TURNS / 2}")
    return f"sqrt(({axial})^2 + (sqrt(x*x + y*y) - 1)^2 + ({ends})^2) - {WIRE}"


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
    "capsule": (capsule,
                f"sqrt(x*x + y*y + ({positive(f'sqrt(z*z) - {LONG}')})^2) - 1"),
    "helix": (helix, beside_winding()),
}


# gmsh's own way to the nearest point of such a surface takes longer than all the rest
CLOSEST = {"helix": to_wire}


def box_of(body):
    """Half widths of the fluid."""
    return np.array((HALF, PLATES if body == "capsule" else HALF, HALF), float)


def in_box(body):
    """The fluid's volume is the current model."""
    half = box_of(body)
    whole = gmsh.model.occ.addBox(*-half, *2 * half)
    gmsh.model.occ.cut([(3, whole)], [(3, s) for s in BODIES[body][0]()])
    gmsh.model.occ.synchronize()


def set_sizes(body, size, growth):
    """Edges of that size on the body and growing with the distance; a quarter of it
    at the cube's corners, which no mode of an edge fits."""
    field = gmsh.model.mesh.field
    sizes = f"{size} + {growth} * ({BODIES[body][1]})"
    if body == "box":
        corner = "sqrt(" + " + ".join(f"(sqrt({x}*{x}) - {EDGE})^2" for x in "xyz") + ")"
        sizes = f"Min({sizes}, {size / 4} + {corner} / 2)"
    background = field.add("MathEval")
    field.setString(background, "F", sizes)
    field.setAsBackgroundMesh(background)


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
    if gmsh is None:
        sys.exit("surfaces of these bodies need the package python3-gmsh")
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
