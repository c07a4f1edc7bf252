/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "traction.H"
#include "loadFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

Foam::fsbi::traction::traction(const checkedDictionary& dict, const fvPatch&)
:
    dead_(functionOfTime<vector>::optional(dict, "traction")),
    pressure_(functionOfTime<scalar>::optional(dict, "pressure")),
    follower_(functionOfTime<vector>::optional(dict, "follower")),
    resistance_(dict.found("resistance") ? dict.positive("resistance") : 0)
{}


Foam::tmp<Foam::vectorField> Foam::fsbi::traction::dead
(
    const fvPatch& patch, const scalar time
) const
{
    return tmp<vectorField>::New(patch.size(), dead_.value(time));
}


Foam::tmp<Foam::scalarField> Foam::fsbi::traction::pressure
(
    const fvPatch& patch, const scalar time
) const
{
    return tmp<scalarField>::New(patch.size(), pressure_.value(time));
}


Foam::tmp<Foam::vectorField> Foam::fsbi::traction::follower
(
    const fvPatch& patch, const scalar time
) const
{
    return tmp<vectorField>::New(patch.size(), follower_.value(time));
}


void Foam::fsbi::traction::write(Ostream& os) const
{
    dead_.write(os);
    pressure_.write(os);
    follower_.write(os);
    if (resistance_)
    {
        os.writeEntry("resistance", resistance_);
    }
}


namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(tractionCondition, 0);

typedef loadFvPatchVectorField<traction> tractionFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    tractionFvPatchVectorField, Foam::fsbi::traction::name, 0
);

addToPatchFieldRunTimeSelection(fvPatchVectorField, tractionFvPatchVectorField)

} // End namespace fsbi
} // End namespace Foam
