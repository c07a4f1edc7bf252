/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumTerm.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(momentumTerm, 0);
defineRunTimeSelectionTable(momentumTerm, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::wordList Foam::fsbi::momentumTerm::names()
{
    return entriesConstructorTablePtr_->sortedToc();
}


Foam::PtrList<Foam::fsbi::momentumTerm> Foam::fsbi::momentumTerm::all
(
    const fvMesh& mesh, const dictionary& material
)
{
    PtrList<momentumTerm> terms;
    const checkedDictionary entries(material);
    for (const word& name : names())
    {
        if (entries.found(name))
        {
            terms.append
            (
                (*entriesConstructorTablePtr_)[name]
                (
                    mesh, entries.subDict(name)
                )
            );
        }
    }
    return terms;
}
