/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshControls.H"
#include "checkedDictionary.H"
#include "wordList.H"

Foam::fsbi::remeshControls::remeshControls(const dictionary& dict)
{
    checkedDictionary entries(dict);
    algorithm = entries.choice("algorithm", {"Delaunay", "HXT"}, "Delaunay");
    growth = entries.positive("growth", 0.25);
    farSize = entries.found("farSize") ? entries.positive("farSize") : 0;
    minSize = entries.found("minSize") ? entries.positive("minSize") : 0;
    cellsPerGap = entries.positive("cellsPerGap", 3);
    optimise = entries.getOrDefault<label>("optimise", 1);
    maxNonOrthogonality = entries.positive("maxNonOrthogonality", 70);
    maxSkewness = entries.positive("maxSkewness", 4);
    minVolumeRatio = entries.positive("minVolumeRatio", 0.05);
    maxTwist = entries.positive("maxTwist", 0.5);
    entries.finish();
}
