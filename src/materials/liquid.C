/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquid.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(liquid, 0);
    addToRunTimeSelectionTable(solidMaterial, liquid, entries);
}
}


Foam::fsbi::liquid::liquid(const checkedDictionary& entries)
:
    neoHookean(densityOf(entries)),
    viscosity_(entries.positive("viscosity"))
{}


Foam::tensor Foam::fsbi::liquid::flowStress
(
    const tensor& F, const symmTensor& rate
) const
{
    const tensor inverse(inv(F));
    return viscosity_*det(F)*(inverse.T() & rate & inverse & inverse.T());
}


Foam::tensor Foam::fsbi::liquid::flowTangent
(
    const tensor& F,
    const symmTensor& rate,
    const tensor& dF,
    const symmTensor& dRate
) const
{
    // with L = dF F^-1: d(F^-1) = -F^-1 L, and P = eta J F^-T rate F^-1 F^-T
    const tensor inverse(inv(F));
    const tensor L(dF & inverse);
    const tensor D(inverse.T() & rate & inverse);
    const tensor dD((inverse.T() & dRate & inverse) - (L.T() & D) - (D & L));
    return
        viscosity_*det(F)
       *((tr(L)*D + dD - (D & L.T())) & inverse.T());
}
