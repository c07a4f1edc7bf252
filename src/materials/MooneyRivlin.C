/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "MooneyRivlin.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(MooneyRivlin, 0);
    addToRunTimeSelectionTable(solidMaterial, MooneyRivlin, entries);
}
}

Foam::fsbi::MooneyRivlin::MooneyRivlin(const checkedDictionary& entries)
:
    neoHookean(entries),
    share_(entries.getOrDefault<scalar>("share", 0.5))
{
    if (!(share_ >= 0 && share_ <= 1))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'share' must lie in [0, 1], but is " << share_
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::fsbi::MooneyRivlin::shearEnergy(const tensor& F) const
{
    const symmTensor C(symm(F.T() & F));
    const scalar I2 = 0.5*(sqr(tr(C)) - magSqr(C));
    return (1 - share_)*neoHookean::shearEnergy(F)
      + (0.5*share_*mu())*(I2 - 3 - 4*(det(F) - 1));
}


Foam::tensor Foam::fsbi::MooneyRivlin::shearStress(const tensor& F) const
{
    const symmTensor C(symm(F.T() & F));
    const scalar J = det(F);
    return (1 - share_)*neoHookean::shearStress(F)
      + (share_*mu())*(tr(C)*F - (F & C) - (2*J)*inv(F, J).T());
}


Foam::tensor Foam::fsbi::MooneyRivlin::shearTangent
(
    const tensor& F, const tensor& dF
) const
{
    const symmTensor C(symm(F.T() & F));
    const symmTensor dC(twoSymm(F.T() & dF));
    const scalar J = det(F);
    const tensor inverse(inv(F, J));
    const tensor inverseDF(inverse & dF);
    const tensor dCofactor
    (
        J*(tr(inverseDF)*inverse - (inverseDF & inverse)).T()
    );
    return (1 - share_)*neoHookean::shearTangent(F, dF)
      + (share_*mu())
       *(
            tr(dC)*F + tr(C)*dF - (dF & C) - (F & dC) - 2*dCofactor
        );
}
