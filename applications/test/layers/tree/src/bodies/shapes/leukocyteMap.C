/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "leukocyteMap.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::leukocyteMap::leukocyteMap
(
    const scalar radius, const scalar Ax, const scalar Ay, const scalar By
)
:
    radius_(radius),
    Ax_(Ax),
    Ay_(Ay),
    By_(By)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

bool Foam::fsbi::leukocyteMap::invertible
(
    const scalar radius, const scalar Ax, const scalar Ay, const scalar By
)
{
    return radius > 0 && mag(Ax) < 2*radius/pi && Ay < 1 && By < 1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::fsbi::leukocyteMap::fromSphere(const point& p) const
{
    const scalar squeeze =
        p.y() < 0 ? By_*Foam::cos(pi*p.x()/(8*radius_)) : Ay_;
    return point
    (
        p.x() + Ax_*Foam::cos(pi*p.x()/(2*radius_)),
        (1 - squeeze)*p.y(),
        p.z()
    );
}


Foam::point Foam::fsbi::leukocyteMap::toSphere(const point& q) const
{
    const scalar k = pi/(2*radius_);
    scalar x = q.x();
    for (label i = 0; i < 100; ++i)
    {
        const scalar dx =
            (x + Ax_*Foam::cos(k*x) - q.x())/(1 - k*Ax_*Foam::sin(k*x));
        // short steps: the slope is small where the shape is steep
        x -= max(-radius_/4, min(radius_/4, dx));
        if (mag(dx) < 1e-15*radius_)
        {
            break;
        }
    }
    const scalar squeeze = q.y() < 0 ? By_*Foam::cos(pi*x/(8*radius_)) : Ay_;
    return point(x, q.y()/(1 - squeeze), q.z());
}


Foam::tensor Foam::fsbi::leukocyteMap::gradient(const point& p) const
{
    const scalar k = pi/(2*radius_), m = pi/(8*radius_);
    const bool below = p.y() < 0;
    return tensor
    (
        1 - k*Ax_*Foam::sin(k*p.x()), 0, 0,
        below ? m*By_*p.y()*Foam::sin(m*p.x()) : 0,
        1 - (below ? By_*Foam::cos(m*p.x()) : Ay_), 0,
        0, 0, 1
    );
}
