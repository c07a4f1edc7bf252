/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "corotationalElastic.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(corotationalElastic, 0);
    addToRunTimeSelectionTable(solidMaterial, corotationalElastic, entries);

    //- Last change of R: the iteration squares it, to below round-off
    static const scalar squaresToRoundOff = 1e-8;

    //- Enough for stretches of 1e-12 and 1e12, far beyond what the law is for
    static const label maxIterations = 60;
}
}

Foam::fsbi::corotationalElastic::corotationalElastic
(
    const checkedDictionary& entries
)
:
    solidMaterial(entries)
{}


Foam::tensor Foam::fsbi::corotationalElastic::rotation(const tensor& F)
{
    tensor R(F);
    for (label i = 0; i < maxIterations; ++i)
    {
        const tensor next(0.5*(R + inv(R).T()));
        const scalar change = magSqr(next - R);
        R = next;
        if (change < sqr(squaresToRoundOff))
        {
            break;
        }
    }
    return R;
}


Foam::tensor Foam::fsbi::corotationalElastic::rotationTangent
(
    const tensor& F, const tensor& R, const tensor& dF
)
{
    const symmTensor U(symm(R.T() & F));
    const tensor A(R.T() & dF);
    const vector w
    (
        inv(tr(U)*symmTensor::I - U)
      & vector(A.zy() - A.yz(), A.xz() - A.zx(), A.yx() - A.xy())
    );
    return R & tensor(0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0);
}


Foam::scalar Foam::fsbi::corotationalElastic::shearEnergy
(
    const tensor& F
) const
{
    return mu()*magSqr(F - rotation(F));
}


Foam::tensor Foam::fsbi::corotationalElastic::shearStress
(
    const tensor& F
) const
{
    return (2*mu())*(F - rotation(F));
}


Foam::tensor Foam::fsbi::corotationalElastic::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    return (2*mu())*(dF - rotationTangent(F, rotation(F), dF));
}


Foam::scalar Foam::fsbi::corotationalElastic::theta(const tensor& F) const
{
    return (rotation(F) && F) - 3;
}


Foam::tensor Foam::fsbi::corotationalElastic::thetaGradient
(
    const tensor& F
) const
{
    return rotation(F);
}


Foam::tensor Foam::fsbi::corotationalElastic::thetaTangent
(
    const tensor& F, const tensor& dF
) const
{
    return rotationTangent(F, rotation(F), dF);
}


Foam::tensor Foam::fsbi::corotationalElastic::tangent
(
    const tensor& F, const tensor& dF
) const
{
    const tensor R(rotation(F));
    const tensor dR(rotationTangent(F, R, dF));
    return
        (2*mu())*(dF - dR)
      + lambda()*(((R && dF)*R) + (((R && F) - 3)*dR));
}


Foam::string Foam::fsbi::corotationalElastic::warning
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
        "corotationalElastic turns with the body, but is for strains of a few "
        "per cent, and the smallest stretch is %.3g, the smallest volume ratio "
        "%.3g: take neoHookean",
        minStretch, minJ
    );
    return text;
}
