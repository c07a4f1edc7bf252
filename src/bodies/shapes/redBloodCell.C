/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "redBloodCell.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(redBloodCell, 0);
    addToRunTimeSelectionTable(bodyShape, redBloodCell, dictionary);

    // Half the thickness over sqrt(1 - q), of the radius
    static const scalar C0 = 0.5*0.207161;
    static const scalar C1 = 0.5*2.002558;
    static const scalar C2 = -0.5*1.122762;
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::redBloodCell::redBloodCell(const dictionary& dict)
:
    smoothShape(dict),
    radius_(0.5*entries_.positive("diameter"))
{
    entries_.finish();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::redBloodCell::meridian Foam::fsbi::redBloodCell::at
(
    const scalar angle
)
{
    const scalar s = Foam::sin(angle), c = Foam::cos(angle), q = sqr(s);
    const scalar f = C0 + q*(C1 + q*C2);
    return {s, c*f, c, -s*f + 2*s*sqr(c)*(C1 + 2*q*C2)};
}


Foam::point Foam::fsbi::redBloodCell::image(const vector& direction) const
{
    const scalar q = sqr(direction.x()) + sqr(direction.y());
    const scalar f = C0 + q*(C1 + q*C2);
    return radius_*vector(direction.x(), direction.y(), f*direction.z());
}


Foam::point Foam::fsbi::redBloodCell::project(const point& p) const
{
    const scalar r = Foam::hypot(p.x(), p.y())/radius_;
    const scalar z = mag(p.z())/radius_;
    const scalar quarter = constant::mathematical::piByTwo;
    const auto far = [&](const scalar angle)
    {
        const meridian m(at(angle));
        return sqr(m.r - r) + sqr(m.z - z);
    };
    const auto slope = [&](const scalar angle)
    {
        const meridian m(at(angle));
        return (m.r - r)*m.dr + (m.z - z)*m.dz;
    };

    // the nearest of some, then halving where the way along the surface is
    // across the one to the point: safe near the rim and the dimples
    const label n = 24;
    label best = 0;
    for (label i = 1; i <= n; ++i)
    {
        best = far(i*quarter/n) < far(best*quarter/n) ? i : best;
    }
    scalar low = max(best - 1, 0)*quarter/n;
    scalar high = min(best + 1, n)*quarter/n;
    for (label i = 0; i < 50; ++i)
    {
        const scalar middle = 0.5*(low + high);
        (slope(middle) > 0 ? high : low) = middle;
    }
    const meridian m(at(0.5*(low + high)));
    const scalar turn = r > VSMALL ? m.r/r : 0;
    return vector
    (
        turn*p.x(), turn*p.y(), radius_*(p.z() < 0 ? -m.z : m.z)
    );
}


Foam::scalar Foam::fsbi::redBloodCell::exactVolume() const
{
    return
        4*constant::mathematical::pi*pow3(radius_)
       *(C0/3 + 2*C1/15 + 8*C2/105);
}


Foam::scalar Foam::fsbi::redBloodCell::defaultSize() const
{
    return radius_/8;
}
