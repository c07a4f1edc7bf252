/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyTraffic.H"
#include "counterRandom.H"
#include "Time.H"

namespace Foam
{
namespace fsbi
{

//- Part of a step by which times may differ and still be the same
static const scalar sameTime = 1e-6;

//- Places drawn in a step before a body waits for the next one
static const label mostDraws = 20;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::bodyTraffic::bodyTraffic
(
    const Time& time, bodyList& bodies, const dictionary& saved
)
:
    time_(time),
    bodies_(bodies),
    rules_(bodies.immersed.size()),
    placed_(rules_.size(), 0),
    due_(rules_.size(), GREAT),
    told_(rules_.size(), false)
{
    checkFluid();
    forAll(rules_, b)
    {
        immersedBody& body = bodies_.immersed[b];
        const dictionary& entries = bodies_.entries(body.name());
        if (entries.found("enters"))
        {
            rules_[b] = readEntering(entries);
            body.setPresent(rules_[b].time <= 0);
            due_[b] = body.present() ? GREAT : rules_[b].time;
        }
        placed_[b] = body.present() ? 1 : 0;
    }
    if (saved.size())
    {
        restore(saved);
    }
}


void Foam::fsbi::bodyTraffic::checkFluid() const
{
    for (const body& any : bodies_.all())
    {
        const dictionary& entries = bodies_.entries(any.name());
        if (rules_.empty() && entries.found("enters"))
        {
            FatalIOErrorInFunction(entries)
                << "Body '" << any.name() << "' has an entry 'enters', but"
                << " there is no fluid (constant/fluid/material) that it could"
                << " come into" << exit(FatalIOError);
        }
    }
}


Foam::fsbi::bodyTraffic::entering Foam::fsbi::bodyTraffic::readEntering
(
    const dictionary& entries
)
{
    const checkedDictionary dict(checkedDictionary(entries).subDict("enters"));
    entering rule;
    rule.time = dict.getOrDefault<scalar>("time", 0);
    rule.again = dict.found("again") ? dict.get<scalar>("again") : -1;
    rule.anywhere = dict.found("min") || dict.found("max");
    if (rule.anywhere)
    {
        rule.box = boundBox(dict.get<point>("min"), dict.get<point>("max"));
        rule.seed = dict.getOrDefault<label>("seed", 1);
    }
    dict.finish();
    if (dict.found("again") && rule.again < 0)
    {
        FatalIOErrorInFunction(dict.dict())
            << "Entry 'again' is the time from leaving to entering anew and"
            << " must not be negative, but is " << rule.again
            << exit(FatalIOError);
    }
    if (rule.anywhere && !(cmptMin(rule.box.span()) >= 0))
    {
        FatalIOErrorInFunction(dict.dict())
            << "The box of 'enters' reaches from min " << rule.box.min()
            << " to max " << rule.box.max() << ": max must not be below min"
            << exit(FatalIOError);
    }
    return rule;
}


void Foam::fsbi::bodyTraffic::set(fluidRegion& fluid, effectList* effects)
{
    fluid_ = &fluid;
    effects_ = effects;
}


Foam::point Foam::fsbi::bodyTraffic::place(const label bodyi)
{
    const entering& rule = rules_[bodyi];
    const immersedBody& body = bodies_.immersed[bodyi];
    ++placed_[bodyi];
    if (!rule.anywhere)
    {
        return body.start();
    }
    counterRandom::stream draws
    (
        counterRandom(rule.seed, body.name() + "/enters").at(placed_[bodyi], 0)
    );
    point centre;
    for (direction d = 0; d < 3; ++d)
    {
        centre[d] =
            rule.box.min()[d] + draws.uniform()*rule.box.span()[d];
    }
    return centre;
}


void Foam::fsbi::bodyTraffic::letOut(const scalar dt)
{
    const wordList open(fluid_->openPatches());
    if (open.empty())
    {
        return;
    }
    forAll(rules_, b)
    {
        immersedBody& body = bodies_.immersed[b];
        const word patch
        (
            body.present() ? fluid_->meshing().reached(b, open, dt) : word()
        );
        if (patch.empty())
        {
            continue;
        }
        const scalar now = time_.value() - dt;
        Info<< "Body '" << body.name() << "' leaves through patch '" << patch
            << "' at the time " << now << endl;
        if (effects_)
        {
            effects_->forget(b);
        }
        passages_.append({b, false, body.placed().centre});
        body.setPresent(false);
        bodies_.moving[b].leave();
        due_[b] = rules_[b].again >= 0 ? now + rules_[b].again : GREAT;
    }
}


void Foam::fsbi::bodyTraffic::letIn(const scalar now)
{
    forAll(rules_, b)
    {
        immersedBody& body = bodies_.immersed[b];
        if (body.present() || due_[b] > now)
        {
            continue;
        }
        const label draws = rules_[b].anywhere ? mostDraws : 1;
        bool room = false;
        for (label i = 0; i < draws && !room; ++i)
        {
            bodies_.moving[b].enter(place(b));
            room = fluid_->meshing().hasRoom(body);
        }
        if (room)
        {
            const point centre(body.placed().centre);
            Info<< "Body '" << body.name() << "' enters at " << centre << endl;
            passages_.append({b, true, centre});
            body.setPresent(true);
            due_[b] = GREAT;
        }
        else if (!told_[b])
        {
            Info<< "Body '" << body.name() << "' waits: there is no room where"
                << " it is to enter" << endl;
        }
        told_[b] = !room;
    }
}


void Foam::fsbi::bodyTraffic::beginStep()
{
    if (!fluid_ || step_ == time_.timeIndex())
    {
        return;
    }
    step_ = time_.timeIndex();
    passages_.clear();
    const scalar dt = time_.deltaTValue();
    letOut(dt);
    letIn(time_.value() - (1 - sameTime)*dt);
}


bool Foam::fsbi::bodyTraffic::over() const
{
    bool any = rules_.empty();
    forAll(rules_, b)
    {
        any |= bodies_.immersed[b].present() || due_[b] < GREAT;
    }
    return !any;
}


void Foam::fsbi::bodyTraffic::save(dictionary& state) const
{
    boolList present(rules_.size());
    forAll(present, b)
    {
        present[b] = bodies_.immersed[b].present();
    }
    state.set("present", present);
    state.set("placed", placed_);
    state.set("due", due_);
}


void Foam::fsbi::bodyTraffic::restore(const dictionary& state)
{
    const boolList present(state.get<boolList>("present"));
    placed_ = state.get<labelList>("placed");
    due_ = state.get<scalarList>("due");
    forAll(present, b)
    {
        bodies_.immersed[b].setPresent(present[b]);
    }
}
