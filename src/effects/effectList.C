/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectList.H"
#include "namedDictionaries.H"

Foam::fsbi::effectList::effectList
(
    const effectContext& context,
    const List<List<triFace>>& triangles,
    timings& t,
    const dictionary& saved
)
:
    timings_(t),
    context_(context),
    triangles_(triangles)
{
    read(saved);
}


void Foam::fsbi::effectList::read(const dictionary& saved)
{
    const namedDictionaries file
    (
        context_.time, "effects", "an effect is name { ... }"
    );
    for (const entry* e : file.entries())
    {
        auto timer = timings_.profileMemory(e->keyword());
        effects_.append(effect::New(*e, context_));
    }
    restore(saved);
    if (effects_.empty())
    {
        Info<< "Warning: constant/effects holds no effect" << nl << endl;
    }
    else
    {
        Info<< "Effects: ";
        reportNames(Info);
        Info<< nl << endl;
    }
}


void Foam::fsbi::effectList::report(const word& patch, const string& what)
{
    if (told_.insert(patch))
    {
        Info<< "Warning: patch '" << patch << "' " << what.c_str() << nl << endl;
    }
}


void Foam::fsbi::effectList::setWalls(const List<domainWall>& walls)
{
    wordHashSet gone;
    for (const domainWall& wall : context_.walls)
    {
        gone.insert(wall.name);
    }
    for (const domainWall& wall : walls)
    {
        const label w = context_.findWall(wall.name);
        gone.erase(wall.name);
        if (w >= 0)
        {
            context_.walls[w] = wall;
        }
        else
        {
            report(wall.name, "has become a wall; effects do not see it");
        }
    }
    for (const word& name : gone.sortedToc())
    {
        report
        (
            name,
            "is no wall any more, by its velocity; effects still take it"
            " for one"
        );
    }
}


Foam::wordList Foam::fsbi::effectList::names() const
{
    wordList all(effects_.size());
    forAll(effects_, i)
    {
        all[i] = effects_[i].type();
    }
    return all;
}


Foam::wordList Foam::fsbi::effectList::confining() const
{
    DynamicList<word> some;
    for (const effect& e : effects_)
    {
        if (!e.periodic())
        {
            some.append(e.type());
        }
    }
    return wordList(some);
}


void Foam::fsbi::effectList::reportNames(Ostream& os) const
{
    forAll(effects_, i)
    {
        os << (i ? " " : "") << effects_[i].type().c_str();
    }
}


Foam::fsbi::loads Foam::fsbi::effectList::evaluate()
{
    loads acting(triangles_);
    culprit_.clear();
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.apply(acting);
        if (culprit_.empty() && !acting.finite())
        {
            culprit_ = e.type();
        }
    }
    return acting;
}


Foam::scalar Foam::fsbi::effectList::longestStep(string& reason) const
{
    scalar longest = GREAT;
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        string why;
        const scalar dt = e.longestStep(why);
        if (dt < longest)
        {
            longest = dt;
            reason = why;
        }
    }
    return longest;
}


Foam::scalar Foam::fsbi::effectList::nextInstant() const
{
    scalar next = GREAT;
    for (const effect& e : effects_)
    {
        next = min(next, e.nextInstant());
    }
    return next;
}


bool Foam::fsbi::effectList::steep() const
{
    for (const effect& e : effects_)
    {
        if (e.steep())
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::fsbi::effectList::clearPart
(
    const std::function<void(const scalar)>& place
) const
{
    scalar clear = 1;
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        const scalar before = clear;
        clear *= e.clearPart
        (
            [&](const scalar part) { place(before*part); }
        );
    }
    place(clear);
    return clear;
}


bool Foam::fsbi::effectList::fluctuates() const
{
    for (const effect& e : effects_)
    {
        if (e.fluctuates())
        {
            return true;
        }
    }
    return false;
}


Foam::fsbi::outcome Foam::fsbi::effectList::setResistance
(
    const freeResistance& resistance
)
{
    for (effect& e : effects_)
    {
        const outcome set
        (
            e.fluctuates() ? e.setResistance(resistance) : outcome()
        );
        if (!set)
        {
            return set;
        }
    }
    return outcome();
}


void Foam::fsbi::effectList::forget(const label bodyi)
{
    for (effect& e : effects_)
    {
        e.forget(bodyi);
    }
}


Foam::fsbi::outcome Foam::fsbi::effectList::acceptable() const
{
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        const outcome accepted(e.acceptable());
        if (!accepted)
        {
            return accepted;
        }
    }
    return outcome();
}


Foam::boolList Foam::fsbi::effectList::stopped() const
{
    boolList bodies(context_.bodies.size(), false);
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.markStopped(bodies);
    }
    return bodies;
}


void Foam::fsbi::effectList::declare(recording& history) const
{
    for (const effect& e : effects_)
    {
        e.declare(history);
    }
}


void Foam::fsbi::effectList::record(recording& history) const
{
    for (const effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.record(history);
    }
}


void Foam::fsbi::effectList::draw
(
    const std::function<void(const fileName&, const std::string&)>& add
) const
{
    for (const effect& e : effects_)
    {
        e.draw(add);
    }
}


void Foam::fsbi::effectList::beginStep()
{
    for (effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.beginStep();
    }
}


void Foam::fsbi::effectList::rewind()
{
    for (effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.rewind();
    }
}


void Foam::fsbi::effectList::endStep()
{
    for (effect& e : effects_)
    {
        auto timer = timings_.profileMemory(e.type());
        e.endStep();
    }
}


void Foam::fsbi::effectList::save(dictionary& state) const
{
    for (const effect& e : effects_)
    {
        dictionary dict;
        e.save(dict);
        state.set(e.type(), dict);
    }
}


void Foam::fsbi::effectList::restore(const dictionary& state)
{
    for (effect& e : effects_)
    {
        if (state.found(e.type()))
        {
            e.restore(state.subDict(e.type()));
        }
    }
}
