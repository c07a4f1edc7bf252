/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Gent.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Gent, 0);
    addToRunTimeSelectionTable(solidMaterial, Gent, entries);
}
}

Foam::fsbi::Gent::Gent(const checkedDictionary& entries)
:
    neoHookean(entries),
    Jm_(entries.positive("Jm"))
{}


Foam::scalar Foam::fsbi::Gent::stiffening(const tensor& F) const
{
    return Jm_/(Jm_ - magSqr(F) + 3);
}


Foam::scalar Foam::fsbi::Gent::shearEnergy(const tensor& F) const
{
    return mu()*(0.5*Jm_*Foam::log(stiffening(F)) - Foam::log(det(F)));
}


Foam::tensor Foam::fsbi::Gent::shearStress(const tensor& F) const
{
    return mu()*(stiffening(F)*F - inv(F).T());
}


Foam::tensor Foam::fsbi::Gent::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    const scalar s = stiffening(F);
    return mu()*(s*dF + (2*sqr(s)/Jm_*(F && dF))*F - thetaTangent(F, dF));
}


bool Foam::fsbi::Gent::defined(const tensor& F) const
{
    return neoHookean::defined(F) && magSqr(F) - 3 < Jm_;
}
