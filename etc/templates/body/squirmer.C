/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "squirmer.H"
#include "bodyShape.H"
#include "Time.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(squirmer, 0);
addToRunTimeSelectionTable(body, squirmer, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::squirmer::squirmer
(
    const bodySite& site, const dictionary& dict, const dictionary& saved
)
:
    prescribedBody(site.name, dict),
    surface_(bodyShape::New(entries_.subDict("shape"))->triangulate()),
    axis_(entries_.direction("axis")),
    slip_(entries_.get<scalar>("slip"))
{
    // its memory, place and orientation, is that of every prescribedBody
    begin(site.time.value(), saved);
}


Foam::vector Foam::fsbi::squirmer::velocityAt(const point& x) const
{
    const vector r((x - now().centre)/mag(x - now().centre));
    const vector e(now().orientation.transform(axis_));
    return linear(now().velocity) + slip_*((e & r)*r - e);
}


Foam::fsbi::bodySurface Foam::fsbi::squirmer::placedSurface() const
{
    return surface_.transformed(now().orientation.R(), now().centre);
}


Foam::vectorField Foam::fsbi::squirmer::pointVelocity() const
{
    vectorField v(placedSurface().points());
    for (vector& x : v)
    {
        x = velocityAt(x);
    }
    return v;
}
