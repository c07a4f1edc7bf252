/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include <csignal>

namespace
{

volatile std::sig_atomic_t interrupted = 0;

extern "C" void onInterrupt(int)
{
    interrupted = 1;
    std::signal(SIGINT, SIG_DFL);       // a second one ends the run at once
}

//- Steps grow by no more than this factor
const Foam::scalar maxGrowth = 1.5;

} // End anonymous namespace


Foam::fsbi::stepControl::stepControl(Time& time, scene& scene)
:
    time_(time),
    scene_(scene),
    chosen_(time.deltaTValue()),
    minDeltaT_(controlEntry("minDeltaT", 1e-6*time.deltaTValue())),
    startValue_(time.value()),
    startIndex_(time.timeIndex()),
    retry_(false),
    firstTime_(time.value())
{
    std::signal(SIGINT, onInterrupt);
}


Foam::scalar Foam::fsbi::stepControl::controlEntry
(
    const word& key, const scalar deflt
) const
{
    return time_.controlDict().getOrDefault<scalar>(key, deflt);
}


Foam::scalar Foam::fsbi::stepControl::adjusted(word& limit) const
{
    const scalar maxRotation = controlEntry("maxRotation", 0.2);
    const scalar maxTravel = controlEntry("maxTravel", 0.2);
    scalar dt = controlEntry("maxDeltaT", GREAT);
    limit = "maxDeltaT";
    const auto require = [&](const scalar wanted, const word& reason)
    {
        if (wanted < dt)
        {
            dt = wanted;
            limit = reason;
        }
    };
    if (time_.timeIndex() > 0)
    {
        require(maxGrowth*chosen_, "growth");
    }
    else
    {
        require(chosen_, "deltaT");
    }
    for (const rigidBody& body : scene_.bodies())
    {
        const sixVector& v = body.now().velocity;
        require
        (
            maxRotation/max(mag(angular(v)), VSMALL), "rotation of " + body.name()
        );
        require
        (
            maxTravel*body.radius()/max(mag(linear(v)), VSMALL),
            "travel of " + body.name()
        );
    }
    return dt;
}


bool Foam::fsbi::stepControl::next()
{
    if (!retry_)
    {
        if (returnReduce(bool(interrupted), orOp<bool>()))
        {
            Info<< "Interrupted: the state at " << time_.timeName()
                << " is saved, 'startFrom latestTime' continues" << endl;
            return false;
        }
        if (!time_.run())
        {
            return false;
        }
        startValue_ = time_.value();
        startIndex_ = time_.timeIndex();
        if (time_.controlDict().getOrDefault("adjustTimeStep", false))
        {
            chosen_ = adjusted(limit_);
            time_.setDeltaT(chosen_);
        }
        else
        {
            limit_ = "deltaT";
        }
    }
    retry_ = false;
    ++time_;
    return true;
}


void Foam::fsbi::stepControl::reject()
{
    const scalar dt = 0.5*time_.deltaTValue();
    Info<< "Step to " << time_.timeName() << " rejected: "
        << scene_.failure().c_str() << "; again with " << dt << endl;
    if (dt < minDeltaT_)
    {
        FatalErrorInFunction
            << "Steps down to " << dt << " fail: " << scene_.failure().c_str()
            << ". The last saved state is untouched." << exit(FatalError);
    }
    time_.setTime(startValue_, startIndex_);
    chosen_ = dt;
    limit_ = "rejected step";
    time_.setDeltaT(dt, false);
    retry_ = true;
}


void Foam::fsbi::stepControl::report() const
{
    const scalar end = time_.endTime().value();
    const scalar done =
        (time_.value() - firstTime_)/max(end - firstTime_, VSMALL);
    const scalar left = clock_.elapsedTime()*(1 - done)/max(done, VSMALL);
    const scalar gap = scene_.smallestGap();

    char line[256];
    snprintf
    (
        line, sizeof(line),
        "t %-10s dt %-8.4g (%s)  its %3d  residual %7.1e  gap %-7.4g"
        "  %5.1f %%  left %.0f s",
        time_.timeName().c_str(), time_.deltaTValue(), limit_.c_str(),
        int(scene_.report().iterations), scene_.report().residual, gap,
        100*done, left
    );
    Info<< line << endl;
}


bool Foam::fsbi::stepControl::saveDue() const
{
    return time_.writeTime()
        || returnReduce(bool(interrupted), orOp<bool>());
}
