# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a drug does to a rolling leukocyte: its receptors, bonds and way, with and
without; where the drug is."""

import numpy as np

from fsbi import plots
from fsbi.history import History

STORE = 1e7         # molecules
SITES = 15          # 1/um2

drugged = History("postProcessing/history.h5")
without = History("without/postProcessing/history.h5")
bound = drugged["species/drug/surfaces/leukocyte"]

figure, (left, right) = plots.plt.subplots(1, 2, figsize=(9.6, 4.2))
left.plot(bound["time"] * 1e-3, bound["held"] / SITES, color=plots.COLOURS[0], label="all over")
left.plot(bound["time"] * 1e-3, bound["heldMost"] / SITES, color=plots.COLOURS[1],
          label="where it is most")
left.set(xlabel="time (ms)", ylabel="part of PSGL-1 that is blocked", ylim=(0, 1.02))
left.set_title("The drug binds", loc="left")
left.legend(loc="lower right")
for history, label, colour in ((without, "without the drug", plots.COLOURS[2]),
                               (drugged, "with it", plots.COLOURS[3])):
    bonds = history["effects/bonds/selectin"]
    right.step(bonds["time"] * 1e-3, bonds["number"], color=colour, label=label)
right.set(xlabel="time (ms)", ylabel="bonds")
right.set_title("Bonds with the wall", loc="left")
right.legend()
plots.save(figure, "drug.png")


def late(history, what):
    """Bonds that formed after 55 ms; their mean number then."""
    events, bonds = history["effects/bonds/events"], history["effects/bonds/selectin"]
    t = bonds["time"]
    numbers = np.interp(np.linspace(55e3, 80e3, 500), t, bonds["number"])
    formed = np.sum((events["formed"] == 1) & (events["instant"] > 55e3))
    x = history["bodies/leukocyte/position"]
    way = x["x"][-1] - np.interp(55e3, x["time"], x["x"])
    print(f"    from 55 to 80 ms {what}: {formed} bonds form, {numbers.mean():.1f} in the mean,"
          f" {way / 25:.3f} mm/s")


late(without, "without the drug")
late(drugged, "with it")
balance = drugged["species/drug/balance"]
parts = {
    "in the bead": drugged["species/drug/surfaces/bead"]["held"],
    "in the fluid": balance["fluid"],
    "bound to the leukocyte": -bound["released"],
    "carried off by the flow": -balance["entered"],
}
for name, amount in parts.items():
    print(f"    {name:24} {amount[-1] / STORE:.6f}")
total = sum(amount[-1] for amount in parts.values())
print(f"    all of it                {total / STORE:.12f}")
print(f"    largest error of the balance {np.abs(balance['error']).max():.1e}")
