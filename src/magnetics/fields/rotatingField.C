/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rotatingField.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(rotatingField, 0);
    addToRunTimeSelectionTable(magneticField, rotatingField, entries);
}
}


Foam::fsbi::rotatingField::rotatingField
(
    const checkedDictionary& entries, const units&
)
:
    magnitude_(function<scalar>(entries, "magnitude")),
    frequency_(function<scalar>(entries, "frequency")),
    axis_(entries.direction("axis")),
    start_(entries.direction("start"))
{
    if (mag(axis_ ^ start_) < SMALL)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entries 'axis' and 'start' are parallel: the field would not"
            << " turn" << exit(FatalIOError);
    }
}


Foam::vector Foam::fsbi::rotatingField::B(const point&, const scalar t) const
{
    const scalar turns = frequency_->integrate(0, t);
    const quaternion turned(axis_, constant::mathematical::twoPi*turns);
    return magnitude_->value(t)*turned.transform(start_);
}
