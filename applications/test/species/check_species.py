"""What the history says of dissolved species: check_species.py case what [case]"""
import sys

import numpy as np
from scipy.spatial.transform import Rotation
from vtk.util.numpy_support import vtk_to_numpy

from fsbi import vtk_files
from fsbi.history import History

# Digits of sums over cells: amounts are differences of numbers with 1e-16, a few
# thousand of them in each of a few steps
DIGITS = 1e-12


def table(case, path):
    history = History(f"{case}/postProcessing/history.h5")
    return history[f"species/{path}"]


def of_all(case):
    history = History(f"{case}/postProcessing/history.h5")
    return {p.split("/")[1]: history[p] for p in history.paths()
            if p.startswith("species/") and p.endswith("/balance")}


def no_more(what, value, bound):
    print(f"{what}: {value:.3g}, bound {bound:.3g}")
    return value <= bound


def uniform(case):
    t = table(case, "even/balance")
    # bound: volume is balanced in every cell to 1e-13 of what is missing at first
    return no_more("largest departure", max(np.abs(t["min"] - 1).max(),
                                            np.abs(t["max"] - 1).max()), DIGITS)


def balance(case):
    return all([no_more(name, np.abs(t["error"]).max(), DIGITS)
                for name, t in of_all(case).items()])


def bounds(case):
    lowest = min(t["min"].min() for t in of_all(case).values())
    highest = table(case, "blob/balance")["max"].max()
    held = table(case, "drug/surfaces/topWall")["held"]
    print(f"lowest {lowest:.3g}, held {held.min():.3g} to {held.max():.3g}")
    return (lowest >= 0 and no_more("highest of the blob", highest, 1 + DIGITS)
            and held.min() >= 0 and held.max() <= 0.5)


def told(case):
    """What steps leave of the equations."""
    # bound: of a uniform one the limits do nothing, and the equations are solved to the
    # tolerance; of the blob they may not settle, which is no more than 1e-3 of the amounts
    # where the levelled part of a step is of the per cent
    even, blob = (table(case, f"{name}/balance")["residual"] for name in ("even", "blob"))
    return (blob.max() > 0 and no_more("of the uniform one", even.max(), 1e-9)
            and no_more("of the blob", blob.max(), 1e-3))


def released(case):
    t = table(case, "drug/surfaces/cell")
    rates = t["released"] / t["time"]
    # bound: the triangles of a rigid body turn as they are; their sum has digits
    return no_more("rates differ", np.ptp(rates) / rates.mean(), DIGITS)


def carried(case):
    """A part of the surface is marked in the first steps, after which nothing is left."""
    quaternions = History(f"{case}/postProcessing/history.h5")["bodies/cell/orientation"]
    moments, turned, held = [], [], []
    with vtk_files.VTKFiles(case, "fluid", "marker.bound", "4,8", internal=False) as states:
        for state in states:
            faces = state.patch("cell")
            x = vtk_to_numpy(faces.GetPoints().GetData()).astype(float)
            corners = x[vtk_to_numpy(faces.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
            area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                           corners[:, 2] - corners[:, 0]), axis=1) / 2
            bound = area * vtk_to_numpy(faces.GetCellData().GetArray("marker.bound"))
            moments.append(bound @ (corners.mean(axis=1) - area @ corners.mean(axis=1)
                                    / area.sum()) / bound.sum())
            held.append(bound.sum())
            i = np.argmin(np.abs(quaternions["time"] - state.time))
            turned.append(Rotation.from_quat([quaternions[k][i] for k in "xyzw"]))
    goes = (turned[1] * turned[0].inv()).apply(moments[0])
    angle = np.linalg.norm((turned[1] * turned[0].inv()).as_rotvec())
    print(f"moment {moments[0]}, {moments[1]}, by the body {goes}, turned by {angle:.3g}")
    # bound: files of foamToVTK have 7 digits; step 4 finds 1e-12 of what was there
    return (angle > 0.1 and np.linalg.norm(moments[0]) > 0.3
            and no_more("off", np.linalg.norm(moments[1] - goes), 1e-5)
            and no_more("lost", abs(held[1] / held[0] - 1), 1e-5))


