/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplaceSymbol.H"

Foam::fsbi::laplaceSymbol::laplaceSymbol(const vector& spacing)
{
    for (direction i = 0; i < 3; ++i)
    {
        weights_[i] = spacing[i] > 0 ? 1/sqr(spacing[i]) : 0;
    }
    weights_ /= cmptSum(weights_);
}


Foam::symmTensor Foam::fsbi::laplaceSymbol::scaled(const vector& phi) const
{
    scalar kappa = 0;
    for (direction i = 0; i < 3; ++i)
    {
        kappa += 2*weights_[i]*sqr(sin(phi[i]/2));
    }
    return kappa*symmTensor::I;
}


Foam::fsbi::eigenvalueRange Foam::fsbi::laplaceSymbol::range
(
    const scalar phiMin, const bool zeroComponents
) const
{
    scalar weight = 1;      // every direction grows with its component
    for (direction i = 0; zeroComponents && i < 3; ++i)
    {
        weight = weights_[i] > 0 ? min(weight, weights_[i]) : weight;
    }
    return {2*weight*sqr(sin(phiMin/2)), 2};
}
