/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "startField.H"
#include "Time.H"
#include "IFstream.H"
#include "IStringStream.H"

bool Foam::fsbi::hasStartField
(
    const Time& time,
    const word& region,
    const word& name
)
{
    bool there = isFile(time.globalPath()/time.timeName()/region/name);
    Pstream::scatter(there);
    return there;
}


Foam::dictionary Foam::fsbi::startField
(
    const Time& time,
    const word& region,
    const word& name
)
{
    dictionary dict;
    const fileName file(time.globalPath()/time.timeName()/region/name);
    if (Pstream::master())
    {
        IFstream is(file);
        IOobject header(name, time.timeName(), region, time);
        if (!is.good() || !header.readHeader(is))
        {
            FatalErrorInFunction
                << "The field " << file << " is missing, or has no"
                << " header; it gives the boundary conditions of region "
                << region << exit(FatalError);
        }
        dict = dictionary(is);
    }
    Pstream::scatter(dict);
    dict.name() = file;
    return dict;
}


void Foam::fsbi::setPatch
(
    dictionary& patches,
    const word& name,
    const word& type
)
{
    dictionary entry
    (
        IStringStream("type " + type + "; value uniform (0 0 0);")()
    );
    // set() would overwrite a pattern that matches the name
    patches.remove(name);
    patches.add(name, entry);
}
