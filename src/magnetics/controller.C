/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controller.H"
#include "mathematicalConstants.H"
#include "quaternion.H"

using Foam::constant::mathematical::twoPi;

namespace Foam
{
namespace fsbi
{

//- Bodies count as alike if their speeds' smallest singular value is less than
//  this part of the largest: times would be a hundred times what they could be
static const scalar alike = 0.01;

//- Turns for which a mode goes on: fewer are not surer than the part of a turn
//  that a change of mode makes
static const scalar worthwhile = 0.3;

//- Sine of the angle to the axis below which a field says no direction
static const scalar along = 1e-3;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::controller::controller
(
    const dictionary& dict, const effectContext& context, const units& u
)
:
    context_(context),
    normal_(Zero),
    next_(0),
    leg_(0),
    lastLeg_(0),
    arrived_(false),
    told_(true)
{
    const checkedDictionary entries(dict);
    rolling_ = entries.choice("drive", {"rolling", "swimming"}) == "rolling";
    if (rolling_)
    {
        normal_ = entries.direction("normal");
    }
    magnitude_ = entries.positive("magnitude");
    frequencies_ = entries.get<scalarList>("frequencies");
    period_ = entries.positive("period");
    tolerance_ = entries.positive("tolerance");
    maxCurrent_ = entries.positive("maxCurrent");
    coils_.reset
    (
        new coilSet
        (
            entries.subDict("coils"), entries.get<point>("place"), u
        )
    );
    readBodies(entries);
    entries.finish();
    checkLaw(dict);
    checkCurrents(dict);
    measure(context_.time.value());
}


void Foam::fsbi::controller::readBodies(const checkedDictionary& entries)
{
    const dictionary& dict = entries.subDict("bodies");
    scalarList advances, stepOuts;
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: a body to"
                << " be steered is name { target ...; advance ...; stepOut"
                << " ...; }" << exit(FatalIOError);
        }
        const checkedDictionary body(e.dict());
        bodies_.append(context_.bodyIndex(e.keyword(), dict));
        points_.append(body.getOrDefault<pointField>("via", pointField()));
        points_.last().append(body.get<point>("target"));
        lastLeg_ = max(lastLeg_, points_.last().size() - 1);
        advances.append(body.get<scalar>("advance"));
        stepOuts.append(body.positive("stepOut"));
        body.finish();
        if (mag(advances.last()) < VSMALL)
        {
            FatalIOErrorInFunction(e.dict())
                << "Entry 'advance' is zero: no field would move '"
                << e.keyword() << "'" << exit(FatalIOError);
        }
    }
    if (bodies_.empty() || frequencies_.size() < bodies_.size())
    {
        FatalIOErrorInFunction(entries.dict())
            << "There are " << bodies_.size() << " bodies to be steered and "
            << frequencies_.size() << " frequencies; there must be a body, and"
            << " as many frequencies as bodies" << exit(FatalIOError);
    }
    for (const scalar f : frequencies_)
    {
        if (!(f > 0))
        {
            FatalIOErrorInFunction(entries.dict())
                << "Entry 'frequencies' has " << f << "; they must be above"
                << " zero" << exit(FatalIOError);
        }
    }
    law_.reset(new steeringLaw(frequencies_, advances, stepOuts));
}


void Foam::fsbi::controller::checkLaw(const dictionary& where) const
{
    if (law_->distinction() > alike)
    {
        return;
    }
    string speeds;
    forAll(bodies_, i)
    {
        speeds += "\n    " + context_.bodies[bodies_[i]].name() + ':';
        forAll(frequencies_, k)
        {
            speeds += ' ' + Foam::name(law_->speed(i, k));
        }
    }
    FatalIOErrorInFunction(where)
        << "Bodies answer alike at all frequencies, and cannot be steered to"
        << " different targets: let there be a frequency between those at"
        << " which they step out. Speeds:" << speeds.c_str()
        << exit(FatalIOError);
}


