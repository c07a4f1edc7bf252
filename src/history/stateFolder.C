/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stateFolder.H"
#include "error.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "HashSet.H"
#include "SHA1.H"
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Foam
{
namespace fsbi
{

static const fileName manifestName("uniform/checkpoint");
static const std::string manifestTitle("fsbiFoam state");
static const std::string manifestEnd("end");
static const word partEnding(".part");

static std::string contents(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream os;
    os << is.rdbuf();
    return os.str();
}

static std::string digest(const std::string& content)
{
    return SHA1(content).str();
}

//- Force a file, or the entries of a folder, to the disk
static bool toDisk(const fileName& name)
{
    const int handle = ::open(name.c_str(), O_RDONLY);
    const bool done = handle >= 0 && ::fsync(handle) == 0;
    if (handle >= 0)
    {
        ::close(handle);
    }
    return done;
}

static bool makeFolders(const fileName& folder)
{
    return
        isDir(folder)
     || (makeFolders(folder.path()) && ::mkdir(folder.c_str(), 0777) == 0);
}

} // End namespace fsbi
} // End namespace Foam


std::string Foam::fsbi::stateFolder::newId()
{
    long long now =
        std::chrono::system_clock::now().time_since_epoch().count();
    string id(std::to_string(now));
    Pstream::scatter(id);
    return id;
}


Foam::fsbi::stateFolder::stateFolder(const fileName& path, const word& name)
:
    stateFolder(path, name, newId())
{}


Foam::fsbi::stateFolder::stateFolder
(
    const fileName& path, const word& name, const std::string& id
)
:
    path_(path),
    name_(name),
    part_(path/(name + partEnding)),
    id_(id)
{
    if (isDir(part_))
    {
        rmDir(part_);
    }
}


Foam::PtrList<Foam::fsbi::stateFolder> Foam::fsbi::stateFolder::parts
(
    const fileNameList& paths, const word& name
)
{
    const std::string id(newId());
    PtrList<stateFolder> result;
    for (const fileName& path : paths)
    {
        result.append(new stateFolder(path, name, id));
    }
    return result;
}


void Foam::fsbi::stateFolder::write
(
    const fileName& file,
    const std::string& content
)
{
    if (!failure_.empty())
    {
        return;
    }
    errno = 0;
    FILE* handle = makeFolders(file.path()) ? fopen(file.c_str(), "wb") : nullptr;
    bool good =
        handle
     && fwrite(content.data(), 1, content.size(), handle) == content.size()
     && fflush(handle) == 0
     && ::fsync(fileno(handle)) == 0;
    const int reason = errno;
    if (handle)
    {
        good = fclose(handle) == 0 && good;
    }
    if (!good)
    {
        failure_ = file + " cannot be written: " + strerror(reason);
    }
}


void Foam::fsbi::stateFolder::add
(
    const fileName& name,
    const std::string& content
)
{
    write(part_/name, content);
    records_.append(record{name, (long long)content.size(), digest(content)});
}


void Foam::fsbi::stateFolder::writeManifest()
{
    std::ostringstream os;
    os << manifestTitle << ' ' << id_ << '\n';
    for (const record& r : records_)
    {
        os << r.digest << ' ' << r.size << ' ' << r.name << '\n';
    }
    os << manifestEnd << '\n';
    write(part_/manifestName, os.str());
    if (failure_.empty())
    {
        std::string id;
        failure_ = failureReason(part_, id);
    }
}


bool Foam::fsbi::stateFolder::readManifest
(
    const fileName& folder,
    std::string& id,
    DynamicList<record>& records
)
{
    std::istringstream is(contents(folder/manifestName));
    std::string line;
    if
    (
        !std::getline(is, line)
     || line.compare(0, manifestTitle.size(), manifestTitle)
     || line.size() < manifestTitle.size() + 2
    )
    {
        return false;
    }
    id = line.substr(manifestTitle.size() + 1);
    while (std::getline(is, line) && line != manifestEnd)
    {
        record r;
        std::istringstream fields(line);
        if (!(fields >> r.digest >> r.size >> r.name))
        {
            return false;
        }
        records.append(r);
    }
    return line == manifestEnd && records.size();
}


std::string Foam::fsbi::stateFolder::failureReason
(
    const fileName& folder,
    std::string& id
)
{
    DynamicList<record> records;
    if (!isDir(folder))
    {
        return "there is no folder " + folder;
    }
    if (!readManifest(folder, id, records))
    {
        return folder/manifestName + " is missing or damaged";
    }
    for (const record& r : records)
    {
        const fileName file(folder/r.name);
        if (!isFile(file, false))
        {
            return file + " is missing";
        }
        const std::string content(contents(file));
        if ((long long)content.size() < r.size)
        {
            return
                file + " is cut short: " + std::to_string(content.size())
              + " of " + std::to_string(r.size) + " bytes";
        }
        if ((long long)content.size() != r.size || digest(content) != r.digest)
        {
            return file + " was changed since it was saved";
        }
    }
    return std::string();
}


