/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "profiles.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

namespace Foam
{
namespace fsbi
{

//- A direction entry, normalised
static vector direction
(
    const checkedDictionary& dict, const word& key, const vector& deflt
)
{
    const vector d(dict.getOrDefault<vector>(key, deflt));
    if (mag(d) < SMALL)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry '" << key << "' has no length" << exit(FatalIOError);
    }
    return d/mag(d);
}


//- A Function1 entry
static autoPtr<Function1<scalar>> functionOfTime
(
    const checkedDictionary& dict, const word& key
)
{
    dict.found(key);
    return Function1<scalar>::New(key, dict.dict());
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::linearShear::linearShear(const checkedDictionary& dict)
:
    rate_(functionOfTime(dict, "shearRate")),
    flow_(direction(dict, "flowDirection", vector(1, 0, 0))),
    gradient_(direction(dict, "gradientDirection", vector(0, 0, 1))),
    origin_(dict.getOrDefault<point>("origin", Zero))
{}


Foam::fsbi::linearShear::linearShear(const linearShear& p)
:
    rate_(p.rate_->clone().ptr()),
    flow_(p.flow_),
    gradient_(p.gradient_),
    origin_(p.origin_)
{}


Foam::vector Foam::fsbi::linearShear::operator()
(
    const point& x, const scalar time
) const
{
    return rate_->value(time)*((x - origin_) & gradient_)*flow_;
}


void Foam::fsbi::linearShear::write(Ostream& os) const
{
    rate_->writeData(os);
    os.writeEntry("flowDirection", flow_);
    os.writeEntry("gradientDirection", gradient_);
    os.writeEntry("origin", origin_);
}


Foam::fsbi::Poiseuille::Poiseuille(const checkedDictionary& dict)
:
    maximum_(functionOfTime(dict, "maxVelocity")),
    halfWidth_(dict.positive("halfWidth")),
    flow_(direction(dict, "flowDirection", vector(1, 0, 0))),
    gradient_(Zero),
    origin_(dict.getOrDefault<point>("origin", Zero))
{
    if (dict.found("gradientDirection"))
    {
        gradient_ = direction(dict, "gradientDirection", Zero);
    }
}


Foam::fsbi::Poiseuille::Poiseuille(const Poiseuille& p)
:
    maximum_(p.maximum_->clone().ptr()),
    halfWidth_(p.halfWidth_),
    flow_(p.flow_),
    gradient_(p.gradient_),
    origin_(p.origin_)
{}


Foam::vector Foam::fsbi::Poiseuille::operator()
(
    const point& x, const scalar time
) const
{
    const vector d(x - origin_);
    const scalar r2 =
        magSqr(gradient_) > 0 ? sqr(d & gradient_) : magSqr(d - flow_*(flow_ & d));
    return maximum_->value(time)*(1 - r2/sqr(halfWidth_))*flow_;
}


void Foam::fsbi::Poiseuille::write(Ostream& os) const
{
    maximum_->writeData(os);
    os.writeEntry("halfWidth", halfWidth_);
    os.writeEntry("flowDirection", flow_);
    if (magSqr(gradient_) > 0)
    {
        os.writeEntry("gradientDirection", gradient_);
    }
    os.writeEntry("origin", origin_);
}


Foam::fsbi::StokesSphere::StokesSphere(const checkedDictionary& dict)
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
typedef profileFvPatchVectorField<Poiseuille> PoiseuilleFvPatchVectorField;
typedef profileFvPatchVectorField<StokesSphere> StokesSphereFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    linearShearFvPatchVectorField, Foam::fsbi::linearShear::name, 0
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
    fvPatchVectorField, PoiseuilleFvPatchVectorField
)
addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, StokesSphereFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
