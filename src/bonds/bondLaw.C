/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondLaw.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(bondLaw, 0);
    defineRunTimeSelectionTable(bondLaw, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bondLaw::bondLaw
(
    const checkedDictionary& entries, const scalar kT
)
:
    kT_(kT),
    k0on_(entries.positive("k0on")),
    lambda_(entries.positive("lambda")),
    s_(entries.positive("s"))
{}


Foam::autoPtr<Foam::fsbi::bondLaw> Foam::fsbi::bondLaw::New
(
    const checkedDictionary& entries, const scalar kT
)
{
    const word law
    (
        entries.choice("law", entriesConstructorTablePtr_->sortedToc())
    );
    return entriesConstructorTablePtr_->cfind(law)()(entries, kT);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::bondLaw::logOn(const scalar length) const
{
    return Foam::log(k0on_)
      + logBreaking(length - lambda_) - energy(length)/kT_;
}


Foam::scalar Foam::fsbi::bondLaw::kOff(const scalar length) const
{
    // a double ends at exp(709), and overflow is trapped
    return k0off()*Foam::exp(min(logBreaking(length - lambda_), scalar(600)));
}
