"""An end's resistance: the pressure there is resistance times flow, and the flow
is the one that these pressures make, which is linear in them.

Usage: check_resistance.py GIVEN RESISTED BEFORE BEHIND
    GIVEN     the same channel between given pressures of 11 and 3
    RESISTED  between resistances BEFORE and BEHIND, with a pressure of 11
"""
import sys

from fsbi.history import History

# bound: solved to 1e-9, a few hundred cells on each way
BOUND = 1e-7


def through(case):
    """Flow from the left to the right, pressures at both ends."""
    history = History(f"{case}/postProcessing/history.h5")
    left, right = (history[f"flow/{patch}"].array[-1, 1:] for patch in ("xMin", "xMax"))
    return right[1] - right[0], left[2], right[2]


given, resisted = sys.argv[1:3]
before, behind = map(float, sys.argv[3:])
conductance = through(given)[0]/8
Q, first, last = through(resisted)
expected = 11*conductance/(1 + conductance*(before + behind))
print(f"flow {Q}, expected {expected}, pressures {first} and {last}")
errors = abs(Q/expected - 1), abs(first/(11 - before*Q) - 1), abs(last - behind*Q)/11
print("errors", *errors)
sys.exit(not max(errors) < BOUND)
