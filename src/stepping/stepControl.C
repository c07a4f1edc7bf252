/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "checkedDictionary.H"
#include <csignal>
#include <unistd.h>

namespace
{

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t speaker = 0;

extern "C" void onInterrupt(int signal)
{
    static const char message[] =
        "\nThe run ends after this step, with a saved state;"
        " once more ends it at once\n";
    interrupted = 1;
    std::signal(signal, SIG_DFL);
    if (speaker && write(STDERR_FILENO, message, sizeof(message) - 1) < 0)
    {
        speaker = 0;
    }
}

//- Turn of a body in a step that is told where the user gives the step, rad
const Foam::scalar unresolvedTurn = 1;

//- Shorter steps tried, where one fails, to end an interrupted run with
const Foam::label maxLastTries = 1;

//- Time::run(), which would also call function objects, before the state of
//  the step is saved
bool running(const Foam::Time& time)
{
    return time.value() < time.endTime().value() - 0.5*time.deltaTValue();
}

//- Seconds in the unit that reads best
std::string readable(const Foam::scalar seconds)
{
    char text[40];
    if (seconds < 120)
    {
        snprintf(text, sizeof(text), "%.0f s", seconds);
    }
    else if (seconds < 7200)
    {
        snprintf(text, sizeof(text), "%.0f min", seconds/60);
    }
    else
    {
        snprintf(text, sizeof(text), "%.1f h", seconds/3600);
    }
    return text;
}

} // End anonymous namespace


Foam::fsbi::stepControl::stepControl(Time& time)
:
    time_(time),
    chosen_(time.deltaTValue()),
    gap_(GREAT),
    gridTime_(-GREAT),
    outputs_(outputsUntil(time.value())),
    before_(time),
    endBefore_(time.endTime().value()),
    retry_(false),
    stop_(false),
    gapTold_(false),
    turnTold_(false),
    approachTold_(false),
    lastTries_(0),
    leftOver_(0),
    began_(-1),
    firstTime_(time.value())
{
    noteDefaults();
    speaker = Pstream::master();
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    // a file beyond the user's limit: writing it fails, and says so
    std::signal(SIGXFSZ, SIG_IGN);
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


Foam::scalar Foam::fsbi::stepControl::entry
(
    const word& key, const scalar deflt
) const
{
    return time_.controlDict().getOrDefault<scalar>(key, deflt);
}


Foam::scalar Foam::fsbi::stepControl::shortest() const
{
    return
        entry("minDeltaT", 1e-6*time_.controlDict().get<scalar>("deltaT"));
}


bool Foam::fsbi::stepControl::next(const scene& scene)
{
    if (!retry_)
    {
        if (stop_)
        {
            return false;
        }
        if (began_ < 0)
        {
            began_ = clock_.elapsedTime();
        }
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
        before_ = time_;
        endBefore_ = time_.endTime().value();
    }
    retry_ = false;
    ++time_;
    return true;
}


void Foam::fsbi::stepControl::reject
(
    const scene& scene, const outcome& step
)
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
    if
    (
        returnReduce(bool(interrupted), orOp<bool>())
     && ++lastTries_ > maxLastTries
    )
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
    // all of the clock goes back, also its count of outputs
    static_cast<TimeState&>(time_) = before_;
    time_.setEndTime(endBefore_);
    chosen_ = dt;
    limit_ = "a rejected step";
    time_.setDeltaT(dt, false);
    retry_ = true;
}


void Foam::fsbi::stepControl::accept(const scene& scene)
{
    stop_ = returnReduce(bool(interrupted), orOp<bool>());
    leftOver_ = 0;

    const scalar end = max(time_.endTime().value(), time_.value());
    const scalar done =
        (time_.value() - firstTime_)/max(end - firstTime_, VSMALL);
    const scalar left =
        (clock_.elapsedTime() - began_)*(1 - done)/max(done, VSMALL);
    gap_ = scene.smallestGap();
    char gapText[40] = "";
    if (gap_ < 0.1*GREAT)
    {
        snprintf(gapText, sizeof(gapText), "  gap %-8.4g", gap_);
    }
    char corrections[40] = "";
    if (scene.solids().size())
    {
        snprintf
        (
            corrections, sizeof(corrections), "corrections %2d  ",
            int(scene.report().corrections)
        );
    }
    char line[320];
    snprintf
    (
        line, sizeof(line),
        "Time = %-10s dt %-9.4g %sits %3d  residual %7.1e%s %5.1f %%"
        "  left %-7s dt by %s",
        time_.timeName().c_str(), time_.deltaTValue(), corrections,
        int(scene.report().iterations), scene.report().residual, gapText,
        100*done, readable(left).c_str(), limit_.c_str()
    );
    Info<< line << scene.warning().c_str() << endl;
    tellOfGap(scene);
    tellOfTurn(scene);
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
        scene.solids().empty() && before > 0
     && mag(leftOver_ - before) < 0.01*before
      ? ", as with twice the step: raise maxIterations, or find what makes the"
        " problem hard (far apart sizes, thin cells)"
      : "";
}


void Foam::fsbi::stepControl::noteDefaults() const
{
    const checkedDictionary entries(time_.controlDict());
    if (!entries.getOrDefault("adjustTimeStep", false))
    {
        return;
    }
    entries.getOrDefault("maxRotation", largestTurn);
    entries.getOrDefault("maxTravel", largestTravel);
    entries.getOrDefault("minDeltaT", shortest());
    for (const word key : {"maxDeltaT", "maxApproach"})
    {
        if (!entries.found(key))
        {
            entries.getOrDefault(key, word("none"));
        }
    }
}


void Foam::fsbi::stepControl::tellOfTurn(const scene& scene)
{
    const auto tell = [&](const word& name, const vector& spin)
    {
        const scalar turn = mag(spin)*time_.deltaTValue();
        if (!turnTold_ && !adjustable() && turn > unresolvedTurn)
        {
            Info<< "Body '" << name << "' turned by " << turn << " rad in this"
                << " step: a motion that depends on where it points to is not"
                << " resolved. Take a smaller deltaT, or adjustTimeStep (system/"
                << "controlDict)" << endl;
            turnTold_ = true;
        }
    };
    for (const rigidBody& body : scene.bodies())
    {
        tell(body.name(), angular(body.now().velocity));
    }
    for (const solidRegion& solid : scene.solids())
    {
        if (scene.hasFluid())
        {
            tell(solid.name(), angular(solid.surface().motion()));
        }
    }
}


void Foam::fsbi::stepControl::tellOfGap(const scene& scene)
{
    if (gapTold_ || gap_ > 0.1*GREAT || gap_ >= scene.resolvedGap())
    {
        return;
    }
    Info<< "A gap of " << gap_ << " is narrower than the " << scene.resolvedGap()
        << " that have cellsPerGap cells of minSize across: the flow in it is"
        << " not resolved (system/remeshDict; shape size in constant/bodies)"
        << endl;
    gapTold_ = true;
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


void Foam::fsbi::stepControl::conclude() const
{
    if (stop_)
    {
        Info<< nl << "Interrupted at " << time_.timeName() << ": the state is"
            << " saved, 'startFrom latestTime' continues from here" << endl;
    }
    else if (time_.value() == firstTime_)
    {
        Info<< nl << "Nothing to do: the start time " << time_.timeName()
            << " has reached the end time " << time_.endTime().value() << endl;
    }
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
    firstTime_ = time_.value();
}
