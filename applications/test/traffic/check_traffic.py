"""What the history says of bodies that come and go: check_traffic.py case [what]"""
import sys

import numpy as np

from fsbi.history import History

case = sys.argv[1]
what = sys.argv[2] if len(sys.argv) > 2 else "stream"
history = History(f"{case}/postProcessing/history.h5")
failed = False


def check(text, good):
    global failed
    print(text, "" if good else "NOT SO")
    failed |= not good


def table(path):
    return history[path].array


if what == "stream":
    traffic = table("traffic")
    first, again, late, waits = (traffic[traffic[:, 1] == b] for b in range(4))
    check("one event of the first, it leaves",
          len(first) == 1 and first[0, 2] == 0)
    check("the second leaves and enters by turns, and enters in its box",
          len(again) > 1 and all(again[1:, 2] != again[:-1, 2])
          and all((e[3:] >= [3, -2, -2]).all() and (e[3:] <= [4, 2, 2]).all()
                  for e in again[again[:, 2] == 1]))
    left = again[again[:, 2] == 0][0, 0]
    back = [e[0] for e in again if e[2] == 1 and e[0] > left]
    check("not before its time", not back or min(back) >= left + 2000)
    check("the third enters after 4000",
          late[0, 2] == 1 and 4000 < late[0, 0] <= 5001)
    check("the fourth never", len(waits) == 0)
    check("a body has rows while it is there",
          table("bodies/first/position")[-1, 0] < first[0, 0] + 1
          and table("bodies/late/position")[0, 0] == late[0, 0])
    flow_in, flow_out = table("flow/inlet"), table("flow/outlet")
    # bound: digits of the sums on the inlet; what the solver's tolerance of
    # 1e-8 leaves in cells adds up to less than 1e-4 of the flow on the outlet
    check("the rate is the one given",
          np.abs(flow_in[:, 1]/0.032 - 1).max() < 1e-10
          and flow_in[:, 2].max() < 1e-10)
    check("what flows in flows out",
          np.abs((flow_out[:, 2] - flow_out[:, 1])/0.032 - 1).max() < 1e-4)
    check("the pressure falls", (flow_in[:, 3] > flow_out[:, 3]).all())
elif what == "bonds":
    pair = table("effects/bonds/pair")
    print("bonds:", *pair[:, 1].astype(int))
    check("there were bonds", pair[:, 1].max() > 0)
    check("there are none in the end", pair[-1, 1] == 0)
    check("as many formed as broke", pair[:, 2].sum() == pair[:, 3].sum())
    left = table("traffic")
    check("both have left, or one is on its way", left[0, 1] == 0)
    # after the first one has left the other goes with the flow, unpulled
    force = table("bodies/back/force/effects")
    check("nothing pulls any more",
          np.abs(force[force[:, 0] > left[0, 0], 1:]).max(initial=0) == 0)
else:
    traffic = table("traffic")
    entry = traffic[traffic[:, 2] == 1][0]
    axes = table("elasticBodies/soft/semiAxes")
    at = axes[axes[:, 0] >= entry[0]][0]
    before = axes[axes[:, 0] < entry[0]][-1]
    print(f"longest over shortest axis: {before[1]/before[3]:.4f} when it left,"
          f" {at[1]/at[3]:.4f} after its first step back")
    centre = table("elasticBodies/soft/centre")
    place = centre[centre[:, 0] >= entry[0]][0, 1:]
    # one step of 500 in a flow of 1e-3 at most
    check("it is where it was put",
          np.abs(place - entry[3:]).max() < 0.55)
    check("it is rounder than it was", at[1]/at[3] < before[1]/before[3])
sys.exit(failed)
