/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What system/controlDict may hold

#include "stepControl.H"
#include "spelling.H"
#include "IFstream.H"

namespace Foam
{
namespace fsbi
{

//- Of the step control, with adjustTimeStep only
static const wordList limits({"maxDeltaT", "maxRotation", "maxTravel", "maxApproach"});

//- Ours and OpenFOAM's
static const wordList knownEntries
({
    "adjustTimeStep", "maxDeltaT", "maxRotation", "maxTravel", "maxApproach",
    "minDeltaT", "stepLimiters",
    "FoamFile", "application", "startFrom", "startTime", "stopAt", "endTime",
    "deltaT", "writeControl", "writeInterval", "purgeWrite", "writeFormat",
    "writePrecision", "writeCompression", "timeFormat", "timePrecision",
    "runTimeModifiable", "graphFormat", "libs", "functions", "maxCo",
    "secondaryWriteControl", "secondaryWriteInterval", "secondaryPurgeWrite",
    "DebugSwitches", "InfoSwitches", "OptimisationSwitches",
    "DimensionedConstants", "DimensionSets", "profiling"
});

static void checkSpelling(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        const word meant(nearest(e.keyword(), knownEntries));
        if (knownEntries.found(e.keyword()))
        {
            continue;
        }
        if (meant.size())
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << e.keyword() << "' on line "
                << e.startLineNumber() << ": is it " << meant << "?"
                << exit(FatalIOError);
        }
        Info<< "Warning: entry '" << e.keyword() << "' on line "
            << e.startLineNumber() << " of system/controlDict is neither the"
            << " step control's nor OpenFOAM's" << nl << endl;
    }
}

static void checkSigns(const dictionary& dict)
{
    wordList keys(limits);
    keys.append(wordList({"deltaT", "writeInterval", "minDeltaT"}));
    for (const word& key : keys)
    {
        if (!(dict.getOrDefault<scalar>(key, 1) > 0))
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' must be above zero, but is "
                << dict.get<scalar>(key) << exit(FatalIOError);
        }
    }
}

static void checkShortest(const dictionary& dict)
{
    const scalar shortest = dict.getOrDefault<scalar>("minDeltaT", 0);
    for (const word key : {"deltaT", "maxDeltaT"})
    {
        if (shortest > dict.getOrDefault<scalar>(key, GREAT))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'minDeltaT' is " << shortest << ", above '" << key
                << "' with " << dict.get<scalar>(key) << exit(FatalIOError);
        }
    }
}

//- That they end, and what is not used in them
static void checkFixedSteps(const dictionary& dict)
{
    wordList unused(limits);
    unused.append("stepLimiters");
    for (const word& key : unused)
    {
        if (dict.found(key))
        {
            Info<< "Warning: entry '" << key << "' of system/controlDict is not"
                << " used: it needs 'adjustTimeStep yes'" << nl << endl;
        }
    }
    const scalar dt = dict.get<scalar>("deltaT");
    const scalar end = dict.getOrDefault<scalar>("endTime", 0);
    if (end/dt > labelMax)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'deltaT' is " << dt << ": that are " << end/dt
            << " steps to the endTime " << end << exit(FatalIOError);
    }
    if (end > 0 && dt > end)
    {
        Info<< "Warning: entry 'deltaT' of system/controlDict is " << dt
            << ", longer than the run: one step to the endTime " << end << nl
            << endl;
    }
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::stepControl::check(const argList& args)
{
    if (Pstream::master())
    {
        IFstream is(args.globalPath()/"system"/"controlDict");
        const dictionary dict(is);
        checkSpelling(dict);
        checkSigns(dict);
        checkShortest(dict);
        if (!dict.getOrDefault("adjustTimeStep", false))
        {
            checkFixedSteps(dict);
        }
    }
    returnReduce(true, andOp<bool>());          // until the master has looked
}
