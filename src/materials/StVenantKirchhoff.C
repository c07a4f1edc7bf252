/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StVenantKirchhoff.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(StVenantKirchhoff, 0);
    addToRunTimeSelectionTable(solidMaterial, StVenantKirchhoff, entries);

    // Green's strain
    static inline symmTensor strain(const tensor& F)
    {
        return 0.5*(symm(F.T() & F) - symmTensor::I);
    }
}
}

Foam::fsbi::StVenantKirchhoff::StVenantKirchhoff
(
    const checkedDictionary& entries
)
:
    solidMaterial(entries)
{}


Foam::scalar Foam::fsbi::StVenantKirchhoff::shearEnergy(const tensor& F) const
{
    return mu()*magSqr(strain(F));
}


Foam::tensor Foam::fsbi::StVenantKirchhoff::shearStress(const tensor& F) const
{
    return (2*mu())*(F & strain(F));
}


Foam::tensor Foam::fsbi::StVenantKirchhoff::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    return (2*mu())*((dF & strain(F)) + (F & symm(F.T() & dF)));
}


Foam::scalar Foam::fsbi::StVenantKirchhoff::theta(const tensor& F) const
{
    return 0.5*(magSqr(F) - 3);
}


Foam::tensor Foam::fsbi::StVenantKirchhoff::thetaGradient(const tensor& F) const
{
    return F;
}


Foam::tensor Foam::fsbi::StVenantKirchhoff::thetaTangent
(
    const tensor& F, const tensor& dF
) const
{
    return dF;
}


Foam::string Foam::fsbi::StVenantKirchhoff::warning
(
    const scalar minJ, const scalar minStretch
) const
{
    if (minStretch >= 1/Foam::sqrt(3.0))
    {
        return string();
    }
    char text[200];
    snprintf
    (
        text, sizeof(text),
        "StVenantKirchhoff softens in compression below a stretch of 0.577, "
        "and the smallest is %.3g (smallest volume ratio %.3g): the body may "
        "collapse; neoHookean does not soften",
        minStretch, minJ
    );
    return text;
}