def store(case):
    t = table(case, "stored/surfaces/cell")
    exact = 10 * np.exp(-0.3 * t["time"])
    return (no_more("left of exact", np.abs(t["held"] / exact - 1).max(), DIGITS)
            and no_more("sum", np.abs(t["held"] + t["released"] - 10).max(), 10 * DIGITS))


def amounts(case, other):
    worst = 0
    for name, t in of_all(case).items():
        here, there = t["fluid"], table(other, f"{name}/balance")["fluid"]
        worst = max(worst, np.abs(here - there).max() / np.abs(here).max())
    return no_more("difference", worst, 1e-5)


def displaced(case):
    t = table(case, "even/balance")
    gone = -t["displaced"][-1] / (4 / 3 * np.pi * 6)
    # bound: triangles are put so that they have the ellipsoid's volume, 4/3 pi a b c;
    # digits of coordinates
    return (no_more("displaced, over the body's volume", abs(gone - 1), 1e-9)
            and balance(case) and uniform(case))


def equilibrium(case):
    t = table(case, "bound/surfaces/topWall")
    c = table(case, "bound/balance")["max"][-1]
    # bound: what is bound is found to 1e-8 of the sites
    return no_more("off", abs(t["held"][-1] - 2 * c * 1e-3 / (c * 1e-3 + 5e-4)), 1e-7)


def decay(case):
    t = table(case, "decays/balance")
    exact = t["fluid"][0] / t["fluid"][1] - 1
    # each step divides by 1 + k dt
    return (no_more("off", abs(exact / (0.25 * 1e6) - 1), 1e-6)
            and balance(case))


def full(case):
    t = table(case, "full/balance")
    # bound: of diffusion over 4 steps of 1e6 us nothing is left; the solver's tolerance
    return no_more("off", max(abs(t["min"][-1] - 0.7), abs(t["max"][-1] - 0.7)), 1e-6)


def formed(case):
    """Bonds that form when what can be bound is: kind of the pair, x at both ends."""
    t = History(f"{case}/postProcessing/history.h5")["effects/bonds/events"]
    late = (t["formed"] == 1) & (t["instant"] > 2)
    return t["pair"][late], t["ax"][late], t["bx"][late]


def beside(case):
    pair, on_cell, on_wall = formed(case)
    # bound: a face takes all of what its cell has; edges are up to 0.8 on the sphere,
    # and on the wall, by growth, up to 1.5
    blocked = np.sum((pair == 0) & (on_cell < -0.8)), np.sum((pair == 1) & (on_wall < -1.5))
    free = [np.sum((pair == k) & (x > 0)) for k, x in ((0, on_cell), (1, on_wall))]
    print(f"formed where blocked {blocked}, where not {free}")
    return max(blocked) == 0 and min(free) > 20


def same(case, other):
    a, b = (History(f"{c}/postProcessing/history.h5")["effects/bonds/events"]
            for c in (case, other))
    keys = "pair", "set", "site", "formed"
    print(f"{len(a['site'])} and {len(b['site'])} events")
    return len(a["site"]) > 50 and all(np.array_equal(a[k], b[k]) for k in keys)


def parts(case):
    t = table(case, "drug/surfaces/cell")
    print("(0 0)", *(f"({time:.17g} {held:.17g})"
                     for time, held in zip(t["time"], t["held"] / 1e-6)))
    return True


def by_langmuir(case):
    t = table(case, "drug/surfaces/cell")
    exact = [0]
    for _ in t["time"]:
        exact.append((exact[-1] + 0.1) / (1 + 0.1 + 0.05))
    # bound: 1e-6/um2 on the sphere's 201 and the wall's 256 um2 is 1.2e-7 of what
    # 3800 um3 have; as much is as good as missing beside the surface, j h/D; what is
    # bound is found to 1e-8 of the sites
    return no_more("off", np.abs(t["held"] / 1e-6 - exact[1:]).max(), 5e-7)


case, what, others = sys.argv[1], sys.argv[2], sys.argv[3:]
sys.exit(not globals()[what](case, *others))
