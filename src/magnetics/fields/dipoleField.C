/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dipoleField.H"
#include "dipole.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(dipoleField, 0);
    addToRunTimeSelectionTable(magneticField, dipoleField, entries);
}
}


Foam::vector Foam::fsbi::dipoleField::B
(
    const point& x, const scalar t
) const
{
    return dipoleB(moment_->value(t), length_*(x - position_->value(t)));
}


Foam::tensor Foam::fsbi::dipoleField::gradient
(
    const point& x, const scalar t
) const
{
    return
        length_
       *dipoleGradient(moment_->value(t), length_*(x - position_->value(t)));
}