void Foam::fsbi::controller::checkCurrents(const dictionary& where) const
{
    forAll(coils_->names(), i)
    {
        const scalar most = magnitude_*coils_->mostPerField(i);
        if (most > maxCurrent_)
        {
            FatalIOErrorInFunction(where)
                << "A field of " << magnitude_ << " T takes up to " << most
                << " A in coil '" << coils_->names()[i] << "', more than"
                << " maxCurrent, " << maxCurrent_ << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fsbi::controller::order& Foam::fsbi::controller::orderAt
(
    const scalar t
) const
{
    return t > now_.start + sameTime() ? now_ : last_;
}


Foam::vector Foam::fsbi::controller::direction
(
    const order& o, const scalar t
) const
{
    if (o.mode < 0 || t > o.stop + sameTime())
    {
        return Zero;
    }
    const scalar turns = frequencies_[o.mode]*(t - o.start);
    return quaternion(o.axis, twoPi*turns).transform(o.from);
}


Foam::scalarField Foam::fsbi::controller::currents(const scalar t) const
{
    return coils_->currents(magnitude_*direction(orderAt(t), t));
}


Foam::labelList Foam::fsbi::controller::present() const
{
    DynamicList<label> here;
    forAll(bodies_, i)
    {
        if (context_.bodies[bodies_[i]].present())
        {
            here.append(i);
        }
    }
    return labelList(std::move(here));
}


Foam::vectorField Foam::fsbi::controller::displacements() const
{
    vectorField result(bodies_.size(), Zero);
    for (const label i : present())
    {
        result[i] =
            points_[i][min(leg_, points_[i].size() - 1)]
          - context_.bodies[bodies_[i]].placed().centre;
        result[i] -= (result[i] & normal_)*normal_;
    }
    return result;
}


bool Foam::fsbi::controller::there() const
{
    return max(mag(displacements())) <= tolerance_;
}


Foam::vector Foam::fsbi::controller::axisFor(const vector& heading) const
{
    return rolling_ ? vector(normal_ ^ heading) : heading;
}


Foam::vector Foam::fsbi::controller::begin
(
    const vector& axis, const vector& was
) const
{
    // without a field before: from the wall's normal, or any
    for (const vector& v : {was, normal_, vector(0, 0, 1), vector(1, 0, 0)})
    {
        const vector across(v - (v & axis)*axis);
        if (mag(across) > along)
        {
            return across/mag(across);
        }
    }
    return Zero;
}


Foam::label Foam::fsbi::controller::chosen(const vectorField& times) const
{
    scalarField turns(mag(times));
    forAll(turns, k)
    {
        turns[k] *= frequencies_[k];
    }
    return
        last_.mode >= 0 && turns[last_.mode] > worthwhile
      ? last_.mode
      : findMax(turns);
}


void Foam::fsbi::controller::measure(const scalar t)
{
    const labelList here(present());
    while (leg_ < lastLeg_ && here.size() && there())
    {
        ++leg_;
    }
    const bool arrived = there();
    const vector was
    (
        now_.mode < 0 ? now_.from : direction(now_, min(t, now_.stop))
    );
    last_ = now_;
    now_ = order();
    now_.from = was;
    now_.start = now_.stop = t;
    next_ = t + period_;
    if (!arrived)
    {
        const vectorField times(law_->times(displacements(), here));
        const label mode = chosen(times);
        now_.mode = mode;
        now_.stop = t + min(mag(times[mode]), period_);
        now_.heading = times[mode]/mag(times[mode]);
        now_.axis = axisFor(now_.heading);
        now_.from = begin(now_.axis, was);
    }
    told_ = arrived && arrived_;
    arrived_ = arrived;
}


void Foam::fsbi::controller::report() const
{
    Info<< "Controller at " << now_.start << ": ";
    if (now_.mode < 0)
    {
        Info<< (present().empty() ? "no body is there" : "all are at their targets");
    }
    else
    {
        Info<< "frequency " << frequencies_[now_.mode] << " for "
            << now_.stop - now_.start << " heading " << now_.heading
            << ", currents from "
            << coils_->currents(magnitude_*now_.from);
    }
    if (lastLeg_ > 0)
    {
        Info<< ", leg " << leg_ + 1 << " of " << lastLeg_ + 1;
    }
    Info<< ", distances";
    const scalarField distances(mag(displacements()));
    for (const label i : present())
    {
        Info<< ' ' << context_.bodies[bodies_[i]].name() << ' ' << distances[i];
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::controller::longestStep
(
    const scalar stepsPerTurn
) const
{
    return turns() ? 1/(stepsPerTurn*frequencies_[now_.mode]) : GREAT;
}


void Foam::fsbi::controller::beginStep()
{
    if (!told_)
    {
        report();
        told_ = true;
    }
}


void Foam::fsbi::controller::endStep()
{
    const scalar t = context_.time.value();
    if (t >= next_ - sameTime())
    {
        measure(t);
    }
}


void Foam::fsbi::controller::declare(recording& history) const
{
    wordList columns;
    for (const word& name : coils_->names())
    {
        columns.append("I." + name);
    }
    columns.append(wordList({"mode", "hx", "hy", "hz", "leg"}));
    for (const label b : bodies_)
    {
        columns.append("distance." + context_.bodies[b].name());
    }
    history.declare("magnetics/controller", columns, "I: A, distance: L");
}


void Foam::fsbi::controller::record(recording& history) const
{
    const scalar t = context_.time.value();
    const order& o = orderAt(t);
    const bool on = mag(direction(o, t)) > 0;
    scalarList row(currents(t));
    row.append
    (
        scalarList
        ({
            scalar(on ? o.mode + 1 : 0),
            o.heading.x(), o.heading.y(), o.heading.z(),
            scalar(leg_ + 1)
        })
    );
    row.append(mag(displacements())());
    history.append("magnetics/controller", row);
}


void Foam::fsbi::controller::save(dictionary& state) const
{
    state.set("next", next_);
    state.set("leg", leg_);
    state.set("arrived", arrived_);
    state.set("told", told_);
    for (const bool last : {true, false})
    {
        const order& o = last ? last_ : now_;
        dictionary dict;
        dict.set("mode", o.mode);
        dict.set("start", o.start);
        dict.set("stop", o.stop);
        dict.set("heading", o.heading);
        dict.set("axis", o.axis);
        dict.set("from", o.from);
        state.set(last ? "last" : "now", dict);
    }
}


void Foam::fsbi::controller::restore(const dictionary& state)
{
    next_ = state.get<scalar>("next");
    leg_ = state.get<label>("leg");
    arrived_ = state.get<bool>("arrived");
    told_ = state.get<bool>("told");
    for (const bool last : {true, false})
    {
        order& o = last ? last_ : now_;
        const dictionary& dict = state.subDict(last ? "last" : "now");
        o.mode = dict.get<label>("mode");
        o.start = dict.get<scalar>("start");
        o.stop = dict.get<scalar>("stop");
        o.heading = dict.get<vector>("heading");
        o.axis = dict.get<vector>("axis");
        o.from = dict.get<vector>("from");
    }
}
