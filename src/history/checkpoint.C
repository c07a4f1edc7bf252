/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkpoint.H"
#include "OStringStream.H"
#include "OSspecific.H"
#include "IOdictionary.H"
#include "savedProcesses.H"

namespace Foam
{
namespace fsbi
{

static const word stateName("fsbiState");

//- Digits that give a number back exactly
static const unsigned exactly = 17;

//- Digits in the names of time folders. Time raises them itself where steps are
//  short, but does not give them to derived programs
struct folderNames
:
    public Time
{
    static int& digits()
    {
        return precision_;
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::checkpoint::checkpoint(Time& time)
:
    time_(time)
{
    const word folder(startFolder());
    if (folder.size())
    {
        startFrom(folder);
    }
}


Foam::word Foam::fsbi::checkpoint::startFolder() const
{
    if
    (
        time_.controlDict().getOrDefault<word>("startFrom", "latestTime")
     != "latestTime"
    )
    {
        return savedProcesses::at(time_.path(), time_.value());
    }
    word latest;
    if (Pstream::master())
    {
        const instantList times(Time::findTimes(time_.path()));
        for (label i = times.size() - 1; i >= 0 && latest.empty(); --i)
        {
            const fileName folder(time_.path()/times[i].name());
            if
            (
                times[i].value() <= 0 || stateFolder::isState(folder)
             || isFile(folder/"uniform"/stateName)
            )
            {
                latest = times[i].name();
            }
            else
            {
                Info<< "Folder " << times[i].name() << " holds no state of a"
                    << " run: it is left alone" << endl;
            }
        }
    }
    Pstream::scatter(latest);
    return latest == time_.constant() ? word("0") : latest;
}


void Foam::fsbi::checkpoint::startFrom(const word& folder)
{
    scalar value = 0;
    if (readScalar(folder, value) && folder != time_.timeName())
    {
        while
        (
            Time::timeName(value) != folder
         && folderNames::digits() < int(exactly)
        )
        {
            ++folderNames::digits();
        }
        time_.setTime(instant(value, folder), 0);
    }
}


Foam::dictionary Foam::fsbi::checkpoint::read() const
{
    if (time_.value() <= 0)
    {
        return dictionary();
    }
    stateFolder::verify(time_.path()/time_.timeName());
    const IOdictionary state
    (
        IOobject
        (
            stateName, time_.timeName(), "uniform", time_,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    Info<< "Continuing from the state saved at time " << time_.timeName()
        << nl << endl;
    state.readIfPresent("timePrecision", folderNames::digits());
    return state;
}


void Foam::fsbi::checkpoint::add
(
    const Time& time,
    stateFolder& folder,
    const regIOobject& object
)
{
    // a mesh as text would be another class of lists; what users edit is text
    OStringStream os
    (
        object.local() == polyMesh::meshSubDir ? IOstream::BINARY
      : isA<dictionary>(object) || time.value() <= 0 ? IOstream::ASCII
      : time.writeFormat()
    );
    os.precision(exactly);
    IOobject io(object);
    io.instance() = time.timeName();
    io.writeHeader(os, object.type());
    object.writeData(os);
    IOobject::writeEndDivider(os);
    folder.add(object.db().dbDir()/object.local()/object.name(), os.str());
}


void Foam::fsbi::checkpoint::addState
(
    stateFolder& folder,
    const scene& scene,
    const stepControl& steps
) const
{
    const auto named = [&](const word& name)
    {
        return IOobject
        (
            name, time_.timeName(), "uniform", time_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
    };
    // dictionaries hold numbers as text from the moment they are set
    const unsigned precision = IOstream::defaultPrecision(exactly);

    IOdictionary state(named(stateName));
    scene.save(state);
    dictionary stepping;
    steps.save(stepping);
    state.set("stepControl", stepping);
    state.set("timePrecision", folderNames::digits());
    add(folder, state);

    IOdictionary time(named("time"));
    time.set("value", time_.value());
    time.set("name", string(time_.timeName()));
    time.set("index", time_.timeIndex());
    time.set("deltaT", time_.deltaTValue());
    time.set("deltaT0", time_.deltaT0Value());
    add(folder, time);

    IOstream::defaultPrecision(precision);
}


void Foam::fsbi::checkpoint::write(scene& scene, const stepControl& steps)
{
    auto timer = scene.clocks().measure("output");

    stateFolder folder(time_.path(), time_.timeName());
    scene.write([&](const regIOobject& object) { add(folder, object); });
    addState(folder, scene, steps);
    if (scene.effects())
    {
        scene.effects()->draw
        (
            [&](const fileName& file, const std::string& content)
            {
                folder.add("uniform"/file, content);
            }
        );
    }
    folder.publish();

    saved_.append(time_.timeName());
    purge();

    // a restarted run builds its solver anew: so does this one
    scene.renewSolvers();
}


void Foam::fsbi::checkpoint::purge()
{
    const label kept = time_.controlDict().getOrDefault<label>("purgeWrite", 0);
    while (kept > 0 && saved_.size() > kept)
    {
        if (saved_[0] != "0")
        {
            rmDir(time_.path()/saved_[0], true);
        }
        saved_.remove(0);
    }
}
