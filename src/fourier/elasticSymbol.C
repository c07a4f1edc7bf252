/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticSymbol.H"
#include "error.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

static eigenvalueSearch::expansion negative(eigenvalueSearch::expansion K)
{
    K.value = -K.value;
    for (symmTensor& slope : K.slope)
    {
        slope = -slope;
    }
    return K;
}


// Component of the mixed derivative of i and j in a symmTensor
static direction place(const direction i, const direction j)
{
    return i + j == 1 ? symmTensor::XY
         : i + j == 2 ? symmTensor::XZ
         : symmTensor::YZ;
}

} // End namespace fsbi
} // End namespace Foam


static const Foam::direction diagonalPlace[] =
    {Foam::symmTensor::XX, Foam::symmTensor::YY, Foam::symmTensor::ZZ};


Foam::fsbi::elasticSymbol::elasticSymbol
(
    const scalar E, const scalar nu, const vector& spacing
)
:
    mixed_(Zero)
{
    if (!(E > 0 && nu > -1 && nu < 0.5 && cmptMin(spacing) > 0))
    {
        FatalErrorInFunction
            << "Linear elasticity needs E > 0, -1 < nu < 0.5 and a spacing"
            << " above zero, but E is " << E << ", nu " << nu
            << ", the spacing " << spacing << exit(FatalError);
    }
    const scalar mu = E/(2*(1 + nu));
    const scalar lambda = E*nu/((1 + nu)*(1 - 2*nu));
    for (direction i = 0; i < 3; ++i)
    {
        scalar sum = 0;
        for (direction j = 0; j < 3; ++j)
        {
            along_(i, j) = (i == j ? 2*mu + lambda : mu)/sqr(spacing[j]);
            sum += along_(i, j);
        }
        for (direction j = 0; j < 3; ++j)
        {
            along_(i, j) /= sum;
        }
        diagonal_[i] = 2*sum;
    }
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            mixed_(i, j) = i == j ? 0 :
                (mu + lambda)
               /(spacing[i]*spacing[j]*sqrt(diagonal_[i]*diagonal_[j]));
        }
    }
}


Foam::fsbi::eigenvalueSearch::expansion Foam::fsbi::elasticSymbol::expand
(
    const vector& phi
) const
{
    eigenvalueSearch::expansion K{Zero, FixedList<symmTensor, 3>(Zero)};
    vector s, c;
    for (direction i = 0; i < 3; ++i)
    {
        s[i] = sin(phi[i]);
        c[i] = cos(phi[i]);
    }
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            // without the loss of digits of 1 - cos
            K.value[diagonalPlace[i]] += along_(i, j)*2*sqr(sin(phi[j]/2));
            K.slope[j][diagonalPlace[i]] += along_(i, j)*s[j];
        }
        for (direction j = 0; j < i; ++j)
        {
            K.value[place(i, j)] = mixed_(i, j)*s[i]*s[j];
            K.slope[i][place(i, j)] = mixed_(i, j)*c[i]*s[j];
            K.slope[j][place(i, j)] = mixed_(i, j)*s[i]*c[j];
        }
    }
    return K;
}


Foam::scalar Foam::fsbi::elasticSymbol::remainder(const vector& half) const
{
    scalar largest = 0;     // sum of a row: above the norm
    for (direction i = 0; i < 3; ++i)
    {
        scalar row = 0;
        for (direction j = 0; j < 3; ++j)
        {
            row +=
                along_(i, j)*sqr(half[j])/2
              + mixed_(i, j)*sqr(half[i] + half[j])/2;
        }
        largest = max(largest, row);
    }
    return largest;
}


Foam::symmTensor Foam::fsbi::elasticSymbol::scaled(const vector& phi) const
{
    return expand(phi).value;
}


Foam::tensor Foam::fsbi::elasticSymbol::step
(
    const vector& phi, const scalar factor
) const
{
    const symmTensor K = scaled(phi);
    tensor G;
    for (direction i = 0; i < 3; ++i)
    {
        for (direction j = 0; j < 3; ++j)
        {
            G(i, j) =
                i == j
              ? 1 - factor*K[diagonalPlace[i]]
              : -factor*K[place(i, j)]*sqrt(diagonal_[j]/diagonal_[i]);
        }
    }
    return G;
}


Foam::fsbi::eigenvalueRange Foam::fsbi::elasticSymbol::range
(
    const scalar phiMin, const bool zeroComponents
) const
{
    const auto rest = [this](const vector& half) { return remainder(half); };
    eigenvalueSearch highest
    (
        [this](const vector& phi) { return expand(phi); }, rest
    );
    eigenvalueSearch lowest
    (
        [this](const vector& phi) { return negative(expand(phi)); }, rest
    );
    const scalar pi = constant::mathematical::pi;
    for (label axes = zeroComponents ? 1 : 7; axes < 8; ++axes)
    {
        boundBox waves(Zero, Zero);
        for (direction i = 0; i < 3; ++i)
        {
            const bool present = axes >> i & 1;
            waves.min()[i] = present ? phiMin : 0;
            waves.max()[i] = present ? pi : 0;
        }
        highest.search(waves);
        lowest.search(waves);
    }
    return
    {
        -lowest.largest(), highest.largest(),
        max(lowest.uncertainty(), highest.uncertainty())
    };
}
