/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scene.H"
#include "Time.H"
#include "caseInput.H"
#include "HashSet.H"

namespace Foam
{
namespace fsbi
{

//- Is the region there?
static bool fluidGiven(const Time& time)
{
    bool given =
        isFile(time.globalPath()/time.constant()/caseInput::fluid/"material");
    Pstream::scatter(given);
    return given;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::scene::scene(const Time& time, const dictionary& saved)
:
    time_(time),
    inFluid_(fluidGiven(time)),
    bodies_(time, timings_, inFluid_, saved),
    traffic_(time, bodies_, saved.subOrEmptyDict("traffic"))
{
    checkParts();
    checkRegions();
    if (inFluid_)
    {
        fluid_.reset
        (
            new fluidRegion
            (
                time_, caseInput::fluid, bodies_.rigid, bodies_.immersed,
                timings_, saved.subOrEmptyDict("fluidMesh")
            )
        );
    }
    reportUnread();
    createCarried(saved.subOrEmptyDict("species"));
    createEffects(saved.subOrEmptyDict("effects"));
    if (fluid_ && bodies_.elastic.size())
    {
        coupling_ = couplingScheme::New(fluid_(), bodies_.elastic);
        keepApart();
    }
    if (fluid_)
    {
        checkHeld();
        traffic_.set(fluid_(), effects_.get());
    }
    listParticipants();
    if (coupling_ && saved.found("coupling"))
    {
        coupling_->restore(saved.subDict("coupling"));
    }
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
    for (body& any : bodies_.all())
    {
        join(any.name(), &any);
    }
    join("fluidMesh", fluid_.get());
    join("effects", effects_.get());
    join("coupling", coupling_.get());
    join("species", carried_.get());
}


void Foam::fsbi::scene::reportUnread() const
{
    wordList regions;
    if (fluid_)
    {
        regions.append(fluid_->name());
    }
    for (const solidRegion& solid : bodies_.elastic)
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
    List<List<triFace>> triangles(bodies_.immersed.size());
    forAll(bodies_.elastic, e)
    {
        triangles[bodies_.rigid.size() + e] =
            bodies_.elastic[e].surface().placedSurface().triangles();
    }
    effects_.reset
    (
        new effectList
        (
            {
                time_, bodies_.immersed, fluid_->walls(), fluid_->unseen(),
                gravities(), fluid_->meshing().images(), sitesOccupied()
            },
            triangles, timings_, saved
        )
    );
    checkFluctuations();
    for (const word& name : effects_->confining())
    {
        fluid_->confine("effect '" + name + "' sees no periodic images");
    }
    fluid_->setEffects(effects_());
}


Foam::fsbi::occupiedSitesOf Foam::fsbi::scene::sitesOccupied()
{
    if (!carried_)
    {
        return nullptr;
    }
    return [this]
    (
        const word& species, const word& surface, const dictionary& where
    ) -> const occupiedSites&
    {
        return carried_->occupied(species, surface, where);
    };
}


void Foam::fsbi::scene::keepApart()
{
    if (!steep())
    {
        return;
    }
    if (coupling_->type() != "monolithic")
    {
        const dictionary dict
        (
            fluid_->mesh().solutionDict().subDict("coupling")
        );
        FatalIOErrorInFunction(dict)
            << "Entry 'scheme' is '" << dict.get<word>("scheme")
            << "'; valid choices are (monolithic) in scenes of elastic bodies"
            << " and an effect of constant/effects that holds surfaces apart,"
            << " as contact does" << exit(FatalIOError);
    }
    coupling_->hold
    (
        autoPtr<surfacesApart>
        (
            new surfacesApart
            (
                effects_(), bodies_.rigid, bodies_.elastic,
                [this]{ return bodyRowsNow(); }
            )
        )
    );
}


Foam::List<Foam::string> Foam::fsbi::scene::gravities() const
{
    DynamicList<string> places;
    for (const momentumTerm& term : fluid_->momentum().terms())
    {
        if (term.buoyant())
        {
            places.append
            (
                "'" + term.type() + "' of constant/fluid/material has a force"
                " of type 'gravity'"
            );
        }
    }
    for (const solidRegion& solid : bodies_.elastic)
    {
        if (bodies_.entries(solid.name()).found("acceleration"))
        {
            places.append
            (
                "body '" + solid.name() + "' has 'acceleration' in"
                " constant/bodies"
            );
        }
    }
    return List<string>(places);
}


void Foam::fsbi::scene::createCarried(const dictionary& saved)
{
    if (!carriedByFlow::wanted(time_))
    {
        return;
    }
    if (!fluid_)
    {
        FatalErrorInFunction
            << "What constant/species names is dissolved in a fluid, but there is"
            << " no file constant/fluid/material" << exit(FatalError);
    }
    if (fluid_->reduced())
    {
        FatalErrorInFunction
            << "What constant/species names is carried by a flow, but method"
            << " 'reduced' (system/fluid/fvSolution) solves for none: take"
            << " 'coupled'" << exit(FatalError);
    }
    carried_ = carriedByFlow::New(fluid_(), saved);
    fluid_->setCarried(carried_());
    fluid_->confine("species are carried, to where no cell may have been");
    Info<< "Dissolved species: ";
    carried_->reportNames(Info);
    Info<< nl << endl;
}


void Foam::fsbi::scene::checkEffects() const
{
    if (!fluid_)
    {
        FatalErrorInFunction
            << "The effects of constant/effects act on bodies in a fluid, but"
            << " there is no file constant/fluid/material" << exit(FatalError);
    }
    for (const rigidBody& body : bodies_.rigid)
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


void Foam::fsbi::scene::checkParts() const
{
    const bool none = bodies_.all().empty();
    const bool solidsOnly = bodies_.elastic.size() == bodies_.all().size();
    if (!inFluid_ && (none || !solidsOnly))
    {
        FatalErrorInFunction
            << (none ? "There is no body in constant/bodies, and no"
               : "There is no") << " file constant/fluid/material, which rigid"
            << " and rolling bodies need; a scene without fluid has elastic"
            << " bodies only" << exit(FatalError);
    }
}


void Foam::fsbi::scene::checkHeld() const
{
    if (effects_ || fluid_->momentum().remembers())
    {
        return;
    }
    for (const polyPatch& pp : fluid_->mesh().boundaryMesh())
    {
        if (!pp.coupled() && !fluid_->meshing().isBody(pp.name()))
        {
            return;
        }
    }
    const auto has = [this](const body& any, const word& keyword)
    {
        return bodies_.entries(any.name()).found(keyword);
    };
    label free = 0;
    for (const rigidBody& body : bodies_.rigid)
    {
        free += body.overdamped() && !has(body, "constraints");
    }
    for (const solidRegion& solid : bodies_.elastic)
    {
        free += !has(solid, "tether") && !has(solid, "held");
    }
    if (free == bodies_.all().size())
    {
        FatalErrorInFunction
            << "Nothing holds the fluid: all sides of the domain are cyclic, no"
            << " body is held, and without inertia its velocity as a whole could"
            << " be any. Add a wall (system/blockMeshDict), hold a body"
            << " ('constraints' or 'tether' in constant/bodies), or give the fluid"
            << " 'inertia' (constant/fluid/material)" << exit(FatalError);
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
    if (inFluid_)
    {
        fluids.insert(caseInput::fluid);
    }
    for (const solidRegion& solid : bodies_.elastic)
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
