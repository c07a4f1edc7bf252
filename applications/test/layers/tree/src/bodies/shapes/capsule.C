/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "capsule.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(capsule, 0);
    addToRunTimeSelectionTable(bodyShape, capsule, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::capsule::capsule(const dictionary& dict)
:
    smoothShape(dict),
    radius_(entries_.positive("radius")),
    length_(entries_.positive("length"))
{
    entries_.finish();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::capsule::image(const vector& direction) const
{
    // the equator is drawn out to the cylinder
    return project
    (
        cmptMultiply(direction, vector(radius_, radius_, radius_ + length_/2))
    );
}


Foam::point Foam::fsbi::capsule::project(const point& p) const
{
    const point axis(0, 0, max(-length_/2, min(length_/2, p.z())));
    return axis + radius_/mag(p - axis)*(p - axis);
}


Foam::scalar Foam::fsbi::capsule::exactVolume() const
{
    return constant::mathematical::pi*sqr(radius_)*(4*radius_/3 + length_);
}


Foam::scalar Foam::fsbi::capsule::defaultSize() const
{
    return radius_/4;
}
