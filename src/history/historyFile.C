/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "historyFile.H"
#include "error.H"
#include "FlatOutput.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * //

void Foam::fsbi::historyFile::fail(const std::string& what) const
{
    rm(file_ + ".part");
    FatalErrorInFunction
        << what.c_str() << nl
        << "    History file: " << file_ << nl
        << "    If it was damaged, move it away and start again: the run"
        << " will begin a new one. If the disk or a quota is full, make room first."
        << exit(FatalError);
}

void Foam::fsbi::historyFile::create()
{
    mkDir(file_.path());
    handle_ = hdf::create(file_);
    if (!handle_.valid() || H5Fflush(handle_, H5F_SCOPE_GLOBAL) < 0)
    {
        fail("Cannot create the history file");
    }
}

void Foam::fsbi::historyFile::continueFrom(const scalar startTime)
{
    // truncate a copy and put it in place at once: a kill meanwhile leaves
    // the old file
    const fileName part(file_ + ".part");
    if (!cp(file_, part) || fileSize(part) != fileSize(file_))
    {
        fail("Cannot write next to the history file: the disk is full");
    }
    {
        const hdfHandle copy = hdf::open(part);
        std::vector<std::string> paths;
        if (!copy.valid() || !hdf::datasets(copy, paths))
        {
            fail("Cannot read the existing history file: it is damaged or"
                " no HDF5 file");
        }
        for (const std::string& path : paths)
        {
            truncate(copy, path, startTime);
        }
    }
    if (!mv(part, file_))
    {
        fail("Cannot replace the history file");
    }
    handle_ = hdf::open(file_);
    if (!handle_.valid())
    {
        fail("Cannot open the history file");
    }
    openTables();
}

void Foam::fsbi::historyFile::truncate
(
    const hid_t file, const std::string& path, const scalar startTime
)
{
    const scalar latest = startTime + 1e-10*mag(startTime) + VSMALL;

    const hdfHandle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT));
    std::vector<double> times;
    hsize_t size[2];
    if
    (
        !dataset.valid()
     || !hdf::shape(dataset, size)
     || !hdf::readColumn(dataset, 0, times)
    )
    {
        fail("Cannot read table '" + path + "' of the history file");
    }

    hsize_t kept = 0;
    while (kept < times.size() && times[kept] <= latest)
    {
        ++kept;
    }
    if (kept == size[0])
    {
        return;
    }
    size[0] = kept;
    if (H5Dset_extent(dataset, size) < 0)
    {
        fail("Cannot shorten table '" + path + "' of the history file");
    }
}

void Foam::fsbi::historyFile::openTables()
{
    std::vector<std::string> paths;
    if (!hdf::datasets(handle_, paths))
    {
        fail("Cannot read the history file");
    }
    for (const std::string& path : paths)
    {
        tables_[path] = openTable(path);
    }
}

Foam::fsbi::historyFile::table Foam::fsbi::historyFile::openTable
(
    const std::string& path
)
{
    table t;
    t.dataset = hdfHandle(H5Dopen2(handle_, path.c_str(), H5P_DEFAULT));
    hsize_t size[2];
    std::vector<double> times;
    if
    (
        !t.dataset.valid()
     || !hdf::shape(t.dataset, size)
     || !hdf::readColumn(t.dataset, 0, times)
    )
    {
        fail("Cannot read table '" + path + "' of the history file");
    }
    t.rows = size[0];
    t.columns = size[1];
    t.lastTime = times.empty() ? -GREAT : times.back();
    return t;
}

void Foam::fsbi::historyFile::writeWaiting()
{
    for (auto& named : tables_)
    {
        table& t = named.second;
        if (t.waiting.empty())
        {
            continue;
        }
        const label old = t.rows - label(t.waiting.size())/t.columns;
        if (!hdf::addRows(t.dataset, old, t.columns, t.waiting))
        {
            fail("Cannot write to table '" + named.first + "' of the history file");
        }
        t.waiting.clear();
    }
}

