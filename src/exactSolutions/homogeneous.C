/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "homogeneous.H"
#include "linearElastic.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(homogeneous, 0);
    addToRunTimeSelectionTable(exactSolution, homogeneous, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::homogeneous::homogeneous
(
    const checkedDictionary& entries, const dictionary& material
)
:
    exactSolution(entries, material),
    deformation_(entries, "deformation")
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::fsbi::homogeneous::F(const scalar time) const
{
    const tensor result(deformation_.value(time));
    if (!law().defined(result))
    {
        FatalErrorInFunction
            << "'deformation' turns the solid inside out at time " << time
            << ", det F = " << det(result) << exit(FatalError);
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsbi::homogeneous::displacement
(
    const point& X, const scalar time
) const
{
    return (F(time) - I) & local(X);
}


Foam::tensor Foam::fsbi::homogeneous::stress
(
    const point&, const scalar time
) const
{
    return law().stress(F(time));
}


Foam::vector Foam::fsbi::homogeneous::bodyForce
(
    const point&, const scalar
) const
{
    return Zero;
}


Foam::symmTensor Foam::fsbi::homogeneous::CauchyStress
(
    const point& X, const scalar time
) const
{
    const tensor P(stress(X, time));
    const tensor f(F(time));
    return isA<linearElastic>(law()) ? symm(P) : symm(P & f.T())/det(f);
}
