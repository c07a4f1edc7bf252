/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neoHookean.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(neoHookean, 0);
    addToRunTimeSelectionTable(solidMaterial, neoHookean, entries);
}
}

Foam::fsbi::neoHookean::neoHookean(const checkedDictionary& entries)
:
    solidMaterial(entries)
{}


Foam::fsbi::neoHookean::neoHookean(const scalar density)
:
    solidMaterial(density)
{}


Foam::scalar Foam::fsbi::neoHookean::shearEnergy(const tensor& F) const
{
    return mu()*(0.5*(magSqr(F) - 3) - Foam::log(det(F)));
}


Foam::tensor Foam::fsbi::neoHookean::shearStress(const tensor& F) const
{
    return mu()*(F - inv(F).T());
}


Foam::tensor Foam::fsbi::neoHookean::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    return mu()*(dF - neoHookean::thetaTangent(F, dF));
}


Foam::scalar Foam::fsbi::neoHookean::theta(const tensor& F) const
{
    return Foam::log(det(F));
}


Foam::tensor Foam::fsbi::neoHookean::thetaGradient(const tensor& F) const
{
    return inv(F).T();
}


Foam::tensor Foam::fsbi::neoHookean::thetaTangent
(
    const tensor& F, const tensor& dF
) const
{
    const tensor inverse(inv(F));
    return -(inverse & dF & inverse).T();
}
