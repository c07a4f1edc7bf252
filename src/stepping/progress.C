/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "progress.H"
#include "Time.H"

namespace
{

//- Turn of a body in a step that is told where the user gives the step, rad
const Foam::scalar unresolvedTurn = 1;

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


Foam::fsbi::progress::progress(const Time& time)
:
    time_(time),
    gap_(GREAT),
    gapTold_(false),
    turnTold_(false),
    began_(-1),
    firstTime_(time.value())
{}


void Foam::fsbi::progress::begin()
{
    if (began_ < 0)
    {
        began_ = clock_.elapsedTime();
    }
}


void Foam::fsbi::progress::reportLine
(
    const scene& scene, const string& limit
) const
{
    const scalar end = max(time_.endTime().value(), time_.value());
    const scalar done =
        (time_.value() - firstTime_)/max(end - firstTime_, VSMALL);
    const scalar left =
        (clock_.elapsedTime() - began_)*(1 - done)/max(done, VSMALL);
    char gapText[40] = "";
    if (gap_ < 0.1*GREAT)
    {
        snprintf(gapText, sizeof(gapText), "  gap %-8.4g", gap_);
    }
    char error[40] = "";
    if (scene.hasFluid() && scene.fluid().error().known())
    {
        snprintf
        (
            error, sizeof(error), "  forces to %.2g %%",
            100*scene.fluid().error().relative()
        );
    }
    char corrections[40] = "";
    if (scene.bodies().elastic.size())
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
        "Time = %-10s dt %-9.4g %sits %3d  residual %7.1e%s%s %5.1f %%"
        "  left %-7s dt by %s",
        time_.timeName().c_str(), time_.deltaTValue(), corrections,
        int(scene.report().iterations), scene.report().residual, error, gapText,
        100*done, readable(left).c_str(), limit.c_str()
    );
    Info<< line << scene.warning().c_str() << endl;
}


void Foam::fsbi::progress::reportTurn(const scene& scene)
{
    const auto report = [&](const word& name, const vector& spin)
    {
        const scalar turn = mag(spin)*time_.deltaTValue();
        if (!turnTold_ && turn > unresolvedTurn)
        {
            Info<< "Body '" << name << "' turned by " << turn << " rad in this"
                << " step: a motion that depends on where it points to is not"
                << " resolved. Take a smaller deltaT, or adjustTimeStep (system/"
                << "controlDict)" << endl;
            turnTold_ = true;
        }
    };
    for (const rigidBody& body : scene.bodies().rigid)
    {
        report(body.name(), angular(body.now().velocity));
    }
    for (const solidRegion& solid : scene.bodies().elastic)
    {
        if (scene.hasFluid())
        {
            report(solid.name(), angular(solid.surface().motion()));
        }
    }
}


void Foam::fsbi::progress::reportGap(const scene& scene)
{
    const string text(gapTold_ ? string() : scene.unresolved(gap_));
    if (text.size())
    {
        Info<< text.c_str() << endl;
        gapTold_ = true;
    }
}


void Foam::fsbi::progress::report
(
    const scene& scene, const string& limit, const bool given
)
{
    gap_ = scene.smallestGap();
    reportLine(scene, limit);
    reportGap(scene);
    if (given)
    {
        reportTurn(scene);
    }
}


void Foam::fsbi::progress::conclude(const string& why) const
{
    if (why.size())
    {
        Info<< nl << "Interrupted at " << time_.timeName() << ": " << why.c_str()
            << "; the state is saved, 'startFrom latestTime' continues from here"
            << endl;
    }
    else if (time_.value() == firstTime_)
    {
        Info<< nl << "Nothing to do: the start time " << time_.timeName()
            << " has reached the end time " << time_.endTime().value() << endl;
    }
}
