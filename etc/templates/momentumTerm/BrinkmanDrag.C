/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrinkmanDrag.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(BrinkmanDrag, 0);
addToRunTimeSelectionTable(momentumTerm, BrinkmanDrag, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::BrinkmanDrag::BrinkmanDrag
(
    const fvMesh& mesh, const dictionary& dict
)
:
    momentumTerm(mesh)
{
    const checkedDictionary entries(dict);
    resistivity_ = entries.positive("resistivity");
    box_ = entries.get<boundBox>("box");
    entries.finish();
    if (!box_.valid())
    {
        FatalIOErrorInFunction(dict)
            << "The box of BrinkmanDrag has min " << box_.min() << " above max "
            << box_.max() << exit(FatalIOError);
    }
}


void Foam::fsbi::BrinkmanDrag::update()
{
    rate_ = resistivity_*mesh_.cellVolumes();
    forAll(rate_, i)
    {
        if (!box_.contains(mesh_.cellCentres()[i]))
        {
            rate_[i] = 0;
        }
    }
}


void Foam::fsbi::BrinkmanDrag::addJacobian(const scalar* dx, scalar* dr) const
{
    forAll(rate_, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            dr[4*i + k] += rate_[i]*dx[4*i + k];
        }
    }
}


void Foam::fsbi::BrinkmanDrag::addResidual(const scalar* x, scalar* r) const
{
    addJacobian(x, r);
}


void Foam::fsbi::BrinkmanDrag::addMassRate(scalarField& rate) const
{
    rate += rate_;
}
