/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "growth.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(growth, 0);
addToRunTimeSelectionTable(stepLimiter, growth, entries);

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::growth::limit(const stepSituation& at, stepWish& wish) const
{
    const scalar largest = 1.5;
    wish.atMost
    (
        at.first ? at.last : largest*at.last, at.first ? "deltaT" : "growth"
    );
}