void Foam::fsbi::historyFile::stopStreaming()
{
    if (streaming_)
    {
        writeWaiting();
        tables_.clear();
        handle_.close();
        handle_ = hdf::open(file_);
        if (!handle_.valid())
        {
            fail("Cannot open the history file again");
        }
        openTables();
        streaming_ = false;
    }
}

Foam::fsbi::historyFile::table& Foam::fsbi::historyFile::find
(
    const fileName& path
)
{
    const auto found = tables_.find(path);
    if (found == tables_.end())
    {
        wordList known;
        for (const auto& t : tables_)
        {
            known.append(word(t.first, false));
        }
        FatalErrorInFunction
            << "No history '" << path << "' is declared; there are "
            << flatOutput(known) << exit(FatalError);
    }
    return found->second;
}

// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::fsbi::historyFile::historyFile
(
    const fileName& file, const scalar startTime
)
:
    file_(file),
    writer_(Pstream::master()),
    streaming_(false)
{
    if (!writer_)
    {
        return;
    }
    const hdf::quiet silence;
    if (isFile(file_, false))
    {
        continueFrom(startTime);
    }
    else
    {
        create();
    }
}

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::historyFile::declare
(
    const fileName& path, const wordList& columns, const Foam::string& units
)
{
    if (!writer_)
    {
        return;
    }
    const hdf::quiet silence;
    std::vector<std::string> names{"time"};
    names.insert(names.end(), columns.begin(), columns.end());

    const auto existing = tables_.find(path);
    if (existing != tables_.end())
    {
        std::vector<std::string> old;
        if (!hdf::text(existing->second.dataset, "columns", old) || old != names)
        {
            fail("Table '" + path + "' exists with other columns");
        }
        return;
    }

    stopStreaming();
    {
        const hdfHandle t = hdf::createTable(handle_, path, names.size());
        if
        (
            !t.valid()
         || !hdf::setText(t, "columns", names)
         || !hdf::setText(t, "units", {units})
        )
        {
            fail("Cannot make table '" + path + "' in the history file");
        }
    }
    H5Fflush(handle_, H5F_SCOPE_GLOBAL);
    tables_[path] = openTable(path);
}

void Foam::fsbi::historyFile::append
(
    const fileName& path, const scalar time, const UList<scalar>& row
)
{
    if (!writer_)
    {
        return;
    }
    table& t = find(path);
    if (row.size() + 1 != t.columns)
    {
        FatalErrorInFunction
            << "History '" << path << "' has " << t.columns - 1
            << " columns besides the time, but the row has " << row.size()
            << exit(FatalError);
    }
    if (time < t.lastTime)
    {
        FatalErrorInFunction
            << "History '" << path << "' goes back in time, from "
            << t.lastTime << " to " << time << exit(FatalError);
    }

    t.waiting.push_back(time);
    t.waiting.insert(t.waiting.end(), row.begin(), row.end());
    ++t.rows;
    t.lastTime = time;
}

void Foam::fsbi::historyFile::note
(
    const fileName& group, const word& name, const UList<string>& lines
)
{
    if (!writer_ || lines.empty())
    {
        return;
    }
    const hdf::quiet silence;
    stopStreaming();
    const hdfHandle g = hdf::openGroup(handle_, group);
    const std::vector<std::string> text(lines.begin(), lines.end());
    if (!g.valid() || !hdf::setText(g, name.c_str(), text))
    {
        fail("Cannot note '" + name + "' in the history file");
    }
}


void Foam::fsbi::historyFile::flush()
{
    if (!writer_)
    {
        return;
    }
    const hdf::quiet silence;
    if (!streaming_)
    {
        streaming_ = H5Fstart_swmr_write(handle_) >= 0;
        if (!streaming_)
        {
            fail("Cannot start writing the history file");
        }
    }
    writeWaiting();
    if (H5Fflush(handle_, H5F_SCOPE_LOCAL) < 0)
    {
        fail("Cannot write the history file");
    }
}

Foam::label Foam::fsbi::historyFile::rows(const fileName& path) const
{
    const auto t = tables_.find(path);
    return t == tables_.end() ? 0 : t->second.rows;
}
