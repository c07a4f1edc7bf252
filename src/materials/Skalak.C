/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Skalak.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Skalak, 0);
    addToRunTimeSelectionTable(membraneLaw, Skalak, entries);
}
}


Foam::fsbi::Skalak::Skalak(const checkedDictionary& entries)
:
    G_(entries.positive("shearModulus")),
    C_(0.5*(entries.positive("areaModulus")/G_ - 1))
{}


Foam::fsbi::membraneLaw::energy Foam::fsbi::Skalak::at
(
    const scalar T, const scalar d
) const
{
    energy e;
    const scalar I1 = T - 2, I2 = d - 1;
    e.W = 0.25*G_*(sqr(I1) + 2*I1 - 2*I2 + C_*sqr(I2));
    e.T = 0.5*G_*(I1 + 1);
    e.d = 0.5*G_*(C_*I2 - 1);
    e.TT = 0.5*G_;
    e.dd = 0.5*G_*C_;
    return e;
}
