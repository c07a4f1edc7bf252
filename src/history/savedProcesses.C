/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "savedProcesses.H"
#include "stateFolder.H"
#include "IFstream.H"
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

static string processes(const label n)
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


void Foam::fsbi::savedProcesses::check(const argList& args)
{
    const label wanted = Pstream::nProcs();
    if (!Pstream::master())
    {
        returnReduce(true, andOp<bool>());      // until the master has looked
        return;
    }
    const fileName path(args.globalPath());
    const savedProcesses saved(path);
    const bool single = latest(path).size();
    label found = wanted;
    if (saved.number() > 1 && (wanted > 1 || !single))
    {
        found = saved.number();
    }
    else if (saved.number() == 0 && single)
    {
        found = 1;
    }
    if (found != wanted && !fromStart(path))
    {
        FatalErrorInFunction
            << "The saved states of this case are of " << processes(found)
            << ", the run of " << processes(wanted) << ". To continue from"
            << " the last state, type   fsbiRedistribute -np " << wanted
            << "   To begin anew, remove the states" << exit(FatalError);
    }
    const bool divided = isDir(path/"processor0"/"constant");
    const label folders = saved.nFolders();
    if
    (
        wanted > 1 && !args.distributed()
     && (saved.number() ? folders < wanted : divided && folders != wanted)
    )
    {
        FatalErrorInFunction
            << "The case has " << folders << " folders processor0 ..., the run"
            << " has " << processes(wanted) << ". Remove them: the run divides"
            << " the meshes itself. Or divide them by decomposePar, with"
            << " 'numberOfSubdomains " << wanted << ";' in"
            << " system/decomposeParDict" << exit(FatalError);
    }
    for (label i = folders; i < wanted && wanted > 1 && !args.distributed(); ++i)
    {
        mkDir(path/("processor" + name(i)));
    }
    returnReduce(true, andOp<bool>());
}
