/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scene.H"
#include "prescribedBody.H"
#include "Time.H"
#include "caseInput.H"
#include "HashSet.H"

Foam::fsbi::scene::scene(const Time& time, const dictionary& saved)
:
    time_(time)
{
    const IOdictionary dict
    (
        IOobject
        (
            "bodies", time_.caseConstant(), time_, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        )
    );
    checkSaved(dict, saved);
    readBodies(dict, saved.subOrEmptyDict("bodies"));
    checkParts();
    checkRegions();
    if (fluidGiven())
    {
        createFluid(saved.subOrEmptyDict("fluidMesh"));
    }
    reportUnread();
    createEffects(saved.subOrEmptyDict("effects"));
    if (fluid_ && solids_.size())
    {
        coupling_ = couplingScheme::New(fluid_(), solids_);
    }
    listParticipants();
    if (coupling_ && saved.found("coupling"))
    {
        coupling_->restore(saved.subDict("coupling"));
    }
}


void Foam::fsbi::scene::createFluid(const dictionary& saved)
{
    for (rigidBody& body : bodies_)
    {
        immersed_.append(&body);
    }
    for (solidRegion& solid : solids_)
    {
        immersed_.append(&solid.surface());
    }
    for (prescribedBody& body : prescribed_)
    {
        immersed_.append(&body);
    }
    fluid_.reset
    (
        new fluidRegion
        (
            time_, caseInput::fluid, bodies_, immersed_, timings_, saved
        )
    );
}


void Foam::fsbi::scene::listParticipants()
{
    const auto join = [this](const word& name, stateful* participant)
    {
        if (participant)
        {
            participants_.push_back({name, participant});
        }
    };
    for (body& any : all_)
    {
        join(any.name(), &any);
    }
    join("fluidMesh", fluid_.get());
    join("effects", effects_.get());
    join("coupling", coupling_.get());
}


void Foam::fsbi::scene::reportUnread() const
{
    wordList regions;
    if (fluid_)
    {
        regions.append(fluid_->name());
    }
    for (const solidRegion& solid : solids_)
    {
        regions.append(solid.name());
    }
    caseInput::reportUnread(time_, regions);
}


void Foam::fsbi::scene::createEffects(const dictionary& saved)
{
    bool wanted = isFile(time_.globalPath()/time_.constant()/"effects");
    Pstream::scatter(wanted);
    if (!wanted)
    {
        return;
    }
    checkEffects();
    List<List<triFace>> triangles(immersed_.size());
    forAll(solids_, e)
    {
        triangles[bodies_.size() + e] =
            solids_[e].surface().placedSurface().triangles();
    }
    effects_.reset
    (
        new effectList
        (
            time_, immersed_, triangles, fluid_->walls(), fluid_->unseen(),
            fluid_->mu(), timings_, saved
        )
    );
    fluid_->setEffects(effects_());
}


void Foam::fsbi::scene::checkEffects() const
{
    if (!fluid_)
    {
        FatalErrorInFunction
            << "The effects of constant/effects act on bodies in a fluid, but"
            << " there is no file constant/fluid/material" << exit(FatalError);
    }
    for (const rigidBody& body : bodies_)
    {
        if (body.integrator() != "monolithic")
        {
            FatalErrorInFunction
                << "Body '" << body.name() << "' has the integrator '"
                << body.integrator() << "', but effects (constant/effects)"
                << " need 'monolithic'" << exit(FatalError);
        }
    }
}


bool Foam::fsbi::scene::fluidGiven() const
{
    bool given =
        isFile(time_.globalPath()/time_.constant()/caseInput::fluid/"material");
    Pstream::scatter(given);
    return given;
}


void Foam::fsbi::scene::checkParts() const
{
    if
    (
        !fluidGiven()
     && (bodies_.size() || prescribed_.size() || solids_.empty())
    )
    {
        const bool none =
            bodies_.empty() && prescribed_.empty() && solids_.empty();
        FatalErrorInFunction
            << (none ? "There is no body in constant/bodies, and no"
               : "There is no") << " file constant/fluid/material, which rigid"
            << " and rolling bodies need; a scene without fluid has elastic"
            << " bodies only" << exit(FatalError);
    }
}


void Foam::fsbi::scene::checkRegions() const
{
    const IOdictionary dict
    (
        IOobject
        (
            "regionProperties", time_.caseConstant(), time_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (!dict.found("regions") || dict.found("madeBy"))
    {
        return;         // there is none of the user's
    }
    const HashTable<wordList> regions(dict.lookup("regions"));
    wordHashSet fluids, solids;
    if (fluidGiven())
    {
        fluids.insert(caseInput::fluid);
    }
    for (const solidRegion& solid : solids_)
    {
        solids.insert(solid.name());
    }
    if
    (
        wordHashSet(regions.lookup("fluid", wordList())) != fluids
     || wordHashSet(regions.lookup("solid", wordList())) != solids
    )
    {
        FatalIOErrorInFunction(dict)
            << "The regions of the scene are fluid "
            << flatOutput(fluids.sortedToc()) << " and solid "
            << flatOutput(solids.sortedToc()) << ", by constant/fluid/material"
            << " and the elastic bodies of constant/bodies. Write the same"
            << " here, for OpenFOAM's tools, or remove the file"
            << exit(FatalIOError);
    }
}


void Foam::fsbi::scene::readBodies
(
    const dictionary& dict,
    const dictionary& saved
)
{
    const bool alone =
        dict.size() - dict.found("FoamFile") == 1 && !fluidGiven();
    for (const entry& e : dict)
    {
        if (e.keyword() == "FoamFile")
        {
            continue;
        }
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a body is"
                << " name { type rigidBody; shape {...} position (...); ... }"
                << exit(FatalIOError);
        }
        all_.append
        (
            body::New
            (
                {time_, timings_, e.keyword(), alone, fluidGiven()}, e.dict(),
                saved.subOrEmptyDict(e.keyword())
            )
        );
        sort(all_.last());
    }
}


void Foam::fsbi::scene::sort(body& any)
{
    if (auto* rigid = dynamic_cast<rigidBody*>(&any))
    {
        bodies_.append(rigid);
    }
    else if (auto* elastic = dynamic_cast<solidRegion*>(&any))
    {
        solids_.append(elastic);
    }
    else if (auto* given = dynamic_cast<prescribedBody*>(&any))
    {
        prescribed_.append(given);
    }
    else
    {
        FatalErrorInFunction
            << "Type '" << any.type() << "' of body '" << any.name()
            << "' is derived neither from rigidBody, solidRegion nor"
            << " prescribedBody: nobody would solve for it"
            << exit(FatalError);
    }
}


void Foam::fsbi::scene::checkSaved
(
    const dictionary& dict,
    const dictionary& saved
)
{
    wordHashSet now(dict.toc());
    now.erase("FoamFile");
    const wordHashSet then(saved.subOrEmptyDict("bodies").toc());
    if (saved.size() && now != then)
    {
        FatalIOErrorInFunction(dict)
            << "The bodies are no longer those of the saved state, which are "
            << flatOutput(then.sortedToc()) << ". Put them back, or start a"
            << " new run at time 0" << exit(FatalIOError);
    }
}
