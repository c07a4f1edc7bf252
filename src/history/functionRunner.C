/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionRunner.H"
#include "checkedDictionary.H"
#include "mapPolyMesh.H"
#include "spelling.H"
#include "timeControlFunctionObject.H"

namespace Foam
{
namespace fsbi
{

//- Of OpenFOAM's own: they keep faces or cells and have no updateMesh, or, as
//  the sampled surface of surfaceFieldValue, one that forgets them
static const wordList forgetful
({
    "surfaceFieldValue", "nearWallFields", "mapFields"
});

//- Of all function objects, those that may be missing
static const wordList keywords
({
    "enabled", "writeControl", "writeInterval", "executeControl",
    "executeInterval", "timeStart", "timeEnd"
});

//- OpenFOAM ignores what it does not know
static void reportSlips(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        const word meant(nearest(e.keyword(), keywords));
        if (meant.size() && meant != e.keyword())
        {
            Info<< "Warning: entry '" << e.keyword() << "' of function object '"
                << dict.dictName() << "' (system/controlDict): is '" << meant
                << "' meant?" << nl;
        }
    }
}

//- The object itself, also outside its times: it must know the mesh then, too
static functionObject& inner(functionObject& object)
{
    typedef functionObjects::timeControl timeControl;
    return
        isA<timeControl>(object)
      ? const_cast<functionObject&>(refCast<timeControl>(object).filter())
      : object;
}

//- What the clock says of a step, to be set
struct clockState
:
    public TimeState
{
    //- Is a state written after it?
    static bool& writes(TimeState& time)
    {
        return time.*(&clockState::writeTime_);
    }

    static label& index(TimeState& time)
    {
        return time.*(&clockState::timeIndex_);
    }
};

//- What OpenFOAM wants to know of a mesh in which nothing is as it was
static autoPtr<mapPolyMesh> newMesh(const polyMesh& mesh)
{
    const labelList points(mesh.nPoints(), -1);
    const labelList faces(mesh.nFaces(), -1);
    const labelList cells(mesh.nCells(), -1);
    const List<objectMap> none;
    const labelListList perPatch(mesh.boundaryMesh().size());
    const labelList patches(mesh.boundaryMesh().size(), Zero);
    return autoPtr<mapPolyMesh>::New
    (
        mesh, 0, 0, 0, points, none, faces, none, none, none, cells, none,
        none, none, none, labelList(), labelList(), labelList(),
        labelHashSet(), perPatch, labelListList(), labelListList(),
        labelListList(), labelListList(), pointField(), patches, patches,
        autoPtr<scalarField>()
    );
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::functionRunner::functionRunner
(
    Time& time, const scene& scene, const bool restarted
)
:
    time_(time),
    scene_(scene),
    generation_(scene.hasFluid() ? scene.fluid().meshing().generation() : 0)
{
    functionObjectList& list = time_.functionObjects();
    if (!wanted())
    {
        list.off();
        return;
    }
    check();
    list.on();
    if (!list.start())
    {
        FatalIOErrorInFunction(time_.controlDict())
            << "A function object cannot be made, for the reason above. The"
            << " regions are " << flatOutput(time_.sortedNames<fvMesh>())
            << ": each function object needs an entry 'region'"
            << exit(FatalIOError);
    }
    if (restarted)
    {
        readMeans();
    }
    list.off();
}


Foam::fsbi::functionRunner::~functionRunner()
{
    time_.functionObjects().clear();
}


void Foam::fsbi::functionRunner::check() const
{
    const checkedDictionary controls(time_.controlDict());
    for (const entry& e : controls.subDict("functions"))
    {
        if (!e.isDict() || !e.dict().getOrDefault("enabled", true))
        {
            continue;
        }
        reportSlips(e.dict());
        const word type(e.dict().getOrDefault<word>("type", word::null));
        if (type == "forces" || type == "forceCoeffs")
        {
            FatalIOErrorInFunction(e.dict())
                << "Function object '" << e.keyword() << "' of type " << type
                << " would be less exact than the solver's own balance: force"
                << " and torque of the fluid on every body are in"
                << " postProcessing/history.h5, tables"
                << " bodies/<name>/force/fluid and torque/fluid"
                << " (elasticBodies/<name>/fluidForce), and as text in"
                << " postProcessing/bodies" << exit(FatalIOError);
        }
        if
        (
            type == "probes"
         && !e.dict().getOrDefault("fixedLocations", true)
        )
        {
            FatalIOErrorInFunction(e.dict())
                << "Function object '" << e.keyword() << "': probes with"
                << " 'fixedLocations no' move with cells, which do not survive"
                << " a new mesh" << exit(FatalIOError);
        }
    }
}


void Foam::fsbi::functionRunner::readMeans()
{
    functionObjectList& list = time_.functionObjects();
    // in a step that is none it reads, and adds nothing
    const label index = time_.timeIndex();
    clockState::index(time_) = -1;
    forAll(list, i)
    {
        if (inner(list[i]).type() == "fieldAverage")
        {
            inner(list[i]).execute();
        }
    }
    clockState::index(time_) = index;
}


void Foam::fsbi::functionRunner::readAgain(const fvMesh& mesh)
{
    functionObjectList& list = time_.functionObjects();
    const dictionary& dicts = time_.controlDict().subDict("functions");
    forAll(list, i)
    {
        const dictionary* dict = dicts.findDict(list[i].name());
        if
        (
            dict && dict->getOrDefault<word>("region", "region0") == mesh.name()
         && forgetful.found(dict->get<word>("type"))
        )
        {
            inner(list[i]).read(*dict);
        }
    }
}


void Foam::fsbi::functionRunner::notifyMotion(const fvMesh& mesh)
{
    if (mesh.pointsInstance() != time_.timeName())
    {
        return;
    }
    functionObjectList& list = time_.functionObjects();
    forAll(list, i)
    {
        inner(list[i]).movePoints(mesh);
    }
    readAgain(mesh);
}


void Foam::fsbi::functionRunner::notifyNewMesh(const fvMesh& mesh)
{
    const autoPtr<mapPolyMesh> map(newMesh(mesh));
    functionObjectList& list = time_.functionObjects();
    forAll(list, i)
    {
        inner(list[i]).updateMesh(map());
    }
    readAgain(mesh);
}


void Foam::fsbi::functionRunner::notifyMeshes()
{
    for (const solidRegion& solid : scene_.bodies().elastic)
    {
        notifyMotion(solid.mesh());
    }
    if (!scene_.hasFluid())
    {
        return;
    }
    const label now = scene_.fluid().meshing().generation();
    if (now != generation_)
    {
        generation_ = now;
        notifyNewMesh(scene_.fluid().mesh());
    }
    else
    {
        notifyMotion(scene_.fluid().mesh());
    }
}


void Foam::fsbi::functionRunner::execute(const bool saved)
{
    if (!wanted())
    {
        return;
    }
    functionObjectList& list = time_.functionObjects();
    if (saved)
    {
        // also where the run ends, or Ctrl-C ended it, between two of those that
        // the clock knows: means must go on from there
        clockState::writes(time_) = true;
    }
    list.on();
    notifyMeshes();
    list.execute();
    const bool modified = list.filesModified();
    list.off();
    if (modified)
    {
        time_.readModifiedObjects();
    }
}


void Foam::fsbi::functionRunner::end()
{
    if (wanted())
    {
        time_.functionObjects().on();
        time_.functionObjects().end();
        time_.functionObjects().off();
    }
}
