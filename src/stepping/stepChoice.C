/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// How long the next step is

#include "stepControl.H"

namespace
{

//- Steps grow by no more than this factor
const Foam::scalar maxGrowth = 1.5;

//- Part of a step by which times may differ and still be the same
const Foam::scalar sameTime = 1e-6;

//- Part of a step that the last one is longer, rather than that another follows:
//  times are written with six digits
const Foam::scalar shortestRest = 1e-4;

} // End anonymous namespace


Foam::label Foam::fsbi::stepControl::outputsUntil(const scalar time) const
{
    return periodicOutput()
      ? label
        (
            time/entry("writeInterval", GREAT)
          + sameTime*min
            (
                time_.deltaTValue()/entry("writeInterval", GREAT), scalar(1)
            )
        )
      : 0;
}


Foam::scalar Foam::fsbi::stepControl::smallestWanted(const scene& scene)
{
    const scalar maxRotation = entry("maxRotation", largestTurn);
    const scalar maxTravel = entry("maxTravel", largestTravel);
    scalar dt = GREAT, largest = 0;
    const auto require = [&](const scalar wanted, const string& reason)
    {
        if (wanted < dt)
        {
            dt = wanted;
            limit_ = reason;
        }
    };
    require(entry("maxDeltaT", GREAT), "maxDeltaT");
    const bool first = time_.timeIndex() == 0;
    require(first ? chosen_ : maxGrowth*chosen_, first ? "deltaT" : "growth");
    const auto move = [&]
    (
        const word& name, const sixVector& v, const scalar radius
    )
    {
        largest = max(largest, radius);
        require
        (
            maxRotation/max(mag(angular(v)), VSMALL), "rotation of " + name
        );
        require
        (
            maxTravel*radius/max(mag(linear(v)), VSMALL), "travel of " + name
        );
    };
    for (const rigidBody& body : scene.bodies())
    {
        move(body.name(), body.now().velocity, body.radius());
    }
    for (const prescribedBody& body : scene.prescribed())
    {
        move(body.name(), body.now().velocity, body.radius());
    }
    for (label i = 0; scene.hasFluid() && i < scene.solids().size(); ++i)
    {
        const wettedSurface& surface = scene.solids()[i].surface();
        move(surface.name(), surface.motion(), surface.radius());
    }
    const scalar maxApproach = entry("maxApproach", 0);
    if (maxApproach > 0)
    {
        if (!approachTold_)
        {
            tellUnseen("maxApproach does not look at", scene.unseen());
            approachTold_ = true;
        }
        // gaps that a step could close by that part, at the bodies' speeds
        string names;
        const scalar reach = 2*maxTravel*largest/maxApproach;
        const scalar contact = scene.timeToContact(reach, names);
        require(max(maxApproach*contact, shortest()), "approach of " + names);
    }
    if (scene.effects())
    {
        string reason;
        const scalar wanted = scene.effects()->longestStep(reason);
        require(max(wanted, shortest()), reason);
    }
    return dt;
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
        const scalar interval = entry("writeInterval", GREAT);
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
        chosen_ = smallestWanted(scene);
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
