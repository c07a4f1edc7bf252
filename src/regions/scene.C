/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scene.H"
#include "Time.H"
#include "untrapped.H"
#include "IFstream.H"
#include "HashSet.H"

Foam::fsbi::scene::scene(const Time& time, const dictionary& saved)
:
    time_(time)
{
    readBodies(saved);
    fluid_.reset
    (
        new fluidRegion
        (
            time, bodies_, timings_, saved.subOrEmptyDict("fluidMesh")
        )
    );
}


void Foam::fsbi::scene::checkNames(const fileName& file)
{
    // OpenFOAM would merge two bodies of one name
    IFstream is(file);
    wordHashSet names;
    word last;
    label depth = 0;
    token t;
    while (is.good() && !is.read(t).bad() && t.good())
    {
        if (t.isPunctuation() && t.pToken() == token::BEGIN_BLOCK)
        {
            if (depth++ == 0 && !names.insert(last))
            {
                FatalIOErrorInFunction(is)
                    << "There are two bodies with the name '" << last << "'"
                    << exit(FatalIOError);
            }
        }
        else if (t.isPunctuation() && t.pToken() == token::END_BLOCK)
        {
            --depth;
        }
        else if (t.isWord())
        {
            last = t.wordToken();
        }
    }
}


void Foam::fsbi::scene::readBodies(const dictionary& saved)
{
    const IOdictionary dict
    (
        IOobject
        (
            "bodies", time_.caseConstant(), time_, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        )
    );
    if (isFile(dict.objectPath()) && Pstream::master())
    {
        checkNames(dict.objectPath());
    }
    checkSaved(dict, saved);
    bodies_.setSize(dict.size() - dict.found("FoamFile"));
    const dictionary& savedBodies = saved.subOrEmptyDict("bodies");
    label b = 0;
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
        bodies_.set
        (
            b++,
            new rigidBody
            (
                e.keyword(), e.dict(), savedBodies.subOrEmptyDict(e.keyword())
            )
        );
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


bool Foam::fsbi::scene::solve()
{
    const untrapped scope;
    List<bodyRows> rows(bodies_.size());
    forAll(rows, b)
    {
        rows[b] = bodies_[b].rows(time_.value());
    }
    List<sixVector> loads;
    const label before = report_.iterations;
    report_ = fluid_->solve(rows, loads);
    report_.iterations += before;
    bool finite = std::isfinite(report_.residual);
    forAll(rows, b)
    {
        bodies_[b].set(rows[b].velocity, loads[b]);
    }
    for (const sixVector& load : loads)
    {
        for (const scalar component : load)
        {
            finite = finite && std::isfinite(component);
        }
    }
    if (!finite)
    {
        failure_ = "the solution is not finite: the scene has numbers that are"
            " too large, or cells that are too thin";
    }
    else if (!report_.converged)
    {
        failure_ =
            "the solver reached a residual of " + name(report_.residual)
          + " only, in " + name(report_.iterations) + " iterations";
    }
    return finite && report_.converged;
}


bool Foam::fsbi::scene::advance()
{
    failure_.clear();
    report_ = solverReport();
    bool extrapolated = true;
    for (const rigidBody& body : bodies_)
    {
        extrapolated &= body.hasHistory();
    }
    // without a history the first pass only finds the velocity to place with
    for (label pass = extrapolated ? 1 : 0; pass < 2; ++pass)
    {
        for (rigidBody& body : bodies_)
        {
            body.advance(time_.deltaTValue());
        }
        if (!fluid_->follow(failure_) || !solve())
        {
            return false;
        }
    }
    return true;
}


void Foam::fsbi::scene::beginStep()
{
    for (rigidBody& body : bodies_)
    {
        body.beginStep();
    }
    fluid_->beginStep();
}


void Foam::fsbi::scene::rewind()
{
    for (rigidBody& body : bodies_)
    {
        body.rewind();
    }
    fluid_->rewind();
}


void Foam::fsbi::scene::endStep()
{
    for (rigidBody& body : bodies_)
    {
        body.endStep();
    }
}


void Foam::fsbi::scene::save(dictionary& state) const
{
    dictionary bodies;
    for (const rigidBody& body : bodies_)
    {
        dictionary dict;
        body.save(dict);
        bodies.set(body.name(), dict);
    }
    state.set("bodies", bodies);
    dictionary mesh;
    fluid_->meshing().save(mesh);
    state.set("fluidMesh", mesh);
}


Foam::scalar Foam::fsbi::scene::smallestGap() const
{
    return fluid_->meshing().smallestGap();
}
