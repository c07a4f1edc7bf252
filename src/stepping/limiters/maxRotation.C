/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "maxRotation.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(maxRotation, 0);
addToRunTimeSelectionTable(stepLimiter, maxRotation, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::maxRotation::maxRotation(const dictionary& controls)
:
    controls_(controls)
{
    largest();
}


Foam::scalar Foam::fsbi::maxRotation::largest() const
{
    return checkedDictionary(controls_).positive("maxRotation", 0.2);
}


void Foam::fsbi::maxRotation::limit
(
    const stepSituation& at, stepWish& wish
) const
{
    const scalar turn = largest();
    for (const immersedBody& body : at.now.bodies().immersed)
    {
        wish.atMost
        (
            turn/max(mag(angular(body.motion())), VSMALL),
            "rotation of " + body.name()
        );
    }
}
