/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchForce.H"
#include "loadFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"

Foam::fsbi::patchForce::patchForce
(
    const checkedDictionary& dict, const fvPatch&
)
:
    force_(dict, "force"),
    radius_(0),
    centre_(Zero)
{
    // either without the other is a mistake
    if (dict.found("centre") || dict.found("radius"))
    {
        centre_ = dict.get<point>("centre");
        radius_ = dict.positive("radius");
    }
}


Foam::tmp<Foam::scalarField> Foam::fsbi::patchForce::weights
(
    const fvPatch& patch
) const
{
    auto w = tmp<scalarField>::New(patch.size(), 1.0);
    if (radius_ > 0)
    {
        w.ref() = sqr
        (
            max(1 - magSqr(patch.Cf() - centre_)/sqr(radius_), scalar(0))
        );
    }
    return w;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::patchForce::dead
(
    const fvPatch& patch, const scalar time
) const
{
    const scalarField w(weights(patch));
    const scalar area = gSum(w*patch.magSf());
    if (!(area > 0))
    {
        FatalErrorInFunction
            << "patchForce finds no face of patch " << patch.name()
            << " within 'radius' " << radius_ << " of 'centre' " << centre_
            << "; the nearest face centre is "
            << Foam::sqrt(gMin(magSqr(patch.Cf() - centre_)))
            << " away" << exit(FatalError);
    }
    return force_.value(time)/area*w;
}


void Foam::fsbi::patchForce::write(Ostream& os) const
{
    force_.write(os);
    if (radius_ > 0)
    {
        os.writeEntry("centre", centre_);
        os.writeEntry("radius", radius_);
    }
}


namespace Foam
{
namespace fsbi
{

typedef loadFvPatchVectorField<patchForce> patchForceFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    patchForceFvPatchVectorField, Foam::fsbi::patchForce::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, patchForceFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
