/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "beamSelfWeight.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(beamSelfWeight, 0);
    addToRunTimeSelectionTable(exactSolution, beamSelfWeight, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::beamSelfWeight::beamSelfWeight
(
    const checkedDictionary& entries, const dictionary& material
)
:
    exactSolution(entries, material),
    length_(entries.positive("length")),
    bodyForce_(entries, "bodyForce")
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsbi::beamSelfWeight::displacement
(
    const point& X, const scalar time
) const
{
    const vector x(local(X));
    const scalar nu = law().nu();
    return bodyForce_.value(time)/law().E()*vector
    (
        -nu*(length_ - x.z())*x.x(),
        -nu*(length_ - x.z())*x.y(),
        (length_ - x.z()/2)*x.z() - nu/2*(sqr(x.x()) + sqr(x.y()))
    );
}


Foam::tensor Foam::fsbi::beamSelfWeight::stress
(
    const point& X, const scalar time
) const
{
    tensor sigma(Zero);
    sigma.zz() = bodyForce_.value(time)*(length_ - local(X).z());
    return sigma;
}


Foam::vector Foam::fsbi::beamSelfWeight::bodyForce
(
    const point&, const scalar time
) const
{
    return vector(0, 0, bodyForce_.value(time));
}
