/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientField.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(gradientField, 0);
    addToRunTimeSelectionTable(magneticField, gradientField, entries);
}
}


Foam::fsbi::gradientField::gradientField
(
    const checkedDictionary& entries, const units& u
)
:
    dict_(entries.dict()),
    centre_(entries.get<point>("centre")),
    axis_(Zero),
    length_(1/u.metre())
{
    if (entries.found("components"))
    {
        components_ = function<symmTensor>(entries, "components");
        G(0);
    }
    else
    {
        axis_ = entries.direction("axis");
        axial_ = function<scalar>(entries, "axial");
    }
}


Foam::symmTensor Foam::fsbi::gradientField::G(const scalar t) const
{
    if (axial_)
    {
        return 0.5*axial_->value(t)*(3*sqr(axis_) - symmTensor::I);
    }
    const symmTensor g(components_->value(t));
    if (mag(tr(g)) > 1e-6*mag(g))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'components' at time " << t << " is " << g
            << ", with the trace " << tr(g)
            << ": a magnetic field has no sources, the trace must be zero"
            << exit(FatalIOError);
    }
    return g;
}
