/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "maxApproach.H"
#include "maxTravel.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(maxApproach, 0);
addToRunTimeSelectionTable(stepLimiter, maxApproach, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::maxApproach::maxApproach(const dictionary& controls)
:
    controls_(controls),
    told_(false)
{
    const checkedDictionary entries(controls);
    if (!entries.found("maxApproach"))
    {
        entries.getOrDefault("maxApproach", word("none"));
    }
}


void Foam::fsbi::maxApproach::limit
(
    const stepSituation& at, stepWish& wish
) const
{
    if (!controls_.found("maxApproach"))
    {
        return;
    }
    if (!told_)
    {
        reportUnseen("maxApproach does not look at", at.now.unseen());
        told_ = true;
    }
    const scalar part = checkedDictionary(controls_).positive("maxApproach");
    scalar largest = 0;
    for (const immersedBody& body : at.now.bodies().immersed)
    {
        largest = max(largest, body.radius());
    }
    string names;
    const scalar reach = 2*maxTravel::largest(controls_)*largest/part;
    const scalar contact = at.now.timeToContact(reach, names);
    wish.atMost(max(part*contact, at.shortest), "approach of " + names);
}
