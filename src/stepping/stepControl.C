/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "checkedDictionary.H"

namespace
{

//- Part of a step by which times may differ and still be the same
const Foam::scalar sameTime = 1e-6;

//- Part of a step that the last one is longer, rather than that another follows:
//  times are written with six digits
const Foam::scalar shortestRest = 1e-4;

//- Shorter steps tried, where one fails, to end an interrupted run with
const Foam::label maxLastTries = 1;

//- Time::run(), which would also call function objects, before the state of
//  the step is saved
bool running(const Foam::Time& time)
{
    return time.value() < time.endTime().value() - 0.5*time.deltaTValue();
}

} // End anonymous namespace


Foam::fsbi::stepControl::stepControl(Time& time, const argList& args)
:
    time_(time),
    wallTime_(args),
    progress_(time),
    chosen_(time.deltaTValue()),
    gridTime_(-GREAT),
    outputs_(outputsUntil(time.value())),
    before_(time),
    endBefore_(time.endTime().value()),
    retry_(false),
    stop_(false),
    lastTries_(0),
    leftOver_(0)
{
    if (adjustable())
    {
        limiters_ = stepLimiter::all(time.controlDict());
        shortest();     // a default that is noted from the start
    }
}


bool Foam::fsbi::stepControl::adjustable() const
{
    return time_.controlDict().getOrDefault("adjustTimeStep", false);
}


bool Foam::fsbi::stepControl::periodicOutput() const
{
    const word control
    (
        time_.controlDict().getOrDefault<word>("writeControl", "timeStep")
    );
    return
        control == "runTime" || control == "adjustable"
     || control == "adjustableRunTime";
}


Foam::scalar Foam::fsbi::stepControl::writeInterval() const
{
    return
        time_.controlDict().getOrDefault<scalar>("writeInterval", GREAT);
}


Foam::scalar Foam::fsbi::stepControl::shortest() const
{
    return checkedDictionary(time_.controlDict()).positive
    (
        "minDeltaT", 1e-6*time_.controlDict().get<scalar>("deltaT")
    );
}


Foam::label Foam::fsbi::stepControl::outputsUntil(const scalar time) const
{
    return periodicOutput()
      ? label
        (
            time/writeInterval()
          + sameTime*min(time_.deltaTValue()/writeInterval(), scalar(1))
        )
      : 0;
}


Foam::fsbi::stepWish Foam::fsbi::stepControl::longest(const scene& scene)
{
    if (limiters_.empty())      // adjustTimeStep was switched on in the run
    {
        limiters_ = stepLimiter::all(time_.controlDict());
    }
    const stepSituation at
    (
        {scene, chosen_, time_.timeIndex() == 0, shortest()}
    );
    stepWish wish;
    for (const stepLimiter& limiter : limiters_)
    {
        limiter.limit(at, wish);
    }
    return wish;
}


Foam::scalar Foam::fsbi::stepControl::fitted
(
    const scene& scene, const scalar dt
) const
{
    const scalar now = time_.value();
    scalar target = time_.endTime().value();
    if (periodicOutput())
    {
        const scalar interval = writeInterval();
        const scalar nextOutput = (outputs_ + 1)*interval;
        // not onto a remainder before the end time
        if (nextOutput < target - sameTime*dt)
        {
            target = nextOutput;
        }
    }
    if (scene.effects())
    {
        const scalar instant = scene.effects()->nextInstant();
        if (instant < target - sameTime*dt)
        {
            target = instant;
        }
    }
    const scalar steps = (target - now)/dt;
    return
        steps > sameTime && steps < labelMax
      ? (target - now)/std::ceil(steps - sameTime)
      : dt;
}


void Foam::fsbi::stepControl::choose(const scene& scene)
{
    if (adjustable())
    {
        const stepWish wish(longest(scene));
        chosen_ = wish.length;
        limit_ = wish.reason;
        time_.setDeltaT(fitted(scene, chosen_), false);
        return;
    }
    const scalar deltaT = time_.controlDict().get<scalar>("deltaT");
    if (time_.value() < gridTime_ - sameTime*deltaT)
    {
        limit_ = "a rejected step";
    }
    else
    {
        gridTime_ = -GREAT;
        chosen_ = deltaT;
        limit_ = "deltaT";
    }
    const scalar left = time_.endTime().value() - time_.value();
    // a step that ends there but for round-off is the same in a run that goes on
    const bool last =
        left > sameTime*deltaT && left < (1 + shortestRest)*chosen_
     && mag(left - chosen_) > sameTime*chosen_;
    limit_ = last && left < chosen_ ? "endTime" : limit_;
    time_.setDeltaT(last ? left : chosen_, false);
}


