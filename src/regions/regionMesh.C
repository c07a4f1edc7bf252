/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMesh.H"
#include "carriedFields.H"
#include "meshDistribution.H"
#include "Time.H"
#include "pointIOField.H"
#include "OStringStream.H"
#include "IStringStream.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "faceIOList.H"

namespace Foam
{

//- Part of its distance from the origin by which a mesh that has no width is wide
static const scalar roundOff = 1e-12;

//- Width of a mesh that is still computed with, as numbers of dictionaries are
static const scalar farthest = 1e25;

//- Folder of a region's mesh in constant
static fileName folderOf(const word& region)
{
    return
        region == polyMesh::defaultRegion
      ? fileName(polyMesh::meshSubDir)
      : region/polyMesh::meshSubDir;
}

//- Of the files of a mesh without cells that only names a region
static const string emptyNote("the meshes are in the time folders");

//- Is there a mesh, other than one of writeEmptyMesh?
static bool isMesh(const fileName& folder)
{
    if (!isFile(folder/"points"))           // or points.gz
    {
        return false;
    }
    IFstream is(folder/"points");
    const token first(is);
    return
        !first.isWord()
     || dictionary(is).getOrDefault<string>("note", "") != emptyNote;
}

static void writeEmpty
(
    const fileName& folder, const word& name, const word& type,
    const string& content
)
{
    OFstream os(folder/name);
    os  << "FoamFile" << nl << token::BEGIN_BLOCK << incrIndent << nl;
    os.writeEntry("version", "2.0");
    os.writeEntry("format", word("ascii"));
    os.writeEntry("class", type);
    os.writeEntry("note", emptyNote);
    os.writeEntry("object", name);
    os  << decrIndent << token::END_BLOCK << nl << nl << content.c_str() << nl;
}

//- Numbers of a part's cells, faces and points in the whole mesh, as a state
//  has them and as decomposePar writes them
static const wordList numberNames({"wholeCells", "wholeFaces", "wholePoints"});
static const wordList decomposeParNames
(
    {"cellProcAddressing", "faceProcAddressing", "pointProcAddressing"}
);

static IOobject numbersObject
(
    const word& name, const word& instance, const fvMesh& mesh
)
{
    return IOobject
    (
        name, instance, polyMesh::meshSubDir, mesh, IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
}

static void keep(const fvMesh& mesh, const word& name, labelList&& numbers)
{
    IOobject io(numbersObject(name, mesh.time().timeName(), mesh));
    io.readOpt() = IOobject::NO_READ;
    mesh.thisDb().store(new labelIOList(io, std::move(numbers)));
}

//- This process's part of the master's mesh
static fsbi::meshDistribution distributed(const fsbi::meshLists& whole)
{
    labelList rank;
    if (Pstream::master())
    {
        rank = fsbi::meshDistribution::bisect(whole, Pstream::nProcs());
    }
    return fsbi::meshDistribution(whole, rank);
}

//- Of a mesh that was read, if they are there
static void readNumbers(const fvMesh& mesh, const word& instance)
{
    forAll(numberNames, i)
    {
        for (const word& name : {numberNames[i], decomposeParNames[i]})
        {
            IOobject io(numbersObject(name, instance, mesh));
            io.registerObject() = false;
            if
            (
                isFile(io.objectPath())
             && !mesh.thisDb().found(numberNames[i])
             && (name == numberNames[i] || instance == mesh.time().constant())
            )
            {
                labelList numbers{labelIOList(io)};
                if (name == "faceProcAddressing")
                {
                    for (label& f : numbers)
                    {
                        f = mag(f) - 1;     // the sign tells the owner's side
                    }
                }
                keep(mesh, numberNames[i], std::move(numbers));
            }
        }
    }
}

} // End namespace Foam


void Foam::fsbi::setNumbers
(
    const fvMesh& mesh,
    const labelList& cells,
    const labelList& faces,
    const labelList& points
)
{
    keep(mesh, numberNames[0], labelList(cells));
    keep(mesh, numberNames[1], labelList(faces));
    keep(mesh, numberNames[2], labelList(points));
}


bool Foam::fsbi::hasRegionMesh(const Time& time, const word& region)
{
    return returnReduce
    (
        isMesh(time.constantPath()/folderOf(region)), andOp<bool>()
    );
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::readRegionMesh
(
    const Time& time,
    const word& region,
    const word& instance
)
{
    auto mesh = autoPtr<fvMesh>::New
    (
        IOobject(region, instance, time, IOobject::MUST_READ)
    );
    if (Pstream::parRun())
    {
        readNumbers(mesh(), instance);
    }
    return mesh;
}


Foam::autoPtr<Foam::fvMesh> Foam::fsbi::makeRegionMesh
(
    const Time& time,
    const word& region,
    const meshLists& whole
)
{
    const meshDistribution part(distributed(whole));
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
    if (Pstream::parRun())
    {
        setNumbers(mesh(), part.cells, part.faces, part.points);
    }
    return mesh;
}


void Foam::fsbi::replaceRegionMesh(fvMesh& mesh, const meshLists& whole)
{
    const meshDistribution part(distributed(whole));
    const carriedFields others(mesh);
    part.mesh.replaceIn(mesh);
    others.putOn(mesh);
    if (Pstream::parRun())
    {
        for (const word& name : numberNames)
        {
            mesh.thisDb().checkOut(name);
        }
        setNumbers(mesh, part.cells, part.faces, part.points);
    }
}


Foam::fsbi::meshLists Foam::fsbi::wholeLists(const fvMesh& mesh)
{
    meshLists whole(wholeMesh::lists(mesh));
    if (!Pstream::parRun())
    {
        return whole;
    }
    bool known = true;
    for (const word& name : numberNames)
    {
        known = known && mesh.thisDb().foundObject<labelIOList>(name);
    }
    if (!returnReduce(known, andOp<bool>()))
    {
        whole.failure = "the parts of the mesh do not know their place in it";
        return whole;
    }
    const auto numbers = [&](const label i) -> const labelList&
    {
        return mesh.thisDb().lookupObject<labelIOList>(numberNames[i]);
    };
    List<meshPiece> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = {whole, numbers(0), numbers(1), numbers(2)};
    Pstream::gatherList(parts);
    if (!Pstream::master())
    {
        return meshLists();
    }
    List<const meshPiece*> pieces(parts.size());
    forAll(parts, i)
    {
        pieces[i] = &parts[i];
    }
    return joined(pieces);
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
    for (const word& name : numberNames)
    {
        if (mesh.thisDb().foundObject<labelIOList>(name))
        {
            add(mesh.thisDb().lookupObject<labelIOList>(name));
        }
    }
}


void Foam::fsbi::writeEmptyMesh(const fileName& constant, const fvMesh& mesh)
{
    const fileName folder(constant/folderOf(mesh.name()));
    if (isMesh(folder))
    {
        return;
    }
    OStringStream patches;
    const label n = mesh.boundaryMesh().nNonProcessor();
    patches << n << nl << token::BEGIN_LIST << nl << incrIndent;
    for (label i = 0; i < n; ++i)
    {
        OStringStream os;
        mesh.boundaryMesh()[i].write(os);
        dictionary dict(IStringStream(os.str())());
        dict.set("nFaces", 0);
        dict.set("startFace", 0);
        patches << mesh.boundaryMesh()[i].name() << dict;
    }
    patches << token::END_LIST;
    mkDir(folder);
    writeEmpty(folder, "points", pointIOField::typeName, "0()");
    writeEmpty(folder, "faces", faceIOList::typeName, "0()");
    writeEmpty(folder, "owner", labelIOList::typeName, "0()");
    writeEmpty(folder, "neighbour", labelIOList::typeName, "0()");
    writeEmpty(folder, "boundary", polyBoundaryMesh::typeName, patches.str());
}


bool Foam::fsbi::wholeMesh::exists(const Time& time, const word& region)
{
    return isMesh(time.globalPath()/time.constant()/folderOf(region));
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
    check();
}


void Foam::fsbi::wholeMesh::check() const
{
    const fileName folder("constant"/mesh_->meshDir());
    const boundBox box(mesh_->points(), false);
    const scalar reach = cmptMax(cmptMag(box.min()) + cmptMag(box.max()));
    if (!(cmptMin(box.span()) > roundOff*reach && reach < farthest))
    {
        FatalErrorInFunction
            << "The mesh in " << folder << " reaches from " << box.min()
            << " to " << box.max() << ": without volume, or too far to be"
            << " computed with. See vertices and scale in system/blockMeshDict"
            << exit(FatalError);
    }
    for (const polyPatch& patch : mesh_->boundaryMesh())
    {
        // what OpenFOAM makes of a type that it does not know
        const bool unknown = patch.type() == "genericPatch";
        // what blockMesh makes of faces that it finds in no patch
        const bool left = patch.type() == "empty" && patch.size();
        if (unknown || left)
        {
            FatalErrorInFunction
                << "Patch '" << patch.name() << "' of the mesh in " << folder
                << " has " << (unknown ? "an unknown type" : "the type 'empty'")
                << ": every face must be in a patch of 'boundary' in"
                << " system/blockMeshDict, of the type patch or wall"
                << exit(FatalError);
        }
    }
}


Foam::fsbi::meshLists Foam::fsbi::wholeMesh::lists(const polyMesh& mesh)
{
    meshLists lists;
    lists.points = mesh.points();
    lists.faces = mesh.faces();
    lists.owner = mesh.faceOwner();
    lists.neighbour = mesh.faceNeighbour();
    for (const polyPatch& patch : mesh.boundaryMesh())
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
