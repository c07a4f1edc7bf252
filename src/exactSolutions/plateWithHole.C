/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plateWithHole.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(plateWithHole, 0);
    addToRunTimeSelectionTable(exactSolution, plateWithHole, entries);

//- Of the radius, that facets of a hole may lie inside of it
static const scalar facetDepth = 0.2;

}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::plateWithHole::plateWithHole
(
    const checkedDictionary& entries, const dictionary& material
)
:
    exactSolution(entries, material),
    radius_(entries.positive("radius")),
    tension_(entries, "tension")
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsbi::plateWithHole::polar(const point& X) const
{
    const vector x(local(X));
    const scalar r = Foam::hypot(x.x(), x.y());
    if (r < (1 - facetDepth)*radius_)
    {
        FatalErrorInFunction
            << "The point " << X << " is in the hole of plateWithHole, radius "
            << radius_ << exit(FatalError);
    }
    return vector(r, x.x()/r, x.y()/r);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsbi::plateWithHole::displacement
(
    const point& X, const scalar time
) const
{
    const vector at(polar(X));
    const scalar r = at.x(), c = at.y(), s = at.z();
    const scalar q = sqr(radius_/r);
    const scalar kappa = 3 - 4*law().nu();
    const scalar size = tension_.value(time)*r/(8*law().mu());
    const scalar ur =
        size*(kappa - 1 + 2*q + 2*(1 + (kappa + 1)*q - q*q)*(c*c - s*s));
    const scalar ut = -2*size*(1 + (kappa - 1)*q + q*q)*2*s*c;
    return vector(c*ur - s*ut, s*ur + c*ut, 0);
}


Foam::tensor Foam::fsbi::plateWithHole::stress
(
    const point& X, const scalar time
) const
{
    const vector at(polar(X));
    const scalar c = at.y(), s = at.z();
    const scalar q = sqr(radius_/at.x());
    const scalar half = tension_.value(time)/2;
    const scalar cos2 = c*c - s*s, sin2 = 2*s*c;
    const scalar rr = half*(1 - q + (1 - 4*q + 3*q*q)*cos2);
    const scalar tt = half*(1 + q - (1 + 3*q*q)*cos2);
    const scalar rt = -half*(1 + 2*q - 3*q*q)*sin2;
    const tensor turn(c, -s, 0, s, c, 0, 0, 0, 1);
    const tensor sigma(rr, rt, 0, rt, tt, 0, 0, 0, law().nu()*(rr + tt));
    return turn & sigma & turn.T();
}


Foam::vector Foam::fsbi::plateWithHole::bodyForce
(
    const point&, const scalar
) const
{
    return Zero;
}
