/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "semiImplicit.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(semiImplicit, 0);
    addToRunTimeSelectionTable(accelerator, semiImplicit, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::semiImplicit::semiImplicit(const checkedDictionary& entries)
:
    omega_(entries.positive("omega"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::semiImplicit::update
(
    scalarField& x, const scalarField& residual
)
{
    x += omega_*residual;
}
