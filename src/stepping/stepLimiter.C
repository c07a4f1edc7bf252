/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepLimiter.H"
#include "loadLibraries.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(stepLimiter, 0);
defineRunTimeSelectionTable(stepLimiter, entries);

//- Of every scene; their entries stand in controlDict itself
static const wordList always
({
    "maxDeltaT", "growth", "maxRotation", "maxTravel", "maxApproach", "effects"
});

//- One's own, from an entry of `stepLimiters`
static autoPtr<stepLimiter> own(const dictionary& limiters, const entry& e)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(limiters)
            << "Entry '" << e.keyword() << "' is no dictionary: a step limiter"
            << " is name { libs (...); ... }" << exit(FatalIOError);
    }
    loadLibraries(e.dict());
    const auto* table = stepLimiter::entriesConstructorTablePtr_;
    if (always.found(e.keyword()) || !table->found(e.keyword()))
    {
        wordList valid(table->sortedToc());
        inplaceSubsetList
        (
            valid, [](const word& type) { return !always.found(type); }
        );
        FatalIOErrorInFunction(limiters)
            << "There is no step limiter '" << e.keyword() << "' in the"
            << " libraries loaded, of its entry 'libs' or controlDict's; valid"
            << " ones are " << flatOutput(valid) << exit(FatalIOError);
    }
    return (*table)[e.keyword()](e.dict());
}

} // End namespace fsbi
} // End namespace Foam


Foam::PtrList<Foam::fsbi::stepLimiter> Foam::fsbi::stepLimiter::all
(
    const dictionary& controls
)
{
    PtrList<stepLimiter> limiters;
    for (const word& type : always)
    {
        limiters.append((*entriesConstructorTablePtr_)[type](controls));
    }
    if (controls.found("stepLimiters"))
    {
        const dictionary& others =
            checkedDictionary(controls).subDict("stepLimiters");
        for (const entry& e : others)
        {
            limiters.append(own(others, e));
        }
    }
    return limiters;
}
