/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runLock.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include <cerrno>
#include <sstream>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Foam
{
namespace fsbi
{

static const word lockName("fsbiFoam.lock");

// Of the process; not of an object, since exit() calls no destructors of those
// in main()

    static fileName lockFile;
    static int lockHandle = -1;

//- Who has a lock, as its file says
struct owner
{
    long process = 0;
    std::string host;

    explicit owner(const int handle)
    {
        char text[256] = "";
        if (::pread(handle, text, sizeof(text) - 1, 0) > 0)
        {
            std::string key;
            std::istringstream(text) >> key >> process >> key >> host;
        }
    }
};

//- Does the name still stand for the open file?
static bool isThere(const int handle)
{
    struct stat opened, named;
    return
        ::fstat(handle, &opened) == 0
     && ::stat(lockFile.c_str(), &named) == 0
     && opened.st_ino == named.st_ino;
}

static void refuse(const owner& other)
{
    FatalErrorInFunction
        << "Another run works in this case: process " << other.process
        << " on " << other.host.c_str() << ", by the file " << lockFile
        << ". Wait for it, or end it; if there is no such run any more, remove"
        << " the file" << exit(FatalError);
}

} // End namespace fsbi
} // End namespace Foam


bool Foam::fsbi::runLock::take()
{
    lockHandle = ::open(lockFile.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lockHandle < 0)
    {
        return true;        // what cannot be written to is told by who writes
    }
    const bool free =
        ::flock(lockHandle, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    const owner other(lockHandle);
    if (!free || (other.process && other.host != hostName()))
    {
        ::close(lockHandle);
        lockHandle = -1;
        refuse(other);
    }
    if (!isThere(lockHandle))
    {
        ::close(lockHandle);
        return false;
    }
    if (other.process)
    {
        Info<< "Process " << label(other.process) << ", which had this case, is"
            << " gone: taking over" << nl << endl;
    }
    const std::string text
    (
        "process " + std::to_string(::getpid()) + " host " + hostName() + "\n"
    );
    if
    (
        ::ftruncate(lockHandle, 0) != 0
     || ::pwrite(lockHandle, text.data(), text.size(), 0) < 0
    )
    {
        WarningInFunction << lockFile << " cannot be written" << endl;
    }
    return true;
}


void Foam::fsbi::runLock::release()
{
    if (lockHandle >= 0)
    {
        ::unlink(lockFile.c_str());
        ::close(lockHandle);
        lockHandle = -1;
    }
}


Foam::fsbi::runLock::runLock(const argList& args)
{
    if (Pstream::master())
    {
        lockFile = args.globalPath()/lockName;
        std::atexit(release);
        while (!take())
        {}
    }
    returnReduce(true, andOp<bool>());          // until the master has it
}
