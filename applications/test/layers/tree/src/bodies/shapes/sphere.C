/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(sphere, 0);
    addToRunTimeSelectionTable(bodyShape, sphere, dictionary);
}
}

Foam::fsbi::sphere::sphere(const dictionary& dict)
:
    smoothShape(dict),
    radius_(entries_.positive("radius"))
{
    entries_.finish();
}


Foam::scalar Foam::fsbi::sphere::exactVolume() const
{
    return 4*constant::mathematical::pi/3*pow3(radius_);
}
