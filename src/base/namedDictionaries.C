/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "namedDictionaries.H"
#include "Time.H"

Foam::fsbi::namedDictionaries::namedDictionaries
(
    const Time& time, const word& file, const char* form
)
:
    dict_
    (
        IOobject
        (
            file, time.caseConstant(), time,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    )
{
    for (const entry& e : dict_)
    {
        if (e.keyword() == "FoamFile")
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict_)
                << "Entry '" << e.keyword() << "' is no dictionary: " << form
                << exit(FatalIOError);
        }
        entries_.append(&e);
    }
}
