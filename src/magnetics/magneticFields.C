/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticFields.H"

Foam::fsbi::magneticFields::magneticFields
(
    const dictionary& dict, const units& u
)
{
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a magnetic"
                << " field is name { type ...; }" << exit(FatalIOError);
        }
        append(magneticField::New(e.dict(), u));
        names_.append(e.keyword());
    }
}


Foam::vector Foam::fsbi::magneticFields::B
(
    const point& x, const scalar t
) const
{
    vector sum(Zero);
    for (const magneticField& field : *this)
    {
        sum += field.B(x, t);
    }
    return sum;
}


Foam::tensor Foam::fsbi::magneticFields::gradient
(
    const point& x, const scalar t
) const
{
    tensor sum(Zero);
    for (const magneticField& field : *this)
    {
        sum += field.gradient(x, t);
    }
    return sum;
}


bool Foam::fsbi::magneticFields::uniform() const
{
    bool all = true;
    for (const magneticField& field : *this)
    {
        all = all && field.uniform();
    }
    return all;
}
