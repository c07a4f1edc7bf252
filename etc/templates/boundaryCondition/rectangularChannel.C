/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rectangularChannel.H"
#include "profileFvPatchVectorField.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

using Foam::constant::mathematical::pi;

// Of the sums. What is left out is below 1/last^2 of the velocity, 1/last^4 of Q
static const Foam::label last = 99;


Foam::fsbi::rectangularChannel::rectangularChannel
(
    const checkedDictionary& dict, const fvPatch&
)
:
    flowRate_(dict, "flowRate"),
    width_(dict.positive("width")),
    height_(dict.positive("height")),
    flow_(dict.direction("flowDirection", vector(1, 0, 0))),
    up_(dict.direction("heightDirection", vector(0, 0, 1))),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    scale_(0)
{
    const scalar ratio = width_/height_;
    scalar sum = 0;
    for (label i = 1; i <= last; i += 2)
    {
        sum += Foam::tanh(0.5*i*pi/ratio)/Foam::pow(scalar(i), 5);
    }
    scale_ = 48/(pow3(pi)*width_*height_*(1 - 192*ratio/Foam::pow(pi, 5)*sum));
}


Foam::scalar Foam::fsbi::rectangularChannel::profile
(
    const scalar y, const scalar z
) const
{
    scalar sum = 0;
    for (label i = 1; i <= last; i += 2)
    {
        // cosh(kz)/cosh(kb), whose parts may be too large for a number
        const scalar k = i*pi/width_;
        const scalar b = 0.5*height_;
        const scalar share =
            (Foam::exp(k*(z - b)) + Foam::exp(-k*(z + b)))/(1 + Foam::exp(-2*k*b));
        const label sign = i % 4 == 1 ? 1 : -1;
        sum += sign*(1 - share)*Foam::cos(k*y)/pow3(scalar(i));
    }
    return sum;
}


Foam::vector Foam::fsbi::rectangularChannel::operator()
(
    const point& x, const scalar time
) const
{
    const vector d(x - origin_);
    return flowRate_.value(time)*scale_*profile(d & (up_ ^ flow_), d & up_)*flow_;
}


void Foam::fsbi::rectangularChannel::write(Ostream& os) const
{
    flowRate_.write(os);
    os.writeEntry("width", width_);
    os.writeEntry("height", height_);
    os.writeEntry("flowDirection", flow_);
    os.writeEntry("heightDirection", up_);
    os.writeEntry("origin", origin_);
}


namespace Foam
{
namespace fsbi
{

typedef profileFvPatchVectorField<rectangularChannel>
    rectangularChannelFvPatchVectorField;

defineTemplateTypeNameAndDebugWithName
(
    rectangularChannelFvPatchVectorField,
    Foam::fsbi::rectangularChannel::name,
    0
);

addToPatchFieldRunTimeSelection
(
    fvPatchVectorField, rectangularChannelFvPatchVectorField
)

} // End namespace fsbi
} // End namespace Foam
