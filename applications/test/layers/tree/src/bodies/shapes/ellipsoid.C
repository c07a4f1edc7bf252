/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ellipsoid.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(ellipsoid, 0);
    addToRunTimeSelectionTable(bodyShape, ellipsoid, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::ellipsoid::ellipsoid(const dictionary& dict)
:
    smoothShape(dict),
    semiAxes_(entries_.get<vector>("semiAxes"))
{
    entries_.finish();
    if (cmptMin(semiAxes_) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'semiAxes' must be above zero, but is " << semiAxes_
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::ellipsoid::image(const vector& direction) const
{
    return cmptMultiply(semiAxes_, direction);
}


Foam::point Foam::fsbi::ellipsoid::project(const point& p) const
{
    return p/mag(cmptDivide(p, semiAxes_));
}


Foam::scalar Foam::fsbi::ellipsoid::exactVolume() const
{
    return
        4*constant::mathematical::pi/3
       *semiAxes_.x()*semiAxes_.y()*semiAxes_.z();
}


Foam::scalar Foam::fsbi::ellipsoid::defaultSize() const
{
    return cmptMin(semiAxes_)/3;
}
