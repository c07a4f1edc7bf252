/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "membraneLaw.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(membraneLaw, 0);
    defineRunTimeSelectionTable(membraneLaw, entries);
}
}


Foam::autoPtr<Foam::fsbi::membraneLaw> Foam::fsbi::membraneLaw::New
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


Foam::fsbi::membraneLaw::energy Foam::fsbi::membraneLaw::constantTension
(
    const scalar tension, const scalar d
)
{
    const scalar J = Foam::sqrt(d);
    energy e;
    e.W = tension*J;
    e.d = 0.5*tension/J;
    e.dd = -0.25*tension/(d*J);
    return e;
}
