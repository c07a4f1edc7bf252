/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Newtonian.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Newtonian, 0);
    addToRunTimeSelectionTable(viscosityLaw, Newtonian, entries);
}
}


Foam::fsbi::Newtonian::Newtonian(const checkedDictionary& entries)
:
    Newtonian(entries.positive("viscosity"))
{}