void Foam::fsbi::stateFolder::agree() const
{
    List<string> failures(Pstream::nProcs());
    failures[Pstream::myProcNo()] = failure_;
    Pstream::gatherList(failures);
    Pstream::scatterList(failures);
    for (const string& failure : failures)
    {
        if (!failure.empty())
        {
            rmDir(part_);
            returnReduce(true, andOp<bool>());
            FatalErrorInFunction
                << "The state at time " << name_ << " could not be saved: "
                << failure.c_str() << ". Saved states are untouched; make room"
                << " and continue with 'startFrom latestTime'"
                << exit(FatalError);
        }
    }
}


void Foam::fsbi::stateFolder::keepUsersFiles() const
{
    const fileName final(path_/name_);
    if (!isDir(final) || isFile(final/manifestName))
    {
        return;
    }
    DynamicList<fileName> folders(1, fileName());
    while (folders.size())
    {
        const fileName folder(folders.remove());
        for (const fileName& sub : readDir(final/folder, fileName::DIRECTORY))
        {
            folders.append(folder/sub);
        }
        for (const fileName& file : readDir(final/folder, fileName::FILE))
        {
            const fileName target(part_/folder/file);
            if (!isFile(target) && makeFolders(target.path()))
            {
                cp(final/folder/file, target);
            }
        }
    }
}


void Foam::fsbi::stateFolder::exchange
(
    const fileName& part,
    const fileName& final
)
{
    if (!exists(final, false))
    {
        ::rename(part.c_str(), final.c_str());
    }
    else if
    (
        ::renameat2
        (
            AT_FDCWD, part.c_str(), AT_FDCWD, final.c_str(), RENAME_EXCHANGE
        ) == 0
    )
    {
        rmDir(part);
    }
    else
    {
        // a file system that cannot do it at once; recover() knows the rest
        rmDir(final);
        ::rename(part.c_str(), final.c_str());
    }
    toDisk(final.path());
}


void Foam::fsbi::stateFolder::publish()
{
    writeManifest();
    agree();
    keepUsersFiles();
    returnReduce(true, andOp<bool>());      // all are whole: rename
    exchange(part_, path_/name_);
}


Foam::wordList Foam::fsbi::stateFolder::unfinished(const fileName& path)
{
    wordHashSet names;
    for (const fileName& name : readDir(path, fileName::DIRECTORY))
    {
        const word base(name.lessExt());
        scalar time;
        if (name.ext() == "part" && readScalar(base, time))
        {
            names.insert(base);
        }
    }
    List<wordList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = names.toc();
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    for (const wordList& more : all)
    {
        names.insert(more);
    }
    return names.sortedToc();
}


void Foam::fsbi::stateFolder::recover(const fileName& path)
{
    for (const word& name : unfinished(path))
    {
        const fileName part(path/(name + partEnding)), final(path/name);
        std::string partId, finalId;
        DynamicList<record> records;
        if (!failureReason(part, partId).empty())
        {
            partId.clear();
        }
        readManifest(final, finalId, records);

        // the newest state that every processor has
        List<wordList> ids(Pstream::nProcs());
        ids[Pstream::myProcNo()] =
            wordList({word(partId, false), word(finalId, false)});
        Pstream::gatherList(ids);
        Pstream::scatterList(ids);
        word newest;
        for (const word& id : ids[0])
        {
            bool everywhere = !id.empty();
            for (const wordList& other : ids)
            {
                everywhere = everywhere && other.found(id);
            }
            if (everywhere && id > newest)
            {
                newest = id;
            }
        }
        if (!newest.empty() && newest == partId && newest != finalId)
        {
            exchange(part, final);
        }
        rmDir(part, true);
    }
}


void Foam::fsbi::stateFolder::refuse
(
    const fileName& folder,
    const UList<string>& failures,
    const UList<string>& ids
)
{
    forAll(failures, rank)
    {
        const string failure
        (
            failures[rank].size() || ids[rank] == ids[0]
          ? failures[rank]
          : string
            (
                "the processors' parts of " + folder + " were saved at"
                " different moments"
            )
        );
        if (!failure.empty())
        {
            FatalErrorInFunction
                << "The saved state cannot be used: " << failure.c_str()
                << ". To start from an earlier time, remove " << folder
                << exit(FatalError);
        }
    }
}


void Foam::fsbi::stateFolder::verify(const fileName& folder)
{
    std::string id;
    List<string> failures(Pstream::nProcs());
    List<string> ids(Pstream::nProcs());
    failures[Pstream::myProcNo()] = failureReason(folder, id);
    ids[Pstream::myProcNo()] = id;
    Pstream::gatherList(failures);
    Pstream::gatherList(ids);
    if (Pstream::master())
    {
        refuse(folder, failures, ids);
    }
}


void Foam::fsbi::stateFolder::verify(const fileNameList& folders)
{
    List<string> failures(folders.size());
    List<string> ids(folders.size());
    forAll(folders, i)
    {
        std::string id;
        failures[i] = failureReason(folders[i], id);
        ids[i] = id;
    }
    refuse(folders[0], failures, ids);
}


bool Foam::fsbi::stateFolder::isState(const fileName& folder)
{
    return isFile(folder/manifestName);
}


Foam::fileNameList Foam::fsbi::stateFolder::files(const fileName& folder)
{
    std::string id;
    DynamicList<record> records;
    readManifest(folder, id, records);
    fileNameList names(records.size());
    forAll(names, i)
    {
        names[i] = records[i].name;
    }
    return names;
}
