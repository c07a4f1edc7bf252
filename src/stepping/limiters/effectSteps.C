/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectSteps.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(effectSteps, 0);
addToRunTimeSelectionTable(stepLimiter, effectSteps, entries);

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::effectSteps::limit
(
    const stepSituation& at, stepWish& wish
) const
{
    if (at.now.effects())
    {
        string reason;
        const scalar wanted = at.now.effects()->longestStep(reason);
        wish.atMost(max(wanted, at.shortest), reason);
    }
}
