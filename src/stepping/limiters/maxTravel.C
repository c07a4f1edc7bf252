/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "maxTravel.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(maxTravel, 0);
addToRunTimeSelectionTable(stepLimiter, maxTravel, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::maxTravel::maxTravel(const dictionary& controls)
:
    controls_(controls)
{
    largest(controls);
}


Foam::scalar Foam::fsbi::maxTravel::largest(const dictionary& controls)
{
    return checkedDictionary(controls).positive("maxTravel", 0.2);
}


void Foam::fsbi::maxTravel::limit(const stepSituation& at, stepWish& wish) const
{
    const scalar part = largest(controls_);
    for (const immersedBody& body : at.now.bodies().immersed)
    {
        wish.atMost
        (
            part*body.radius()/max(mag(linear(body.motion())), VSMALL),
            "travel of " + body.name()
        );
    }
}