bool Foam::fsbi::stepControl::next(const scene& scene)
{
    if (!retry_)
    {
        if (stop_)
        {
            return false;
        }
        progress_.begin();
        wallTime_.begin();
        outputs_ = outputsUntil(time_.value());
        choose(scene);
        if (!running(time_))
        {
            return false;
        }
        time_.readModifiedObjects();
        if (!running(time_))
        {
            return false;
        }
        beginStep();
    }
    retry_ = false;
    ++time_;
    return true;
}


void Foam::fsbi::stepControl::reject(const scene& scene, const outcome& step)
{
    const scalar dt = 0.5*time_.deltaTValue();
    const string why(hopeless(scene));
    Info<< "Step to " << time_.timeName() << " rejected: "
        << step.reason.c_str() << endl;
    if (dt < shortest() || why.size())
    {
        FatalErrorInFunction
            << "Steps down to " << 2*dt << " fail, the last one because "
            << step.reason.c_str() << why.c_str() << ". Saved states are"
            << " untouched; minDeltaT in " << time_.controlDict().name()
            << " is " << shortest() << exit(FatalError);
    }
    // a shorter step may do to end with; if not, the mesh is that of a failed one
    if (interruption_.asked() && ++lastTries_ > maxLastTries)
    {
        FatalErrorInFunction
            << "Interrupted while steps fail, the last one because "
            << step.reason.c_str() << ". 'startFrom latestTime' continues"
            << " from the last saved state" << exit(FatalError);
    }
    if (!adjustable() && gridTime_ < 0)
    {
        gridTime_ = time_.value();
    }
    rewind();
    chosen_ = dt;
    limit_ = "a rejected step";
    time_.setDeltaT(dt, false);
    retry_ = true;
}


void Foam::fsbi::stepControl::accept(const scene& scene)
{
    endStep();
    if (scene.traffic().over() && !stop_)
    {
        Info<< "All bodies have left and none is to come: the run ends" << endl;
        stop_ = true;
    }
    progress_.report(scene, limit_, !adjustable());
}


Foam::string Foam::fsbi::stepControl::hopeless(const scene& scene)
{
    // the flow does not know the step's length: iterations that leave the same
    // residual with half of it will do so again
    const solverReport& report = scene.report();
    const scalar before = leftOver_;
    leftOver_ =
        report.converged || report.failure.size()
     || !std::isfinite(report.residual)
      ? 0 : report.residual;
    return
        scene.bodies().elastic.empty() && before > 0
     && mag(leftOver_ - before) < 0.01*before
      ? ", as with twice the step: raise maxIterations, or find what makes the"
        " problem hard (far apart sizes, thin cells)"
      : "";
}


bool Foam::fsbi::stepControl::saveDue() const
{
    const bool discard =
        time_.controlDict().getOrDefault<word>("stopAt", "endTime")
     == "noWriteNow";
    const bool last =
        time_.value() > time_.endTime().value() - 0.5*time_.deltaTValue();
    return
        stop_
     || (periodicOutput()
          ? outputsUntil(time_.value()) > outputs_
          : time_.writeTime())
     || (last && !discard);
}


void Foam::fsbi::stepControl::beginStep()
{
    before_ = time_;
    endBefore_ = time_.endTime().value();
}


void Foam::fsbi::stepControl::rewind()
{
    // all of the clock goes back, also its count of outputs
    static_cast<TimeState&>(time_) = before_;
    time_.setEndTime(endBefore_);
}


void Foam::fsbi::stepControl::endStep()
{
    const string why
    (
        interruption_.asked() ? "it was told to end" : wallTime_.shortage()
    );
    interrupted_ = running(time_) ? why : string();
    stop_ = why.size();
    leftOver_ = 0;
}


void Foam::fsbi::stepControl::save(dictionary& state) const
{
    state.set("time", time_.value());
    state.set("index", time_.timeIndex());
    state.set("chosen", chosen_);
    state.set("gridTime", gridTime_);
}


void Foam::fsbi::stepControl::restore(const dictionary& state)
{
    // the folder's name holds fewer digits
    time_.setTime(state.get<scalar>("time"), state.get<label>("index"));
    chosen_ = state.get<scalar>("chosen");
    gridTime_ = state.get<scalar>("gridTime");
    outputs_ = outputsUntil(time_.value());
    progress_.restart();
}
