/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "acceleratedSphere.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

Foam::fsbi::acceleratedSphere::acceleratedSphere
(
    const checkedDictionary& dict, const fvPatch&
)
:
    radius_(dict.positive("radius")),
    centre_(dict.getOrDefault<point>("centre", Zero)),
    farVelocity_(dict.get<vector>("farVelocity")),
    growthRate_(dict.positive("growthRate")),
    kinematicViscosity_(dict.positive("kinematicViscosity"))
{}


Foam::vector Foam::fsbi::acceleratedSphere::operator()
(
    const point& x, const scalar time
) const
{
    const vector d(x - centre_);
    const scalar r = mag(d);
    const vector n(d/r);
    const scalar k = Foam::sqrt(growthRate_/kinematicViscosity_);
    const scalar l = k*radius_;
    const scalar C2 = -1.5*pow3(radius_)/sqr(l);
    const scalar C1 = 0.5*pow3(radius_) - (1 + l)*C2;
    const scalar decay = C2*Foam::exp(l - k*r);
    // F'/r and F''
    const scalar first = -(C1 + decay*(k*r + 1))/pow3(r);
    const scalar second = (2*C1 + decay*(sqr(k*r) + 2*k*r + 2))/pow3(r);
    return Foam::exp(growthRate_*time)
       *(
            farVelocity_*(1 + second + first)
          - (second - first)*(n & farVelocity_)*n
        );
}


void Foam::fsbi::acceleratedSphere::write(Ostream& os) const
{
    os.writeEntry("radius", radius_);
    os.writeEntry("centre", centre_);
    os.writeEntry("farVelocity", farVelocity_);
    os.writeEntry("growthRate", growthRate_);
    os.writeEntry("kinematicViscosity", kinematicViscosity_);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<acceleratedSphere>
    acceleratedSphereFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    acceleratedSphereFvPatchVectorField, Foam::fsbi::acceleratedSphere::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, acceleratedSphereFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
