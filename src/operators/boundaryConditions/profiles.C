/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "profiles.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

Foam::fsbi::linearShear::linearShear
(
    const checkedDictionary& dict, const fvPatch&
)
:
    rate_(dict, "shearRate"),
    flow_(dict.direction("flowDirection", vector(1, 0, 0))),
    gradient_(dict.direction("gradientDirection", vector(0, 0, 1))),
    origin_(dict.getOrDefault<point>("origin", Zero))
{}


Foam::vector Foam::fsbi::linearShear::operator()
(
    const point& x, const scalar time
) const
{
    return rate_.value(time)*((x - origin_) & gradient_)*flow_;
}


void Foam::fsbi::linearShear::write(Ostream& os) const
{
    rate_.write(os);
    os.writeEntry("flowDirection", flow_);
    os.writeEntry("gradientDirection", gradient_);
    os.writeEntry("origin", origin_);
}


Foam::fsbi::linearFlow::linearFlow
(
    const checkedDictionary& dict, const fvPatch&
)
:
    rate_(dict, "rate"),
    gradient_(dict.get<tensor>("gradient")),
    origin_(dict.getOrDefault<point>("origin", Zero))
{
    if (mag(tr(gradient_)) > 1e-6*mag(gradient_))
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry 'gradient' is that of a flow that keeps its volume,"
            << " xx + yy + zz = 0, but is " << gradient_
            << ", of which that is " << tr(gradient_) << exit(FatalIOError);
    }
}


Foam::vector Foam::fsbi::linearFlow::operator()
(
    const point& x, const scalar time
) const
{
    return rate_.value(time)*(gradient_ & (x - origin_));
}


void Foam::fsbi::linearFlow::write(Ostream& os) const
{
    rate_.write(os);
    os.writeEntry("gradient", gradient_);
    os.writeEntry("origin", origin_);
}


Foam::fsbi::Poiseuille::Poiseuille
(
    const checkedDictionary& dict, const fvPatch&
)
:
    maximum_(dict, "maxVelocity"),
    halfWidth_(dict.positive("halfWidth")),
    flow_(dict.direction("flowDirection", vector(1, 0, 0))),
    gradient_(Zero),
    origin_(dict.getOrDefault<point>("origin", Zero))
{
    if (dict.found("gradientDirection"))
    {
        gradient_ = dict.direction("gradientDirection");
    }
}


Foam::vector Foam::fsbi::Poiseuille::operator()
(
    const point& x, const scalar time
) const
{
    const vector d(x - origin_);
    const scalar r2 =
        magSqr(gradient_) > 0 ? sqr(d & gradient_) : magSqr(d - flow_*(flow_ & d));
    return maximum_.value(time)*(1 - r2/sqr(halfWidth_))*flow_;
}


void Foam::fsbi::Poiseuille::write(Ostream& os) const
{
    maximum_.write(os);
    os.writeEntry("halfWidth", halfWidth_);
    os.writeEntry("flowDirection", flow_);
    if (magSqr(gradient_) > 0)
    {
        os.writeEntry("gradientDirection", gradient_);
    }
    os.writeEntry("origin", origin_);
}


Foam::fsbi::StokesSphere::StokesSphere
(
    const checkedDictionary& dict, const fvPatch&
)
:
    radius_(dict.positive("radius")),
    centre_(dict.getOrDefault<point>("centre", Zero)),
    sphereVelocity_(dict.getOrDefault<vector>("sphereVelocity", Zero)),
    farVelocity_(dict.getOrDefault<vector>("farVelocity", Zero))
{}


Foam::vector Foam::fsbi::StokesSphere::operator()
(
    const point& x, const scalar
) const
{
    const vector d(x - centre_);
    const scalar s = radius_/mag(d);
    const vector n(d/mag(d));
    const vector V(sphereVelocity_ - farVelocity_);
    return farVelocity_
      + 0.75*s*(V + (V & n)*n) + 0.25*pow3(s)*(V - 3*(V & n)*n);
}


void Foam::fsbi::StokesSphere::write(Ostream& os) const
{
    os.writeEntry("radius", radius_);
    os.writeEntry("centre", centre_);
    os.writeEntry("sphereVelocity", sphereVelocity_);
    os.writeEntry("farVelocity", farVelocity_);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<linearShear> linearShearFvPatchVectorField;
typedef profileFvPatchVectorField<linearFlow> linearFlowFvPatchVectorField;
typedef profileFvPatchVectorField<Poiseuille> PoiseuilleFvPatchVectorField;
typedef profileFvPatchVectorField<StokesSphere> StokesSphereFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    linearShearFvPatchVectorField, Foam::fsbi::linearShear::name, 0
);
defineTemplateTypeNameAndDebugWithName
(
    linearFlowFvPatchVectorField, Foam::fsbi::linearFlow::name, 0
);
defineTemplateTypeNameAndDebugWithName
(
    PoiseuilleFvPatchVectorField, Foam::fsbi::Poiseuille::name, 0
);
defineTemplateTypeNameAndDebugWithName
(
    StokesSphereFvPatchVectorField, Foam::fsbi::StokesSphere::name, 0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, linearShearFvPatchVectorField
)
addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, linearFlowFvPatchVectorField
)
addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, PoiseuilleFvPatchVectorField
)
addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, StokesSphereFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
