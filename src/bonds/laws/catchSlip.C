/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "catchSlip.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(catchSlip, 0);
    addToRunTimeSelectionTable(bondLaw, catchSlip, entries);
}
}

Foam::fsbi::catchSlip::catchSlip
(
    const checkedDictionary& entries, const scalar kT
)
:
    bondLaw(entries, kT),
    kCatch_(entries.positive("kCatch")),
    xCatch_(entries.positive("xCatch")),
    kSlip_(entries.positive("kSlip")),
    xSlip_(entries.positive("xSlip"))
{}


Foam::scalar Foam::fsbi::catchSlip::logBreaking(const scalar extension) const
{
    const scalar f = s()*mag(extension)/kT();
    const scalar a = Foam::log(kCatch_/k0off()) - f*xCatch_;
    const scalar b = Foam::log(kSlip_/k0off()) + f*xSlip_;
    // the larger one in front, for neither may overflow
    return max(a, b) + Foam::log(1 + Foam::exp(-mag(a - b)));
}
