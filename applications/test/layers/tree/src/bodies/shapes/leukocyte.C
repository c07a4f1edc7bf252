/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "leukocyte.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(leukocyte, 0);
    addToRunTimeSelectionTable(bodyShape, leukocyte, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::leukocyte::leukocyte(const dictionary& dict)
:
    smoothShape(dict)
{
    const scalar radius = entries_.positive("radius");
    const scalar Ax = entries_.getOrDefault<scalar>("Ax", 0.25*radius);
    const scalar Ay = entries_.getOrDefault<scalar>("Ay", 0.1);
    const scalar By = entries_.getOrDefault<scalar>("By", 0.4);
    entries_.finish();
    if (!leukocyteMap::invertible(radius, Ax, Ay, By))
    {
        FatalIOErrorInFunction(dict)
            << "The shape folds over itself: |Ax| must be below 2 radius/pi, "
            << "Ay and By below 1, but they are " << Ax << ", " << Ay << ", "
            << By << exit(FatalIOError);
    }
    map_.reset(new leukocyteMap(radius, Ax, Ay, By));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::leukocyte::image(const vector& direction) const
{
    return map_->fromSphere(map_->radius()*direction);
}


Foam::point Foam::fsbi::leukocyte::project(const point& p) const
{
    const point s(map_->toSphere(p));
    return map_->fromSphere(map_->radius()/mag(s)*s);
}


Foam::scalar Foam::fsbi::leukocyte::exactVolume() const
{
    return 0;
}


Foam::scalar Foam::fsbi::leukocyte::defaultSize() const
{
    return map_->radius()/5;
}
