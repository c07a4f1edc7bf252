/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "maxDrift.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(maxDrift, 0);
addToRunTimeSelectionTable(stepLimiter, maxDrift, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::maxDrift::maxDrift(const dictionary& dict)
{
    const checkedDictionary entries(dict);
    entries.found("libs");
    body_ = entries.get<word>("body");
    distance_ = entries.positive("distance");
    entries.finish();
}


void Foam::fsbi::maxDrift::limit(const stepSituation& at, stepWish& wish) const
{
    for (const immersedBody& body : at.now.bodies().immersed)
    {
        if (body.name() == body_)
        {
            wish.atMost
            (
                distance_/max(mag(linear(body.motion())), VSMALL),
                "drift of " + body_
            );
        }
    }
}
