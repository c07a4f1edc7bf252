/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearElastic.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(linearElastic, 0);
    addToRunTimeSelectionTable(solidMaterial, linearElastic, entries);
}
}

Foam::fsbi::linearElastic::linearElastic(const checkedDictionary& entries)
:
    solidMaterial(entries)
{}


Foam::scalar Foam::fsbi::linearElastic::shearEnergy(const tensor& F) const
{
    return mu()*magSqr(symm(F) - symmTensor::I);
}


Foam::tensor Foam::fsbi::linearElastic::shearStress(const tensor& F) const
{
    return (2*mu())*(symm(F) - symmTensor::I);
}


Foam::tensor Foam::fsbi::linearElastic::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    return (2*mu())*symm(dF);
}


Foam::scalar Foam::fsbi::linearElastic::theta(const tensor& F) const
{
    return tr(F) - 3;
}


Foam::tensor Foam::fsbi::linearElastic::thetaGradient(const tensor& F) const
{
    return tensor::I;
}


Foam::tensor Foam::fsbi::linearElastic::thetaTangent
(
    const tensor& F, const tensor& dF
) const
{
    return tensor::zero;
}


Foam::tensor Foam::fsbi::linearElastic::viscousStress
(
    const tensor& F, const tensor& Fdot
) const
{
    return (2*viscosity())*symm(Fdot);
}


Foam::tensor Foam::fsbi::linearElastic::viscousTangent
(
    const tensor& F,
    const tensor& Fdot,
    const tensor& dF,
    const tensor& dFdot
) const
{
    return (2*viscosity())*symm(dFdot);
}


Foam::string Foam::fsbi::linearElastic::warning
(
    const scalar minJ, const scalar minStretch
) const
{
    if (smallStrain(minJ, minStretch))
    {
        return string();
    }
    char text[300];
    snprintf
    (
        text, sizeof(text),
        "linearElastic is for strains and rotations of a few per cent, and the "
        "smallest stretch is %.3g, the smallest volume ratio %.3g: take "
        "corotationalElastic if the body turns, neoHookean if it strains",
        minStretch, minJ
    );
    return text;
}
