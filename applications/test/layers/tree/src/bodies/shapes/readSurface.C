/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readSurface.H"
#include "OSspecific.H"

Foam::fsbi::outcome Foam::fsbi::readSurface
(
    const fileName& file, triSurface& surface
)
{
    const fileName path(fileName(file).expand());
    if (!isFile(path))
    {
        return outcome::failed("There is no surface file '" + path + "'");
    }
    outcome read;
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    try
    {
        surface = triSurface(path);
    }
    catch (const error& e)
    {
        read = outcome::failed
        (
            "The surface file '" + path + "' cannot be used: " + e.message()
        );
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);
    return read;
}
