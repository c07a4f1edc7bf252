/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neoHookeanMembrane.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(neoHookeanMembrane, 0);
    addToRunTimeSelectionTable(membraneLaw, neoHookeanMembrane, entries);
}
}


Foam::fsbi::neoHookeanMembrane::neoHookeanMembrane(const checkedDictionary& entries)
:
    G_(entries.positive("shearModulus"))
{}


Foam::fsbi::membraneLaw::energy Foam::fsbi::neoHookeanMembrane::at
(
    const scalar T, const scalar d
) const
{
    energy e;
    e.W = 0.5*G_*(T + 1/d - 3);
    e.T = 0.5*G_;
    e.d = -0.5*G_/sqr(d);
    e.dd = G_/pow3(d);
    return e;
}
