/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticField.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(magneticField, 0);
    defineRunTimeSelectionTable(magneticField, entries);
}
}


Foam::autoPtr<Foam::fsbi::magneticField> Foam::fsbi::magneticField::New
(
    const dictionary& dict, const units& u
)
{
    const checkedDictionary entries(dict);
    const word type
    (
        entries.choice("type", entriesConstructorTablePtr_->sortedToc())
    );
    auto field(entriesConstructorTablePtr_->cfind(type)()(entries, u));
    entries.finish();
    return field;
}
