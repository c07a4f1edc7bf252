/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "maxDeltaT.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(maxDeltaT, 0);
addToRunTimeSelectionTable(stepLimiter, maxDeltaT, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::maxDeltaT::maxDeltaT(const dictionary& controls)
:
    controls_(controls)
{
    const checkedDictionary entries(controls);
    if (!entries.found("maxDeltaT"))
    {
        entries.getOrDefault("maxDeltaT", word("none"));
    }
}


void Foam::fsbi::maxDeltaT::limit(const stepSituation&, stepWish& wish) const
{
    if (controls_.found("maxDeltaT"))
    {
        wish.atMost
        (
            checkedDictionary(controls_).positive("maxDeltaT"), "maxDeltaT"
        );
    }
}
