/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshLists.H"
#include "fvMesh.H"
#include "ListOps.H"
#include "IStringStream.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fsbi::meshLists::nCells() const
{
    // the last cell may own no face
    const label last = owner.empty() ? -1 : Foam::max(owner);
    return 1 + (neighbour.empty() ? last : Foam::max(last, Foam::max(neighbour)));
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::meshLists::makeMesh
(
    const IOobject& io
) const
{
    autoPtr<fvMesh> mesh
    (
        new fvMesh
        (
            io,
            pointField(points), faceList(faces),
            labelList(owner), labelList(neighbour)
        )
    );
    mesh->addFvPatches(patchesFor(mesh->boundaryMesh()));
    return mesh;
}


Foam::autoPtr<Foam::polyMesh> Foam::fsbi::meshLists::makePolyMesh
(
    const IOobject& io
) const
{
    autoPtr<polyMesh> mesh
    (
        new polyMesh
        (
            io,
            pointField(points), faceList(faces),
            labelList(owner), labelList(neighbour)
        )
    );
    mesh->addPatches(patchesFor(mesh->boundaryMesh()));
    return mesh;
}


void Foam::fsbi::meshLists::replaceIn(fvMesh& mesh) const
{
    mesh.removeFvBoundary();        // and what follows from cells and points
    mesh.resetMotion();
    mesh.resetPrimitives
    (
        autoPtr<pointField>::New(points), autoPtr<faceList>::New(faces),
        autoPtr<labelList>::New(owner), autoPtr<labelList>::New(neighbour),
        labelList(), labelList()
    );
    mesh.addFvPatches(patchesFor(mesh.boundaryMesh()));
}


Foam::List<Foam::polyPatch*> Foam::fsbi::meshLists::patchesFor
(
    const polyBoundaryMesh& boundary
) const
{
    List<polyPatch*> patches(patchNames.size());
    forAll(patches, i)
    {
        dictionary dict(patchDicts[i]);
        dict.set("nFaces", patchSizes[i]);
        dict.set("startFace", patchStarts[i]);
        patches[i] =
            polyPatch::New(patchNames[i], dict, i, boundary).ptr();
    }
    return patches;
}


// * * * * * * * * * * * * * * * Friend Operators  * * * * * * * * * * * * * //

Foam::Ostream& Foam::fsbi::operator<<(Ostream& os, const meshLists& m)
{
    // as text: a dictionary itself cannot be read from the middle of a stream
    List<string> dicts(m.patchDicts.size());
    forAll(dicts, i)
    {
        OStringStream text;
        m.patchDicts[i].write(text, false);
        dicts[i] = text.str();
    }
    os  << m.points << m.faces << m.owner << m.neighbour << m.patchNames
        << dicts << m.patchStarts << m.patchSizes << m.bodyPoints
        << m.failure;
    return os;
}


Foam::Istream& Foam::fsbi::operator>>(Istream& is, meshLists& m)
{
    List<string> dicts;
    is  >> m.points >> m.faces >> m.owner >> m.neighbour >> m.patchNames
        >> dicts >> m.patchStarts >> m.patchSizes >> m.bodyPoints
        >> m.failure;
    m.patchDicts.setSize(dicts.size());
    forAll(dicts, i)
    {
        m.patchDicts[i] = dictionary(IStringStream(dicts[i])());
    }
    return is;
}
