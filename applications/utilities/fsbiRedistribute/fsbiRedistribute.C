/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiRedistribute

Description
    Makes of a saved state one for another number of processes, from which
    fsbiFoam -parallel, or fsbiFoam on one process, continues. The parts are
    joined in the order of the whole mesh, as one process would have it, and
    distributed as a new mesh would be: nothing is interpolated, and a state
    that is joined and distributed again is the same, bit for bit.

Usage
    \code
    fsbiRedistribute -np 4          # the last state
    fsbiRedistribute -np 1 -time 2000
    \endcode

    For one process the state becomes a time folder of the case itself, for
    ParaView and foamToVTK, too. For several, processor0, processor1 ... are
    made; those of another number of processes, with their older states, are
    moved to a folder savedBy<N>.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "savedRegion.H"
#include "runLock.H"
#include "savedProcesses.H"
#include "HashSet.H"
#include "OSspecific.H"
#include <fstream>
#include <sstream>

using namespace Foam;

//- Where the new processors' folders are made
static const fileName unfinished("redistributed.part");


static std::string contents(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}


//- A state: by how many processes, its time folder's name
struct savedState
{
    label number = 0;
    word time;
};


//- The last state, or that of a time; of two for the same time, the one of
//  another number of processes than wanted
static savedState find
(
    const fileName& path, const label wanted, const scalar time
)
{
    savedState found;
    scalar last = -1;
    for (const label n : {label(1), fsbi::savedProcesses(path).number()})
    {
        const fileName folder(n == 1 ? path : path/"processor0");
        const word name
        (
            time < 0
          ? fsbi::savedProcesses::latest(folder)
          : fsbi::savedProcesses::at(folder, time)
        );
        scalar t;
        if
        (
            n && readScalar(name, t)
         && (t > last || (t == last && found.number == wanted))
        )
        {
            found.number = n;
            found.time = name;
            last = t;
        }
    }
    return found;
}


//- The new folders take the place of the old ones; also what is left to do of
//  that after a kill
static void exchangeFolders(const fileName& path)
{
    const fileName made(path/unfinished);
    fileName older(contents(made/"older"));
    if (older.empty())
    {
        rmDir(made, true);          // was not complete
        return;
    }
    if (isDir(made/"processor0"))
    {
        mkDir(older);
        for (label i = fsbi::savedProcesses(path).nFolders() - 1; i >= 0; --i)
        {
            const word folder("processor" + name(i));
            mv(path/folder, older/folder);
        }
    }
    for (const fileName& folder : readDir(made, fileName::DIRECTORY))
    {
        if (folder != "processor0")
        {
            mv(made/folder, path/folder);
        }
    }
    mv(made/"processor0", path/"processor0");
    rmDir(made, true);
    Info<< "The older processors' folders are now in " << older.name() << nl;
}


//- Where the processors' old folders go to
static fileName olderFolder(const fileName& path)
{
    const fileName base(path/("savedBy" + name(fsbi::savedProcesses(path).nFolders())));
    fileName folder(base);
    for (label i = 2; exists(folder); ++i)
    {
        folder = base + "." + name(i);
    }
    return folder;
}


//- Files of a state that every process has all of; fatal if they differ
static void copyCommon
(
    const fileNameList& parts, PtrList<fsbi::stateFolder>& targets
)
{
    for (const fileName& file : fsbi::stateFolder::files(parts[0]))
    {
        if (file.components()[0] != "uniform")
        {
            continue;
        }
        const std::string content(contents(parts[0]/file));
        for (const fileName& part : parts)
        {
            if (contents(part/file) != content)
            {
                FatalErrorInFunction
                    << part/file << " is not the same as of processor 0, so it"
                    << " cannot be handed to another number of processes"
                    << exit(FatalError);
            }
        }
        for (fsbi::stateFolder& target : targets)
        {
            target.add(file, content);
        }
    }
}


static void redistribute
(
    const Time& time,
    const fileNameList& parts,
    const fileNameList& paths
)
{
    fsbi::stateFolder::verify(parts);
    wordHashSet names;
    for (const fileName& file : fsbi::stateFolder::files(parts[0]))
    {
        names.insert(file.components()[0]);
    }
    names.erase("uniform");

    PtrList<fsbi::stateFolder> targets
    (
        fsbi::stateFolder::parts(paths, time.timeName())
    );
    copyCommon(parts, targets);
    for (const word& name : names.sortedToc())
    {
        const fsbi::savedRegion region(time, name, parts, paths.size());
        forAll(targets, i)
        {
            region.write(i, targets[i]);
        }
    }
    for (fsbi::stateFolder& target : targets)
    {
        target.publish();
    }
}


static void sayNext(const label number)
{
    Info<< "Continue with   ";
    if (number > 1)
    {
        Info<< "mpirun -np " << number << " fsbiFoam -parallel" << nl << endl;
    }
    else
    {
        Info<< "fsbiFoam" << nl << endl;
    }
}


int main(int argc, char *argv[])
{
    argList::addNote
    (
        "A saved state for another number of processes.\n\n"
        "    fsbiRedistribute -np 4     for mpirun -np 4 fsbiFoam -parallel\n"
        "    fsbiRedistribute -np 1     for fsbiFoam, ParaView, foamToVTK\n\n"
        "Processors' folders of another number are moved to savedBy<N>."
    );
    argList::noParallel();
    argList::addOption("np", "N", "Processes that are to continue");
    argList::addOption("time", "T", "Time of the state (default: the last)");

    #include "setRootCase.H"
    const fileName path(args.path());
    const label number = args.lookupOrDefault<label>("np", 0);
    const scalar at = args.lookupOrDefault<scalar>("time", -1);
    if (number < 1)
    {
        FatalErrorInFunction
            << "For how many processes? Type   fsbiRedistribute -np N"
            << exit(FatalError);
    }
    const fsbi::runLock lock(args);
    exchangeFolders(path);

    const savedState state(find(path, number, at));
    if (state.number == 0)
    {
        FatalErrorInFunction
            << "There is no saved state "
            << (at < 0 ? "above time 0" : ("at time " + name(at)).c_str())
            << " in " << path << exit(FatalError);
    }
    if (state.number == number)
    {
        Info<< "The state at time " << state.time << " is of " << number
            << " process" << (number > 1 ? "es" : "") << " already" << nl;
        sayNext(number);
        return 0;
    }

    Time runTime(Time::controlDictName, args);
    scalar value = 0;
    readScalar(state.time, value);
    runTime.setTime(instant(value, state.time), 0);
    fileNameList parts(fsbi::savedProcesses::parts(path, state.number));
    for (fileName& part : parts)
    {
        part = part/state.time;
    }

    const label present = fsbi::savedProcesses(path).nFolders();
    const bool moves = number > 1 && present > 0 && present != number;
    redistribute
    (
        runTime, parts,
        fsbi::savedProcesses::parts(moves ? path/unfinished : path, number)
    );
    if (moves)
    {
        std::ofstream(path/unfinished/"older") << olderFolder(path);
        exchangeFolders(path);
    }
    Info<< "The state at time " << state.time << ", saved by " << state.number
        << " process" << (state.number > 1 ? "es" : "") << ", is there for "
        << number << nl;
    sayNext(number);
    return 0;
}
