/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepSeries.H"
#include "Time.H"
#include "OSspecific.H"

Foam::fsbi::stepSeries::stepSeries(const Time& time, scene& scene)
:
    time_(time),
    scene_(scene),
    parts_({"meshing", "assembly", "solve", "output"})
{
    if (!Pstream::master())
    {
        return;
    }
    if (scene.effects())
    {
        parts_.append(scene.effects()->names());
    }
    const fileName folder
    (
        time.globalPath()/"postProcessing"/"steps"/time.timeName()
    );
    mkDir(folder);
    steps_.reset(new OFstream(folder/"steps.dat"));
    seconds_.reset(new OFstream(folder/"seconds.dat"));
    for (OFstream* os : {steps_.get(), seconds_.get()})
    {
        os->precision(10);
    }
    *steps_
        << "# time length outcome iterations corrections residual gap reason"
        << endl;
    *seconds_ << "# time";
    for (const word& part : parts_)
    {
        *seconds_ << ' ' << part.c_str();
    }
    *seconds_ << " total" << endl;
}


void Foam::fsbi::stepSeries::flush(OFstream& os)
{
    os.flush();
    if (!os.good())
    {
        FatalErrorInFunction
            << os.name() << " cannot be written. Is the disk full?"
            << " Saved states are untouched; make room and continue with"
            << " 'startFrom latestTime'" << exit(FatalError);
    }
}


void Foam::fsbi::stepSeries::writeStep
(
    const word& outcome, const scalar gap, const Foam::string& reason
)
{
    const solverReport& report = scene_.report();
    *steps_ << time_.value() << ' ' << time_.deltaTValue() << ' '
        << outcome.c_str() << ' ' << report.iterations << ' '
        << report.corrections << ' ' << report.residual << ' ';
    if (gap < 0.1*GREAT)
    {
        *steps_ << gap;
    }
    else
    {
        *steps_ << '-';
    }
    *steps_ << ' ' << reason.c_str() << nl;
}


void Foam::fsbi::stepSeries::accept
(
    const scalar gap, const Foam::string& limit
)
{
    if (!Pstream::master())
    {
        return;
    }
    writeStep("accepted", gap, limit);
    *seconds_ << time_.value();
    for (const word& part : parts_)
    {
        *seconds_ << ' ' << scene_.clocks().seconds(part);
    }
    *seconds_ << ' ' << scene_.clocks().total() << nl;
}


void Foam::fsbi::stepSeries::reject(const Foam::string& reason)
{
    if (Pstream::master())
    {
        writeStep("rejected", GREAT, reason);
    }
}


void Foam::fsbi::stepSeries::flush()
{
    if (Pstream::master())
    {
        flush(*steps_);
        flush(*seconds_);
    }
}
