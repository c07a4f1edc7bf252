/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "manufactured.H"
#include "linearElastic.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(manufactured, 0);
    addToRunTimeSelectionTable(exactSolution, manufactured, entries);

    //- Order of one derivative in direction d
    static labelVector along(const direction d)
    {
        labelVector orders(Zero);
        orders[d] = 1;
        return orders;
    }
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::manufactured::manufactured
(
    const checkedDictionary& entries, const dictionary& material
)
:
    exactSolution(entries, material),
    amplitude_(entries, "amplitude"),
    length_(entries.found("length") ? entries.positive("length") : 1)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsbi::manufactured::derivative
(
    const point& X, const labelVector& orders
) const
{
    // component i is a product of sines of waves X_j + phase pi/2
    constexpr label waves[3][3] = {{2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
    constexpr label phase[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    const vector x(pi/length_*local(X));
    vector u(vector::one);
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            u[i] *= Foam::pow(waves[i][j]*pi/length_, orders[j])
               *Foam::sin(waves[i][j]*x[j] + (phase[i][j] + orders[j])*pi/2);
        }
    }
    return u;
}


Foam::tensor Foam::fsbi::manufactured::F
(
    const point& X, const scalar time
) const
{
    const scalar A = amplitude_.value(time);
    tensor result(I);
    for (direction J = 0; J < 3; ++J)
    {
        result.col(J, result.col(J) + A*derivative(X, along(J)));
    }
    if (!law().defined(result))
    {
        FatalErrorInFunction
            << "The manufactured solution turns the solid inside out at " << X
            << ", det F = " << det(result) << ": reduce 'amplitude'"
            << exit(FatalError);
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsbi::manufactured::displacement
(
    const point& X, const scalar time
) const
{
    return amplitude_.value(time)*derivative(X, Zero);
}


Foam::tensor Foam::fsbi::manufactured::stress
(
    const point& X, const scalar time
) const
{
    return law().stress(F(X, time));
}


Foam::vector Foam::fsbi::manufactured::bodyForce
(
    const point& X, const scalar time
) const
{
    const scalar A = amplitude_.value(time);
    const tensor here(F(X, time));
    vector b(Zero);
    for (direction J = 0; J < 3; ++J)
    {
        tensor dF(Zero);
        for (direction K = 0; K < 3; ++K)
        {
            dF.col(K, A*derivative(X, along(J) + along(K)));
        }
        b -= law().tangent(here, dF).col(J);
    }
    return b;
}


Foam::symmTensor Foam::fsbi::manufactured::CauchyStress
(
    const point& X, const scalar time
) const
{
    const tensor P(stress(X, time));
    if (isA<linearElastic>(law()))
    {
        return symm(P);
    }
    const tensor f(F(X, time));
    return symm(P & f.T())/det(f);
}
