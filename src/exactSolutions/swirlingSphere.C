/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "swirlingSphere.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

Foam::fsbi::swirlingSphere::swirlingSphere
(
    const checkedDictionary& dict, const fvPatch&
)
:
    radius_(dict.positive("radius")),
    centre_(dict.getOrDefault<point>("centre", Zero)),
    axis_(dict.direction("axis")),
    swirl_(dict.get<scalar>("swirl")),
    spin_(dict.get<scalar>("spin")),
    growthRate_(dict.positive("growthRate")),
    kinematicViscosity_(dict.positive("kinematicViscosity"))
{}


Foam::scalar Foam::fsbi::swirlingSphere::angularVelocity(const scalar r) const
{
    const scalar k = Foam::sqrt(growthRate_/kinematicViscosity_);
    const auto P = [](const scalar x)
    {
        return 3*(x*Foam::cosh(x) - Foam::sinh(x))/pow3(x);
    };
    const auto Q = [](const scalar x)
    {
        return (1 + x)*Foam::exp(-x)/pow3(x);
    };
    return
        swirl_*P(k*r) + (spin_ - swirl_*P(k*radius_))*Q(k*r)/Q(k*radius_);
}


Foam::vector Foam::fsbi::swirlingSphere::operator()
(
    const point& x, const scalar time
) const
{
    const vector d(x - centre_);
    return Foam::exp(growthRate_*time)*angularVelocity(mag(d))*(axis_ ^ d);
}


void Foam::fsbi::swirlingSphere::write(Ostream& os) const
{
    os.writeEntry("radius", radius_);
    os.writeEntry("centre", centre_);
    os.writeEntry("axis", axis_);
    os.writeEntry("swirl", swirl_);
    os.writeEntry("spin", spin_);
    os.writeEntry("growthRate", growthRate_);
    os.writeEntry("kinematicViscosity", kinematicViscosity_);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<swirlingSphere>
    swirlingSphereFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    swirlingSphereFvPatchVectorField, Foam::fsbi::swirlingSphere::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, swirlingSphereFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
