# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/reduced.h5, which method 'reduced' reads: see src/reduced/reducedTable.H."""

import hashlib
import os

import h5py
import numpy as np

FILE = "constant/reduced.h5"


def _flow(case):
    """A digest of the flow's conditions; a run overwrites those of the folder 0."""
    path = os.path.join(case, "0.orig", "fluid", "U")
    if not os.path.isfile(path):
        return ""
    with open(path, "rb") as file:
        return hashlib.sha1(file.read()).hexdigest()


def write(study, surrogate):
    """Whole or not at all."""
    about = study.about
    body = about.body
    tables = dict(
        wall=[[*about.origin, *about.normal, *study.flow]],
        body=[[*body.axis, body.along, body.across]],
        range=[[about.low, about.high]],
        error=[[surrogate.error]],
        gapKnots=np.reshape(surrogate.gapKnots, (-1, 1)),
        angleKnots=np.reshape(surrogate.angleKnots, (-1, 1)),
        coefficients=surrogate.coefficients.reshape(-1, surrogate.coefficients.shape[-1]))
    path = os.path.join(study.bench.case, FILE)
    with h5py.File(path + ".part", "w") as file:
        for name, values in tables.items():
            file[name] = np.asarray(values, float)
        for name, text in (("fingerprint", study.fingerprint), ("body", about.name),
                           ("flow", _flow(study.bench.case))):
            file.attrs[name] = np.array([text.encode()])
    os.replace(path + ".part", path)
    return path
