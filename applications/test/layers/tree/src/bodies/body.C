/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "body.H"
#include "checkedDictionary.H"
#include "loadLibraries.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(body, 0);
defineRunTimeSelectionTable(body, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::body> Foam::fsbi::body::New
(
    const bodySite& site, const dictionary& dict, const dictionary& saved
)
{
    loadLibraries(dict);
    const word type
    (
        checkedDictionary(dict).choice
        (
            "type", entriesConstructorTablePtr_->sortedToc()
        )
    );
    return (*entriesConstructorTablePtr_)[type](site, dict, saved);
}
