/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscosityLaw.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(viscosityLaw, 0);
    defineRunTimeSelectionTable(viscosityLaw, entries);
}
}


Foam::autoPtr<Foam::fsbi::viscosityLaw> Foam::fsbi::viscosityLaw::New
(
    const checkedDictionary& entries
)
{
    const word type
    (
        entries.choice("type", entriesConstructorTablePtr_->sortedToc())
    );
    return (*entriesConstructorTablePtr_)[type](entries);
}
