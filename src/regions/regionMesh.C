/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMesh.H"
#include "meshDistribution.H"
#include "Time.H"
#include "pointIOField.H"
#include "OStringStream.H"
#include "IStringStream.H"

namespace Foam
{

//- Folder of a region's mesh in constant
static fileName folderOf(const word& region)
{
    return
        region == polyMesh::defaultRegion
      ? fileName(polyMesh::meshSubDir)
      : region/polyMesh::meshSubDir;
}

} // End namespace Foam


bool Foam::fsbi::hasRegionMesh(const Time& time, const word& region)
{
    const fileName faces(time.constantPath()/folderOf(region)/"faces");
    return returnReduce(isFile(faces), andOp<bool>());
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::readRegionMesh
(
    const Time& time,
    const word& region,
    const word& instance
)
{
    return autoPtr<fvMesh>::New
    (
        IOobject(region, instance, time, IOobject::MUST_READ)
    );
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::makeRegionMesh
(
    const Time& time,
    const word& region,
    const meshLists& whole
)
{
    labelList rank;
    if (Pstream::master())
    {
        rank = meshDistribution::bisect(whole, Pstream::nProcs());
    }
    const meshDistribution part(whole, rank);
    autoPtr<fvMesh> mesh
    (
        part.mesh.makeMesh
        (
            IOobject(region, time.timeName(), time, IOobject::NO_READ)
        )
    );
    // only now: with an IOobject to be read it would take an old mesh's patches
    mesh->fvSchemes::readOpt() = IOobject::READ_IF_PRESENT;
    mesh->fvSchemes::read();
    mesh->fvSolution::readOpt() = IOobject::READ_IF_PRESENT;
    mesh->fvSolution::read();
    return mesh;
}


void Foam::fsbi::writeMesh
(
    const fvMesh& mesh,
    const pointField& points,
    const std::function<void(const regIOobject&)>& add
)
{
    add
    (
        pointIOField
        (
            IOobject
            (
                "points", mesh.time().timeName(), polyMesh::meshSubDir, mesh,
                IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            points
        )
    );
    for (const word name : {"faces", "owner", "neighbour", "boundary"})
    {
        add(mesh.thisDb().lookupObject<regIOobject>(name));
    }
}


bool Foam::fsbi::wholeMesh::exists(const Time& time, const word& region)
{
    const fileName folder(time.globalPath()/time.constant()/folderOf(region));
    return isFile(folder/"points");         // or points.gz
}


Foam::fsbi::wholeMesh::wholeMesh(const Time& time, const word& region)
{
    const bool parallel = Pstream::parRun();
    Pstream::parRun() = false;
    time_.reset
    (
        new Time
        (
            Time::controlDictName, time.rootPath(), time.globalCaseName(),
            "system", "constant", false, false
        )
    );
    mesh_.reset
    (
        new polyMesh
        (
            IOobject(region, time_->constant(), time_(), IOobject::MUST_READ)
        )
    );
    Pstream::parRun() = parallel;
}


Foam::fsbi::meshLists Foam::fsbi::wholeMesh::lists() const
{
    meshLists lists;
    lists.points = mesh_->points();
    lists.faces = mesh_->faces();
    lists.owner = mesh_->faceOwner();
    lists.neighbour = mesh_->faceNeighbour();
    for (const polyPatch& patch : mesh_->boundaryMesh())
    {
        OStringStream os;
        os.precision(17);
        patch.write(os);
        dictionary dict(IStringStream(os.str())());
        dict.remove("nFaces");
        dict.remove("startFace");
        lists.patchNames.append(patch.name());
        lists.patchDicts.append(dict);
        lists.patchStarts.append(patch.start());
        lists.patchSizes.append(patch.size());
    }
    return lists;
}
