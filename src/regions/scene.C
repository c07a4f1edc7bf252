/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scene.H"
#include "Time.H"

Foam::fsbi::scene::scene(const Time& time)
:
    time_(time)
{
    readBodies();
    fluid_.reset(new fluidRegion(time, bodies_, timings_));
}


void Foam::fsbi::scene::readBodies()
{
    const IOdictionary dict
    (
        IOobject
        (
            "bodies", time_.caseConstant(), time_, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        )
    );
    bodies_.setSize(dict.size() - dict.found("FoamFile"));
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
        bodies_.set(b++, new rigidBody(e.keyword(), e.dict()));
    }
}


bool Foam::fsbi::scene::solve()
{
    List<bodyRows> rows(bodies_.size());
    forAll(rows, b)
    {
        rows[b] = bodies_[b].rows(time_.value());
    }
    List<sixVector> loads;
    const label before = report_.iterations;
    report_ = fluid_->solve(rows, loads);
    report_.iterations += before;
    forAll(rows, b)
    {
        bodies_[b].set(rows[b].velocity, loads[b]);
    }
    if (!report_.converged)
    {
        failure_ =
            "the solver reached a residual of " + name(report_.residual)
          + " only, in " + name(report_.iterations) + " iterations";
    }
    return report_.converged;
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
}


void Foam::fsbi::scene::rewind()
{
    for (rigidBody& body : bodies_)
    {
        body.rewind();
    }
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
    for (const rigidBody& body : bodies_)
    {
        dictionary dict;
        body.save(dict);
        state.set(body.name(), dict);
    }
    dictionary mesh;
    fluid_->meshing().save(mesh);
    state.set("fluidMesh", mesh);
}


void Foam::fsbi::scene::restore(const dictionary& state)
{
    for (rigidBody& body : bodies_)
    {
        body.restore(state.subDict(body.name()));
    }
}


Foam::scalar Foam::fsbi::scene::smallestGap() const
{
    return fluid_->meshing().smallestGap();
}
