/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "savedProcesses.H"
#include "stateFolder.H"
#include "IFstream.H"
#include "StringStream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <map>

namespace Foam
{
namespace fsbi
{

static std::map<scalar, word> statesIn(const fileName& folder)
{
    std::map<scalar, word> states;
    for (const fileName& name : readDir(folder, fileName::DIRECTORY))
    {
        scalar time;
        if
        (
            readScalar(name, time) && time > 0
         && stateFolder::isState(folder/name)
        )
        {
            states[time] = name;
        }
    }
    return states;
}

//- Would a run begin at time 0 although there are later states?
static bool fromStart(const fileName& path)
{
    IFstream is(path/"system"/"controlDict");
    return
        !is.good()
     || dictionary(is).getOrDefault<word>("startFrom", "latestTime")
     != "latestTime";
}

static std::string processes(const label n)
{
    return n == 1 ? "one process" : Foam::name(n) + " processes";
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::savedProcesses::savedProcesses(const fileName& path)
:
    path_(path),
    number_(0)
{
    while (latest(path/("processor" + name(number_))).size())
    {
        ++number_;
    }
}


Foam::label Foam::fsbi::savedProcesses::nFolders() const
{
    label n = 0;
    while (isDir(path_/("processor" + name(n))))
    {
        ++n;
    }
    return n;
}


Foam::fileNameList Foam::fsbi::savedProcesses::parts
(
    const fileName& path, const label number
)
{
    fileNameList folders(number, path);
    for (label i = 0; number > 1 && i < number; ++i)
    {
        folders[i] = path/("processor" + name(i));
    }
    return folders;
}


Foam::word Foam::fsbi::savedProcesses::latest(const fileName& folder)
{
    const auto states(statesIn(folder));
    return states.empty() ? word() : states.rbegin()->second;
}


Foam::word Foam::fsbi::savedProcesses::at
(
    const fileName& folder, const scalar time
)
{
    for (const auto& state : statesIn(folder))
    {
        if (mag(state.first - time) <= 1e-9*time)
        {
            return state.second;
        }
    }
    return word();
}


void Foam::fsbi::savedProcesses::checkLast(const label wanted) const
{
    struct { label number = 0; word name; scalar time = 0; } last, own;
    for (const label n : {label(1), number_})
    {
        scalar time;
        const word name(n ? latest(parts(path_, n)[0]) : word());
        if (readScalar(name, time))
        {
            if (n == wanted)
            {
                own = {n, name, time};
            }
            if (time > last.time)
            {
                last = {n, name, time};
            }
        }
    }
    if (last.time <= (1 + 1e-9)*own.time || fromStart(path_))
    {
        return;
    }
    OStringStream instead;
    if (own.number)
    {
        instead
            << "To continue from time " << own.name << ", the last of "
            << processes(wanted).c_str() << ", write   startFrom startTime; startTime "
            << own.name << ";   in system/controlDict";
    }
    else
    {
        instead << "To begin anew, remove the states";
    }
    FatalErrorInFunction
        << "The last saved state of this case, of time " << last.name
        << ", is of " << processes(last.number).c_str() << ", the run of "
        << processes(wanted).c_str() << ". To continue from it, type"
        << "   fsbiRedistribute -np " << wanted << "   "
        << instead.str().c_str() << exit(FatalError);
}


void Foam::fsbi::savedProcesses::checkFolders(const label wanted) const
{
    const bool divided = isDir(path_/"processor0"/"constant");
    const label folders = nFolders();
    if (number_ ? folders < wanted : divided && folders != wanted)
    {
        FatalErrorInFunction
            << "The case has " << folders << " folders processor0 ..., the run"
            << " has " << processes(wanted).c_str() << ". Remove them: the run divides"
            << " the meshes itself. Or divide them by decomposePar, with"
            << " 'numberOfSubdomains " << wanted << ";' in"
            << " system/decomposeParDict" << exit(FatalError);
    }
    for (label i = folders; i < wanted; ++i)
    {
        mkDir(path_/("processor" + name(i)));
    }
}


void Foam::fsbi::savedProcesses::check(const argList& args)
{
    if (Pstream::master())
    {
        const label wanted = Pstream::nProcs();
        const savedProcesses saved(args.globalPath());
        saved.checkLast(wanted);
        if (wanted > 1 && !args.distributed())
        {
            saved.checkFolders(wanted);
        }
    }
    returnReduce(true, andOp<bool>());      // until the master has looked
}
