/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tractionFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "volFields.H"

Foam::fsbi::tractionFvPatchVectorField::tractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF)
{}


Foam::fsbi::tractionFvPatchVectorField::tractionFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false)
{
    const checkedDictionary entries(dict);
    for (const word common : {"type", "patchType", "value"})
    {
        entries.found(common);
    }
    if (entries.found("pressure"))
    {
        pressure_ = Function1<scalar>::New("pressure", dict);
    }
    if (entries.found("traction"))
    {
        traction_ = Function1<vector>::New("traction", dict);
    }
    entries.finish();
    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        fvPatchVectorField::operator=(vector::zero);
    }
}


Foam::fsbi::tractionFvPatchVectorField::tractionFvPatchVectorField
(
    const tractionFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    pressure_(ptf.pressure_ ? ptf.pressure_->clone().ptr() : nullptr),
    traction_(ptf.traction_ ? ptf.traction_->clone().ptr() : nullptr)
{}


Foam::fsbi::tractionFvPatchVectorField::tractionFvPatchVectorField
(
    const tractionFvPatchVectorField& ptf
)
:
    tractionFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::fsbi::tractionFvPatchVectorField::tractionFvPatchVectorField
(
    const tractionFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    pressure_(ptf.pressure_ ? ptf.pressure_->clone().ptr() : nullptr),
    traction_(ptf.traction_ ? ptf.traction_->clone().ptr() : nullptr)
{}


Foam::tmp<Foam::vectorField>
Foam::fsbi::tractionFvPatchVectorField::traction() const
{
    const scalar time = db().time().value();
    auto t = tmp<vectorField>::New(size(), Zero);
    if (traction_)
    {
        t.ref() += traction_->value(time);
    }
    if (pressure_)
    {
        t.ref() -= pressure_->value(time)*patch().nf();
    }
    return t;
}


void Foam::fsbi::tractionFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    if (pressure_)
    {
        pressure_->writeData(os);
    }
    if (traction_)
    {
        traction_->writeData(os);
    }
    writeEntry("value", os);
}


namespace Foam
{
namespace fsbi
{

makePatchTypeField(fvPatchVectorField, tractionFvPatchVectorField);

} // End namespace fsbi
} // End namespace Foam
