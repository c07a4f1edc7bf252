/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "EvansSkalak.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(EvansSkalak, 0);
    addToRunTimeSelectionTable(membraneLaw, EvansSkalak, entries);
}
}


Foam::fsbi::EvansSkalak::EvansSkalak(const checkedDictionary& entries)
:
    G_(entries.positive("shearModulus")),
    K_(entries.positive("areaModulus"))
{}


Foam::fsbi::membraneLaw::energy Foam::fsbi::EvansSkalak::at
(
    const scalar T, const scalar d
) const
{
    energy e;
    const scalar J = Foam::sqrt(d);
    e.W = G_*(0.5*T/J - 1) + 0.5*K_*sqr(J - 1);
    e.T = 0.5*G_/J;
    e.d = -0.25*G_*T/(d*J) + 0.5*K_*(1 - 1/J);
    e.Td = -0.25*G_/(d*J);
    e.dd = 0.375*G_*T/(sqr(d)*J) + 0.25*K_/(d*J);
    return e;
}
