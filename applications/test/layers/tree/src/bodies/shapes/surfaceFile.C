/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "readSurface.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(surfaceFile, 0);
    addToRunTimeSelectionTable(bodyShape, surfaceFile, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::surfaceFile::surfaceFile(const dictionary& dict)
:
    bodyShape(dict),
    file_(entries_.get<fileName>("file"))
{
    const scalar scale = entries_.positive("scale", 1);
    entries_.finish();

    file_.expand();
    const triSurface read(readFile());
    List<triFace> triangles(read.size());
    forAll(triangles, i)
    {
        const labelledTri& t = read.localFaces()[i];
        triangles[i] = triFace(t[0], t[1], t[2]);
    }
    surface_ = bodySurface
    (
        scale*read.localPoints(), std::move(triangles)
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::triSurface Foam::fsbi::surfaceFile::readFile() const
{
    triSurface surface;
    outcome read(readSurface(file_, surface));
    if (read && surface.size() < fewestTriangles)
    {
        read = outcome::failed
        (
            "The surface file '" + file_ + "' cannot be used: it has "
          + Foam::name(surface.size()) + " triangles, a body needs "
          + Foam::name(label(fewestTriangles)) + " or more"
        );
    }
    if (!read)
    {
        FatalIOErrorInFunction(entries_.dict())
            << read.reason.c_str() << exit(FatalIOError);
    }
    return surface;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::surfaceFile::make(const scalar size) const
{
    const scalar given = surface_.meanEdge();
    if (size > 1.5*given || size < given/1.5)
    {
        Info<< "The triangles of " << file_ << " are kept: mean edge " << given
            << ", not " << size << endl;
    }
    return surface_;
}
