/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magnetics.H"
#include "addToRunTimeSelectionTable.H"
#include "saturated.H"

using Foam::constant::mathematical::twoPi;

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(magnetics, 0);
addToRunTimeSelectionTable(effect, magnetics, entries);

//- Halvings of a step, from the longest, that are looked at
static const label nHalvings = 20;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::magnetics::magnetics
(
    const dictionary& dict, const effectContext& context
)
:
    effect(context),
    units_(checkedDictionary(dict)),
    fields_
    (
        dict.found("controller")
      ? checkedDictionary(dict).subDictOrEmpty("fields")
      : checkedDictionary(dict).subDict("fields"),
        units_
    ),
    interaction_(dict.found("interaction")),
    stepsPerTurn_(checkedDictionary(dict).positive("stepsPerTurn", 40))
{
    const checkedDictionary entries(dict);
    for (const word key : {"units", "fields", "stepsPerTurn", "libs"})
    {
        entries.found(key);
    }
    if (entries.found("interaction"))
    {
        checkedDictionary(entries.subDict("interaction")).finish();
    }
    readBodies(entries.subDict("bodies"));
    if (entries.found("controller"))
    {
        readController(entries.subDict("controller"));
    }
    entries.finish();
}


void Foam::fsbi::magnetics::readController(const dictionary& dict)
{
    controller_.reset(new controller(dict, context_, units_));
    for (const label b : controller_->bodies())
    {
        wordList turning;
        bool turns = false;
        forAll(magnets_, i)
        {
            if (!isA<saturated>(magnets_[i].law()))
            {
                turning.append(body(i).name());
                turns = turns || magnets_[i].body == b;
            }
        }
        if (!turns)
        {
            FatalIOErrorInFunction(dict)
                << "A turning field does not turn the body '"
                << context_.bodies[b].name() << "': it is not magnetic, or"
                << " without a preferred axis; bodies that it turns are "
                << flatOutput(turning) << exit(FatalIOError);
        }
    }
}


void Foam::fsbi::magnetics::readBodies(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a magnetic"
                << " body is name { type ...; }" << exit(FatalIOError);
        }
        const label b = context_.bodyIndex(e.keyword(), dict);
        const immersedBody& body = context_.bodies[b];
        const vector B
        (
            fields_.B(body.placed().centre, context_.time.value())
        );
        magnets_.append
        (
            new magnet
            {
                b, magnetisation::New(e.dict()),
                body.placedSurface().volume()/pow3(units_.metre()),
                mag(B), phaseLag(B)
            }
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsbi::magnetics::givenB
(
    const point& x, const scalar t
) const
{
    const vector B(fields_.B(x, t));
    return controller_.valid() ? B + controller_->B(x, t) : B;
}


Foam::tensor Foam::fsbi::magnetics::givenGradient
(
    const point& x, const scalar t
) const
{
    const tensor G(fields_.gradient(x, t));
    return controller_.valid() ? G + controller_->gradient(x, t) : G;
}


bool Foam::fsbi::magnetics::follows
(
    const magnet& m, const point& x, const scalar dt
) const
{
    const scalar t = context_.time.value();
    const vector now(fields_.B(x, t)), then(fields_.B(x, t + dt));
    return
        mag(then - now) <= twoPi/stepsPerTurn_*max(m.largestB, mag(then));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::magnetics::longestStep(string& reason) const
{
    reason = "the magnetic field changes";
    scalar longest = GREAT;
    for (const magnet& m : magnets_)
    {
        const point x(context_.bodies[m.body].placed().centre);
        // from the shortest on: a field may be back after a whole turn
        scalar dt = 2*context_.time.deltaTValue()/(1 << nHalvings);
        label n = 0;
        while (m.largestB > 0 && n <= nHalvings && follows(m, x, dt))
        {
            dt *= 2;
            ++n;
        }
        if (m.largestB > 0 && n <= nHalvings)
        {
            longest = min(longest, 0.5*dt);
        }
    }
    if (controller_.valid())
    {
        longest = min(longest, controller_->longestStep(stepsPerTurn_));
    }
    return longest;
}


Foam::scalar Foam::fsbi::magnetics::nextInstant() const
{
    return controller_.valid() ? controller_->nextInstant() : GREAT;
}


void Foam::fsbi::magnetics::declare(recording& history) const
{
    forAll(magnets_, i)
    {
        history.declare
        (
            "magnetics/" + body(i).name(),
            {
                "Bx", "By", "Bz", "mx", "my", "mz", "fx", "fy", "fz",
                "tx", "ty", "tz", "angle", "lag", "slips"
            },
            "B: tesla, m: A m^2, f: M L/T^2, t: M L^2/T^2, angle: rad, lag: rad"
        );
    }
    if (controller_.valid())
    {
        controller_->declare(history);
    }
}


void Foam::fsbi::magnetics::record(recording& history) const
{
    const List<state> all(states());
    const scalar J = units_.joule();
    forAll(all, i)
    {
        const state& s = all[i];
        const vector f(J*(s.gradient & s.m)), t(J*(s.m ^ s.B));
        const phaseLag& lag = magnets_[i].lag;
        history.append
        (
            "magnetics/" + body(i).name(),
            scalarList
            ({
                s.B.x(), s.B.y(), s.B.z(), s.m.x(), s.m.y(), s.m.z(),
                f.x(), f.y(), f.z(), t.x(), t.y(), t.z(),
                std::atan2(mag(s.m ^ s.B), s.m & s.B), lag.angle(),
                scalar(lag.slips())
            })
        );
    }
    if (controller_.valid())
    {
        controller_->record(history);
    }
}


void Foam::fsbi::magnetics::beginStep()
{
    if (controller_.valid())
    {
        controller_->beginStep();
    }
}


void Foam::fsbi::magnetics::endStep()
{
    const List<state> all(states());
    const scalar t = context_.time.value();
    forAll(all, i)
    {
        // where there is no field nothing can lag
        if (mag(all[i].B) > 0)
        {
            magnets_[i].lag.update(all[i].B, all[i].m);
        }
        magnets_[i].largestB =
            max(magnets_[i].largestB, mag(fields_.B(all[i].x, t)));
    }
    if (controller_.valid())
    {
        controller_->endStep();
    }
}


void Foam::fsbi::magnetics::save(dictionary& state) const
{
    forAll(magnets_, i)
    {
        dictionary dict;
        dict.set("volume", magnets_[i].volume);
        dict.set("largestB", magnets_[i].largestB);
        dictionary lag;
        magnets_[i].lag.save(lag);
        dict.set("lag", lag);
        state.set(body(i).name(), dict);
    }
    if (controller_.valid())
    {
        dictionary dict;
        controller_->save(dict);
        state.set("controller", dict);
    }
}


void Foam::fsbi::magnetics::restore(const dictionary& state)
{
    forAll(magnets_, i)
    {
        const dictionary* dict = state.findDict(body(i).name());
        if (dict)
        {
            magnets_[i].volume = dict->get<scalar>("volume");
            magnets_[i].largestB = dict->get<scalar>("largestB");
            magnets_[i].lag.restore(dict->subDict("lag"));
        }
    }
    const dictionary* dict = state.findDict("controller");
    if (controller_.valid() && dict)
    {
        controller_->restore(*dict);
    }
}
