/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkpoint.H"
#include "OFstream.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "pointIOField.H"
#include "IOdictionary.H"
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace Foam
{
namespace fsbi
{

static const fileName manifestName("uniform/checkpoint");
static const fileName stateName("uniform/fsbiState");

//- Every file that OpenFOAM finishes ends so
static const std::string lastLine("// *********");

static std::string contents(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::checkpoint::checkpoint
(
    const Time& time,
    scene& scene,
    stepControl& steps
)
:
    time_(time),
    scene_(scene),
    steps_(steps)
{}


Foam::fileNameList Foam::fsbi::checkpoint::filesOf(const fileName& folder)
{
    fileNameList all;
    for (const fileName& name : readDir(folder, fileName::FILE))
    {
        all.append(name);
    }
    for (const fileName& sub : readDir(folder, fileName::DIRECTORY))
    {
        for (const fileName& name : filesOf(folder/sub))
        {
            all.append(sub/name);
        }
    }
    Foam::sort(all);
    return all;
}


std::string Foam::fsbi::checkpoint::digest(const fileName& file)
{
    return SHA1(contents(file)).str();
}


void Foam::fsbi::checkpoint::writeObject
(
    const word& instance,
    const regIOobject& object
) const
{
    // regIOobject::write() knows the present time's folder only
    const fileName folder
    (
        time_.path()/instance/object.db().dbDir()/object.local()
    );
    mkDir(folder);
    OFstream os(folder/object.name(), IOstream::BINARY);
    object.writeHeader(os);
    object.writeData(os);
    IOobject::writeEndDivider(os);
}


void Foam::fsbi::checkpoint::writeRegion(const word& instance) const
{
    const fvMesh& mesh = scene_.fluid().mesh();
    for (const word name : {"points", "faces", "owner", "neighbour", "boundary"})
    {
        writeObject(instance, mesh.thisDb().lookupObject<regIOobject>(name));
    }
    writeObject(instance, scene_.fluid().U());
    writeObject(instance, scene_.fluid().p());

    const pointIOField reference
    (
        IOobject
        (
            "referencePoints", time_.timeName(), polyMesh::meshSubDir, mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        scene_.fluid().meshing().referencePoints()
    );
    writeObject(instance, reference);
}


void Foam::fsbi::checkpoint::writeState(const word& instance) const
{
    const auto unregistered = [&](const word& name)
    {
        return IOobject
        (
            name, time_.timeName(), "uniform", time_,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        );
    };
    IOdictionary state(unregistered(stateName.name()));
    scene_.save(state);
    state.set("deltaT", steps_.chosen());
    writeObject(instance, state);

    IOdictionary time(unregistered("time"));
    time.set("value", time_.value());
    time.set("name", time_.timeName());
    time.set("index", time_.timeIndex());
    time.set("deltaT", time_.deltaTValue());
    time.set("deltaT0", time_.deltaT0Value());
    writeObject(instance, time);
}


void Foam::fsbi::checkpoint::checkWritten
(
    const fileName& folder,
    const fileNameList& files
)
{
    for (const fileName& file : files)
    {
        const std::string text(contents(folder/file));
        const std::string tail
        (
            text.substr(text.size() > 200 ? text.size() - 200 : 0)
        );
        if (tail.find(lastLine) == std::string::npos)
        {
            rmDir(folder);
            FatalErrorInFunction
                << "The state could not be saved: " << folder/file
                << " is cut short. Is the disk full? Earlier states are"
                << " untouched." << exit(FatalError);
        }
    }
}


void Foam::fsbi::checkpoint::writeManifest(const fileName& folder) const
{
    const fileNameList files(filesOf(folder));
    checkWritten(folder, files);
    {
        OFstream os(folder/manifestName);
        for (const fileName& file : files)
        {
            os  << file.c_str() << ' ' << label(fileSize(folder/file)) << ' '
                << digest(folder/file).c_str() << nl;
        }
        os << lastLine.c_str() << nl;
    }
    checkWritten(folder, {manifestName});
}


void Foam::fsbi::checkpoint::verify(const fileName& folder)
{
    std::istringstream is(contents(folder/manifestName));
    std::string name, sum;
    label size, n = 0;
    while (is >> name && name != "//" && is >> size >> sum)
    {
        const fileName file(folder/name);
        if (fileSize(file) != size || digest(file) != sum)
        {
            FatalErrorInFunction
                << "The saved state cannot be used: " << file
                << (isFile(file) ? " was cut short or changed" : " is missing")
                << ". Remove " << folder << " to start from an earlier time."
                << exit(FatalError);
        }
        ++n;
    }
    if (n == 0)
    {
        FatalErrorInFunction
            << "There is no whole saved state in " << folder << ": "
            << manifestName << " is missing or empty. Remove this folder to"
            << " start from an earlier time." << exit(FatalError);
    }
}


void Foam::fsbi::checkpoint::verifyStart(const Time& time)
{
    const fileName folder(time.path()/time.timeName());
    if (time.value() > 0 || isFile(folder/manifestName))
    {
        verify(folder);
    }
}


bool Foam::fsbi::checkpoint::restore()
{
    if (!isFile(time_.path()/time_.timeName()/stateName))
    {
        return false;
    }
    const IOdictionary state
    (
        IOobject
        (
            stateName.name(), time_.timeName(), "uniform", time_,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    scene_.restore(state);
    const pointIOField reference
    (
        IOobject
        (
            "referencePoints", time_.timeName(), polyMesh::meshSubDir,
            scene_.fluid().mesh(), IOobject::MUST_READ, IOobject::NO_WRITE,
            false
        )
    );
    scene_.fluid().meshing().restore(state.subDict("fluidMesh"), reference);
    steps_.restore(state.get<scalar>("deltaT"));
    saved_ = time_.timeName();
    Info<< "Restarted from the state saved at " << time_.timeName() << endl;
    return true;
}


void Foam::fsbi::checkpoint::write()
{
    auto timer = scene_.clocks().measure("output");
    const word final(time_.timeName());
    const word part(final + ".part");
    const fileName folder(time_.path()/part);

    const unsigned precision = IOstream::defaultPrecision(17);
    if (isDir(folder))
    {
        rmDir(folder);
    }
    writeRegion(part);
    writeState(part);
    IOstream::defaultPrecision(precision);
    writeManifest(folder);

    returnReduce(true, andOp<bool>());          // all are whole: rename
    if (isDir(time_.path()/final))
    {
        rmDir(time_.path()/final);
    }
    mv(folder, time_.path()/final);
    sync();
    saved_ = final;

    // a restarted run builds its solver anew: so does this one
    scene_.fluid().renewSolver();
}


void Foam::fsbi::checkpoint::writeWhenDue()
{
    if (steps_.saveDue() && saved_ != time_.timeName())
    {
        write();
    }
}
