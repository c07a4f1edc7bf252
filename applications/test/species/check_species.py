"""What the history says of dissolved species: check_species.py case what [case]"""
import sys

import numpy as np

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


case, what, others = sys.argv[1], sys.argv[2], sys.argv[3:]
sys.exit(not globals()[what](case, *others))
