# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutations that may change nothing without a word, each with the reason."""

import re

# (file, entry, kind, why), each a pattern of the whole
LIST = [
    (".*", "", "CRLF|Latin-1 comment",
     "the same text, written otherwise"),
    (".*", "FoamFile.*", "deleted|word|emptied",
     "a note in OpenFOAM's header, which has no meaning"),
    ("system/.*/fvSchemes", "(ddt|grad|div|laplacian|interpolation|snGrad)Schemes.*", ".*",
     "there is one discretisation, as the file says; OpenFOAM's tools read these"),
    ("constant/regionProperties", ".*", ".*",
     "for OpenFOAM's tools; fsbiFoam knows the regions from the bodies"),
    ("constant/givenTorque", ".*", ".*",
     "included by nobody until Allrun puts it in the place of givenSpin"),
    ("system/blockMeshDict", ".*", "twice|deleted|emptied",
     "blockMesh reads this, which is OpenFOAM's and makes the same mesh"),
    ("system/blockMeshDict", r"boundary\..*\.type", ".*",
     "wall or patch: what counts for the flow is the condition in 0/fluid/U"),
    ("system/controlDict", "application|startTime|stopAt|startFrom|writeControl|adjustTimeStep",
     "deleted", "the default spelled out"),
    ("system/controlDict", "application", ".*",
     "a note for OpenFOAM's scripts"),
    ("system/controlDict", "startTime", ".*",
     "startFrom latestTime does not ask for it"),
    ("system/controlDict", "maxDeltaT|maxApproach|maxRotation|maxTravel", "deleted",
     "a limit that two steps do not reach"),
    ("system/controlDict", "writeFormat|timePrecision", ".*",
     "how states are written, not what is in them"),
    ("system/remeshDict", r"follow\.direction", "negated",
     "a line has no sense of direction"),
    ("system/remeshDict", "follow.*", "deleted",
     "the frame moves by less than a new mesh wants within two steps"),
    ("0/.*", "internalField", "zeroed|negated|deleted",
     "Stokes flow and statics have no memory: the start value is solved for at once"),
    ("constant/effects", r"bonds.*", "zeroed|deleted",
     "no bond forms within two steps"),
    ("constant/effects", r"repulsion\.(strength|between)", "zeroed|deleted",
     "the bodies are not within its reach"),
    ("constant/effects", r"magnetics\.(fields|controller\.coils)\.[^.]+", "misspelt",
     "a name that is the user's own to choose"),
    ("constant/effects", r"magnetics\.fields\.[^.]+\.axis", "negated",
     "the gradient along an axis is the same both ways"),
]


# (file, entry): names that are the user's own to choose, which differ in the
# tables where they do
NAMES = [
    ("constant/bodies", r"[^.]+"),
    ("constant/effects", r"magnetics\.fields\.[^.]+|bonds\.pairs\.[^.]+"),
    ("system/controlDict", r"functions\.[^.]+"),
]


def name(mutation):
    """Is a misspelt word a name as good as the one before?"""
    entry = ".".join(mutation.path)
    return mutation.kind == "misspelt" and any(
        re.fullmatch(file, mutation.file) and re.fullmatch(path, entry)
        for file, path in NAMES)


def reason(mutation):
    entry = ".".join(mutation.path)
    for file, path, kind, why in LIST:
        if re.fullmatch(file, mutation.file) and re.fullmatch(path, entry) \
                and re.fullmatch(kind, mutation.kind):
            return why
    return ""
