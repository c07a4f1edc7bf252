/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidMesh.H"
#include "checkedDictionary.H"
#include "untrapped.H"
#include "Time.H"
#include "pointIOField.H"
#include "wallPolyPatch.H"

namespace Foam
{
namespace fsbi
{

//- Degrees of non-orthogonality that a mesh may lose before it is made anew,
//  where a gap allows none that is good
static const scalar loss = 3;

//- Degrees of non-orthogonality that are good enough where bodies rest on each
//  other: of the fluid between them nothing but a resistance is asked for
static const scalar atRest = 82;

//- Fatal if the domain has cells without volume
static void checkDomain(const polyMesh& domain)
{
    if (!(min(domain.cellVolumes()) > 0))
    {
        FatalErrorInFunction
            << "The domain has cells without volume: see the vertices and"
            << " blocks of system/blockMeshDict" << exit(FatalError);
    }
}


//- Not around elastic bodies of order 4: microbeadTethered by order 4 on edges of
//  1.35 takes 61 to 111 iterations a step on whole meshes; on one that had been
//  healed three times they went from 65 to more than 200 within eight steps
static bool healable(const UPtrList<immersedBody>& bodies)
{
    for (const immersedBody& body : bodies)
    {
        if (body.deforms() && body.curved())
        {
            return false;
        }
    }
    return true;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::fluidMesh::fluidMesh
(
    const Time& time,
    const word& name,
    UPtrList<immersedBody>& bodies,
    timings& t,
    const dictionary& saved,
    const bool withoutBodies
)
:
    time_(time),
    name_(name),
    bodies_(bodies),
    withoutBodies_(saved.getOrDefault("withoutBodies", withoutBodies)),
    timings_(t),
    remeshDict_
    (
        IOdictionary
        (
            IOobject
            (
                "remeshDict", time.caseSystem(), time,
                IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
            )
        )
    ),
    followed_(-1),
    direction_(Zero),
    referenceShift_(Zero),
    referenceGap_(GREAT),
    generation_(0)
{
    gather();
    readFollow();
    const remeshControls checked(remeshDict_);
    if (saved.size())
    {
        readMesh(time_.timeName());
        restore(saved);
        return;
    }
    if (hasRegionMesh(time_, name_))
    {
        readMesh(time_.constant());
        surfaces_ = ownSurfaces(present_);
        confined_ = "the fluid's mesh is given";
    }
    else
    {
        auto timer = timings_.measure("meshing");
        const outcome made(generate([](){}));
        if (!made)
        {
            FatalErrorInFunction
                << "No acceptable mesh around the bodies could be made: "
                << made.reason.c_str() << exit(FatalError);
        }
    }
    setReference();
    referenceGap_ = smallestGap(walls_);
}


void Foam::fsbi::fluidMesh::readFollow()
{
    if (!remeshDict_.found("follow"))
    {
        return;
    }
    const checkedDictionary follow
    (
        checkedDictionary(remeshDict_).subDict("follow")
    );
    const word body(follow.get<word>("body"));
    followed_ = namesOf(bodies_).find(body);
    if (followed_ < 0)
    {
        FatalIOErrorInFunction(follow.dict())
            << "There is no 'body' '" << body << "' to follow: the bodies of"
            << " constant/bodies are " << flatOutput(namesOf(bodies_))
            << exit(FatalIOError);
    }
    direction_ = follow.direction("direction", vector(1, 0, 0));
    follow.finish();
    remeshDict_.remove("follow");
}


void Foam::fsbi::fluidMesh::readMesh(const word& instance)
{
    mesh_ = readRegionMesh(time_, name_, instance);
    for (const word& name : namesOf(present_))
    {
        if (mesh().boundaryMesh().findPatchID(name) < 0)
        {
            FatalErrorInFunction
                << "The mesh of region " << name_ << " has no patch for body '" << name
                << "'; its patches are "
                << flatOutput(mesh().boundaryMesh().names())
                << exit(FatalError);
        }
    }
}


void Foam::fsbi::fluidMesh::readDomain()
{
    if (mesher_ || !Pstream::master())
    {
        return;
    }
    if (!wholeMesh::exists(time_, polyMesh::defaultRegion))
    {
        FatalErrorInFunction
            << "There is no domain to put the bodies in: run blockMesh, or"
            << " fsbiDomain, first ("
            << time_.globalPath()/time_.constant()/polyMesh::meshSubDir
            << " is missing)" << exit(FatalError);
    }
    domain_.reset(new wholeMesh(time_, polyMesh::defaultRegion));
    checkDomain((*domain_)());
    checkPatchNames();
    mesher_.reset(new conformalMesher((*domain_)(), remeshDict_));
    if (confined_.size())
    {
        mesher_->close();
    }
}


void Foam::fsbi::fluidMesh::checkPatchNames() const
{
    const wordList patches((*domain_)().boundaryMesh().names());
    for (const word& name : namesOf(bodies_))
    {
        if (patches.found(name))
        {
            FatalErrorInFunction
                << "Body '" << name << "' has the name of a patch of the"
                << " domain; its patches are " << flatOutput(patches)
                << exit(FatalError);
        }
    }
}


void Foam::fsbi::fluidMesh::setReference()
{
    auto timer = timings_.measure("meshing");
    referencePoints_ = mesh().points();
    referenceShift_ = shift();
    motion_.reset(new fluidMotion(mesh(), present_, surfaces_, images_));
    measureReference();
}


void Foam::fsbi::fluidMesh::measureReference()
{
    referenceVolumes_ = mesh().cellVolumes();
    referenceNonOrthogonality_ = meshQuality(mesh()).maxNonOrthogonality;
    wordList others(namesOf(present_));
    const auto boundary = [&]
    {
        return new triangleTree
        (
            inverseDistanceMotion::domainBoundary
            (
                mesh(), others, images_.size()
            )
        );
    };
    boundary_.reset(boundary());
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if (!isA<wallPolyPatch>(patch))
        {
            others.append(patch.name());
        }
    }
    walls_.reset(boundary());
    patches_.clear();
}


Foam::vector Foam::fsbi::fluidMesh::shift() const
{
    if (followed_ < 0)
    {
        return Zero;
    }
    const immersedBody& body = bodies_[followed_];
    return direction_*(direction_ & (body.placed().centre - body.start()));
}


bool Foam::fsbi::fluidMesh::isBody(const word& patchName) const
{
    return namesOf(bodies_).found(patchName);
}


Foam::label Foam::fsbi::fluidMesh::bodyPatch(const label bodyi) const
{
    return mesh().boundaryMesh().findPatchID(bodies_[bodyi].name());
}


void Foam::fsbi::fluidMesh::gather()
{
    present_.clear();
    for (immersedBody& body : bodies_)
    {
        if (body.present() && !withoutBodies_)
        {
            present_.append(&body);
        }
    }
}


bool Foam::fsbi::fluidMesh::holdsOthers() const
{
    wordList now;
    for (const immersedBody& body : bodies_)
    {
        if (body.present() && !withoutBodies_)
        {
            now.append(body.name());
        }
    }
    return now != namesOf(present_);
}


void Foam::fsbi::fluidMesh::move()
{
    mesh_->movePoints(motion_->points(shift() - referenceShift_));
    mesh_->moving(false);
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::usable() const
{
    const scalar smallest = gMin(mesh().cellVolumes());
    return
        smallest > 0
      ? outcome()
      : outcome::failed
        (
            "a cell of the fluid has the volume " + Foam::name(smallest)
          + narrowGap(true)
        );
}


bool Foam::fsbi::fluidMesh::endures() const
{
    const meshQuality now(mesh());
    return now.minVolume > 0 && now.maxNonOrthogonality <= atRest;
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::follow
(
    const std::function<void()>& release, const bool rest
)
{
    auto timer = timings_.measure("meshing");
    // of bodies that a step has thrown far away
    const untrapped scope;
    if (holdsOthers())
    {
        gather();
        return anew("other bodies are in the domain", release);
    }
    move();

    // a mesh that could not be made better is not degraded from the start
    remeshControls controls(remeshDict_);
    controls.maxNonOrthogonality = max
    (
        controls.maxNonOrthogonality,
        min(referenceNonOrthogonality_ + loss, remeshControls::bearable)
    );
    const scalar twist = motion_->twist();
    if (rest && twist <= controls.maxTwist && endures())
    {
        return outcome();
    }
    string reason
    (
        meshQuality(mesh(), referenceVolumes_).failureReason(controls, twist)
    );
    if (reason.empty())
    {
        reason = closingGap();
    }
    if (reason.empty())
    {
        return outcome();
    }
    // no swap of cells turns a body back or opens a gap
    if
    (
        healable(present_) && twist <= controls.maxTwist && closingGap().empty()
    )
    {
        const outcome healed(heal(controls, release));
        if (healed)
        {
            Info<< "Healing: " << reason.c_str() << endl;
            // the gap stays: triangles are still those that were cut for it
            setReference();
            return outcome();
        }
        Info<< "Not healed: " << healed.reason.c_str() << endl;
    }
    return anew(reason, release);
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::anew
(
    const string& reason, const std::function<void()>& release
)
{
    Info<< "Remeshing: " << reason.c_str() << endl;
    const outcome made(generate(release));
    if (!made)
    {
        return made;
    }
    setReference();
    referenceGap_ = smallestGap(walls_);
    if
    (
        referenceNonOrthogonality_
      > remeshControls(remeshDict_).maxNonOrthogonality
    )
    {
        Info<< "The new mesh has a non-orthogonality of "
            << referenceNonOrthogonality_ << " degrees, the best of three"
            << endl;
    }
    return outcome();
}


void Foam::fsbi::fluidMesh::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    writeMesh(mesh(), mesh().points(), add);
    add
    (
        pointIOField
        (
            IOobject
            (
                "referencePoints", time_.timeName(), polyMesh::meshSubDir,
                mesh(), IOobject::NO_READ, IOobject::NO_WRITE, false
            ),
            referencePoints_
        )
    );
}


void Foam::fsbi::fluidMesh::save(dictionary& state) const
{
    motion_->save(state);
    state.set("referenceShift", referenceShift_);
    state.set("referenceGap", referenceGap_);
    state.set("fresh", fresh_.dict());
    state.set("neighbours", images_);
    state.set("images", imagesTaken());
    state.set("generation", generation_);
    state.set("withoutBodies", withoutBodies_);
}


void Foam::fsbi::fluidMesh::restore(const dictionary& saved)
{
    referenceShift_ = saved.get<vector>("referenceShift");
    referenceGap_ = saved.getOrDefault<scalar>("referenceGap", GREAT);
    generation_ = saved.get<label>("generation");
    images_ = saved.getOrDefault<List<vector>>("neighbours", {});
    takeImages
    (
        saved.getOrDefault<List<vector>>
        (
            "images", List<vector>(bodies_.size(), Zero)
        )
    );
    fresh_ = freshMesh(saved.subOrEmptyDict("fresh"));
    referencePoints_ = pointIOField
    (
        IOobject
        (
            "referencePoints", time_.timeName(), polyMesh::meshSubDir, mesh(),
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );

    const pointField now(mesh().points());
    mesh_->movePoints(referencePoints_);
    motion_.reset(new fluidMotion(mesh(), present_, saved, images_));
    measureReference();
    mesh_->movePoints(now);
    mesh_->moving(false);
}
