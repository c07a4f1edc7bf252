/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bonds.H"
#include "addToRunTimeSelectionTable.H"
#include "units.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(bonds, 0);
    addToRunTimeSelectionTable(effect, bonds, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bonds::bonds(const dictionary& dict, const effectContext& context)
:
    effect(context),
    maxStretch_(1),
    dt_(0)
{
    const checkedDictionary entries(dict);
    const scalar kT =
        units(entries).Boltzmann()*entries.positive("temperature");
    const label seed = entries.get<label>("seed");
    if (seed < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'seed' must not be negative, but is " << seed
            << exit(FatalIOError);
    }
    maxStretch_ = entries.positive("maxStretch", 1);
    adhesion_.reset
    (
        new adhesion
        (
            entries.subDict("molecules"), entries.subDict("pairs"), context, kT,
            seed
        )
    );
    entries.finish();
    state_.slid.setSize(currentSurfaces(context).size(), Zero);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::Pair<Foam::point> Foam::fsbi::bonds::ends
(
    const currentSurfaces& surfaces, const bondMap::value_type& entry
) const
{
    const bond& b = entry.second;
    const adhesion::siteSet& s = adhesion_->sets()[entry.first.first];
    const label surface = adhesion_->surface(b.ligand);
    const point x(surfaces.position(s.body, s.sites[entry.first.second]));
    point y(bondStep::end(adhesion_(), surfaces, b));
    if (surfaces.isWall(surface))
    {
        y += dt_*surfaces.wall(surface).velocity;
    }
    return {x, surfaces.nearestImage(y, x)};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::bonds::apply(loads& l) const
{
    const currentSurfaces now(context_);
    const auto site = [&](const label body, const materialPoint& at)
    {
        return loads::site
        {
            body, at.triangle, now.position(body, at) - now.centre(body),
            at.weights()
        };
    };
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        const bondPair& pair = adhesion_->pairs()[b.pair];
        const adhesion::siteSet& s = adhesion_->sets()[entry.first.first];
        const materialPoint& start = s.sites[entry.first.second];
        const label other = adhesion_->surface(b.ligand);

        const Pair<point> at(ends(now, entry));
        const vector way(at.second() - at.first());
        const scalar distance = max(mag(way), VSMALL);
        const vector e(way/distance);
        const scalar f = pair.law->force(pair.length(at.first(), at.second()));
        const tensor along(e*e);
        l.add
        (
            {
                site(s.body, start),
                now.isWall(other) ? loads::site() : site(other, b.end),
                f*e,
                pair.law->s()*along
              + max(f/distance, scalar(0))*(tensor::I - along)
            }
        );
    }
}


void Foam::fsbi::bonds::beginStep()
{
    old_ = state_;
    events_ = left_;
    const scalar dt = context_.time.deltaTValue();
    const currentSurfaces now(context_);
    bondStep step
    (
        adhesion_(), now, state_, events_, context_.time.value() - dt
    );
    step.advance(dt);
    dt_ = dt;
}


void Foam::fsbi::bonds::rewind()
{
    state_ = old_;
    events_.clear();
    dt_ = 0;
}


void Foam::fsbi::bonds::endStep()
{
    const currentSurfaces now(context_);
    for (auto& entry : state_.bonds)
    {
        bond& b = entry.second;
        if (now.isPlane(adhesion_->surface(b.ligand)))
        {
            b.anchor = ends(now, entry).second();
        }
    }
    forAll(state_.slid, surface)
    {
        if (now.isWall(surface))
        {
            state_.slid[surface] += dt_*now.wall(surface).velocity;
        }
    }
    dt_ = 0;
    left_.clear();
}


void Foam::fsbi::bonds::forget(const label bodyi)
{
    const currentSurfaces now(context_);
    const scalar begin =
        context_.time.value() - context_.time.deltaTValue();
    for (auto b = state_.bonds.begin(); b != state_.bonds.end();)
    {
        const adhesion::siteSet& s = adhesion_->sets()[b->first.first];
        if (bodyi != s.body && bodyi != adhesion_->surface(b->second.ligand))
        {
            ++b;
            continue;
        }
        const Pair<point> at(ends(now, *b));
        const vector& image = now.toImage(s.body);
        const bondPair& pair = adhesion_->pairs()[b->second.pair];
        const scalar length = pair.length(at.first(), at.second());
        left_.append
        (
            bondEvent
            {
                begin, b->second.pair, b->first.first, b->first.second, false,
                length, pair.law->force(length),
                at.first() - image, at.second() - image
            }
        );
        b = state_.bonds.erase(b);
    }
}


void Foam::fsbi::bonds::save(dictionary& state) const
{
    adhesion_->save(state);
    labelList labels;
    scalarList numbers;
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        labels.append
        (
            labelList
            ({
                entry.first.first, entry.first.second, b.pair,
                b.ligand.population, b.ligand.i, b.ligand.j, b.end.triangle
            })
        );
        numbers.append
        (
            scalarList
            ({
                b.end.b, b.end.c, b.anchor.x(), b.anchor.y(), b.anchor.z()
            })
        );
    }
    state.set("labels", labels);
    state.set("numbers", numbers);

    labelList events;
    scalarList left;
    for (const auto& entry : state_.waitingTimes)
    {
        events.append
        (
            labelList
            ({
                entry.first.first, entry.first.second, entry.second.events
            })
        );
        left.append(entry.second.left);
    }
    state.set("events", events);
    state.set("left", left);
    state.set("slid", state_.slid);
}


void Foam::fsbi::bonds::restore(const dictionary& state)
{
    const labelList labels(state.get<labelList>("labels"));
    const scalarList numbers(state.get<scalarList>("numbers"));
    // states of before molecules were counted have fewer labels of a bond
    bool fits =
        adhesion_->restore(state)
     && state.readIfPresent("slid", state_.slid)
     && 7*numbers.size() == 5*labels.size();
    state_.bonds.clear();
    for (label n = 0; fits && 7*n < labels.size(); ++n)
    {
        const label* l = &labels[7*n];
        const scalar* x = &numbers[5*n];
        bond b;
        b.pair = l[2];
        b.ligand = {l[3], l[4], l[5]};
        b.end = {l[6], x[0], x[1]};
        b.anchor = point(x[2], x[3], x[4]);
        fits = adhesion_->holds(l[0], l[1], b.pair, b.ligand.population);
        state_.bonds.insert({{l[0], l[1]}, b});
    }
    if (!fits)
    {
        FatalErrorInFunction
            << "The saved bonds do not fit the molecules and pairs of"
            << " constant/effects, which must not change at a restart"
            << exit(FatalError);
    }
    const labelList events(state.get<labelList>("events"));
    const scalarList left(state.get<scalarList>("left"));
    state_.waitingTimes.clear();
    forAll(left, i)
    {
        state_.waitingTimes[{events[3*i], events[3*i + 1]}] =
            {events[3*i + 2], left[i]};
    }
}
