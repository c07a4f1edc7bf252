/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prescribedRotation.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"
#include "volFields.H"

Foam::fsbi::prescribedRotation::prescribedRotation
(
    const checkedDictionary& dict, const fvPatch&
)
:
    axis_(dict.direction("axis")),
    angle_(dict, "angle"),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    translation_(functionOfTime<vector>::optional(dict, "translation"))
{}


Foam::vector Foam::fsbi::prescribedRotation::operator()
(
    const point& x, const scalar time
) const
{
    // Rodrigues, in the form that loses no digits at small angles
    const scalar angle = degToRad(angle_.value(time));
    const vector across(axis_ ^ (x - origin_));
    return Foam::sin(angle)*across
      + 2*sqr(Foam::sin(angle/2))*(axis_ ^ across)
      + translation_.value(time);
}


void Foam::fsbi::prescribedRotation::write(Ostream& os) const
{
    os.writeEntry("axis", axis_);
    angle_.write(os);
    os.writeEntry("origin", origin_);
    translation_.write(os);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<prescribedRotation>
    prescribedRotationFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    prescribedRotationFvPatchVectorField,
    Foam::fsbi::prescribedRotation::name,
    0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, prescribedRotationFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
