/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshControls.H"
#include "checkedDictionary.H"
#include "wordList.H"

Foam::fsbi::remeshControls::remeshControls(const dictionary& dict)
:
    name(dict.name())
{
    checkedDictionary entries(dict);
    const auto orNoted = [&](const word& key, const char* deflt)
    {
        if (entries.found(key))
        {
            return entries.positive(key);
        }
        entries.getOrDefault(key, word(deflt, false));      // for a dry run
        return scalar(0);
    };
    algorithm = entries.choice("algorithm", {"Delaunay", "HXT"}, "Delaunay");
    growth = entries.positive("growth", 0.25);
    farSize = orNoted("farSize", "that of blockMesh's cells");
    minSize = orNoted("minSize", "0.4 of the bodies' finest mean edge");
    cellsPerGap = entries.positive("cellsPerGap", 3);
    gapSag = entries.getOrDefault<scalar>("gapSag", 0.025);
    if (gapSag < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'gapSag' must be zero (no triangle is cut) or more, but is "
            << gapSag << exit(FatalIOError);
    }
    optimise = entries.getOrDefault<label>("optimise", 1);
    maxNonOrthogonality = entries.positive("maxNonOrthogonality", 70);
    maxSkewness = entries.positive("maxSkewness", 4);
    minVolumeRatio = entries.positive("minVolumeRatio", 0.05);
    maxTwist = entries.positive("maxTwist", 0.5);
    maxCells = entries.positive("maxCells", 1e6);
    entries.finish();
}
