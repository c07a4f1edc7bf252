/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestHistory

Description
    The history file: write, continue, refuse, and survive a kill. Seconds per
    part of a run.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "historyFile.H"
#include "timings.H"
#include "OSspecific.H"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace Foam;
using fsbi::historyFile;

static const fileName position("bodies/cell/position");
static const fileName events("bonds/events");


// Row n of the position: its time n, then n^2, -n, 1/(n + 1)
static void append(historyFile& history, const label n)
{
    history.append(position, n, scalarList({n*scalar(n), -scalar(n), 1.0/(n + 1)}));
    history.append(events, n, scalarList({scalar(n % 7)}));
}


static void write(historyFile& history, const label from, const label to)
{
    for (label n = from; n <= to; ++n)
    {
        append(history, n);
        history.flush();
    }
}


static void declare(historyFile& history)
{
    history.declare(position, {"x", "y", "z"}, "um");
    history.declare(events, {"bonds"}, "bonds formed");
}


static std::vector<double> column(const fileName& file, const fileName& path, const label i)
{
    const fsbi::hdf::quiet silence;
    std::vector<double> values;

    // as a reader beside a running or after a killed run
    const fsbi::hdfHandle f
    (
        H5Fopen(file.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, H5P_DEFAULT)
    );
    const fsbi::hdfHandle table(H5Dopen2(f, path.c_str(), H5P_DEFAULT));
    fsbi::hdf::readColumn(table, i, values);
    return values;
}


// Times 0 1 2 ... and squares to match: complete rows without a gap
static bool sound(const fileName& file)
{
    const std::vector<double> times = column(file, position, 0);
    const std::vector<double> x = column(file, position, 1);
    bool good = !times.empty() && times.size() == x.size();
    for (size_t n = 0; n < times.size(); ++n)
    {
        good = good && times[n] == n && x[n] == double(n*n);
    }
    return good;
}


static void testWriteAndContinue(fsbi::checks& checks, const fileName& file)
{
    {
        historyFile history(file, 0);
        declare(history);
        write(history, 0, 2000);
        checks.check("rows are counted", history.rows(position) == 2001);
    }
    checks.check("all rows are read back", sound(file) && column(file, position, 0).size() == 2001);

    {
        historyFile history(file, 1500);
        declare(history);
        checks.check("a restart drops later rows", history.rows(position) == 1501);
        write(history, 1501, 1600);
        history.declare("late/table", {"a"}, "-");
        history.append("late/table", 1600, scalarList(1, 3.0));
        write(history, 1601, 1601);
    }
    checks.check("a continued history has no gap", sound(file) && column(file, position, 0).size() == 1602);
    checks.check("a table may be declared late", column(file, "late/table", 1) == std::vector<double>{3});
    {
        historyFile history(file, -1);
        checks.check("a restart before all rows empties", history.rows(events) == 0);
    }
    checks.check
    (
        "no handle of HDF5 is left open",
        H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL) == 0
    );
}


// Rows of many steps in one piece, larger than a chunk of the file; a new table
// between
static void testTogether(fsbi::checks& checks, const fileName& file)
{
    {
        historyFile history(file, 0);
        declare(history);
        label n = 0;
        const auto upTo = [&](const label end)
        {
            while (n < end)
            {
                append(history, n++);
            }
        };
        upTo(3);
        history.flush();
        upTo(5003);
        checks.check("rows that wait are counted", history.rows(position) == 5003);
        checks.check("and wait", column(file, position, 0).size() == 3);
        history.declare("late/table", {"a"}, "-");
        upTo(5010);
        history.flush();
        history.flush();
    }
    checks.check
    (
        "rows of many steps come to the file together",
        sound(file) && column(file, position, 0).size() == 5010
     && column(file, events, 1).size() == 5010
     && column(file, events, 1)[5009] == 5009 % 7
    );
}


static void testRefusals(fsbi::checks& checks, const fileName& file)
{
    {
        historyFile history(file, 0);
        declare(history);
        history.append(events, 5, scalarList(1, 0.0));
        checks.checkFatal("a short row is refused", [&]
            { history.append(position, 6, scalarList(2, 0.0)); }, "3 columns");
        checks.checkFatal("an undeclared path is refused", [&]
            { history.append("bodies/nobody", 6, scalarList(2, 0.0)); }, "position");
        checks.checkFatal("time does not go back", [&]
            { history.append(events, 4, scalarList(1, 0.0)); }, "back in time");
        checks.checkFatal("other columns are refused", [&]
            { history.declare(position, {"x"}, "um"); }, "other columns");
    }
    const fileName broken(file + ".broken");
    std::ofstream(broken) << "this is no HDF5 file\n";
    checks.checkFatal("a damaged file is named", [&]
        { historyFile history(broken, 0); }, broken);
    checks.check("and left as it is", isFile(broken, false));
}


// A child writes without end and is killed at some moment; the history must
// be readable, complete up to the last flush, and able to go on
static void testKill(fsbi::checks& checks, const fileName& file)
{
    bool readable = true, lasts = true, continues = true;
    for (label i = 0; i < 20; ++i)
    {
        rm(file);
        int told[2];
        if (pipe(told)) return;
        const pid_t child = fork();
        if (child == 0)
        {
            historyFile history(file, 0);
            declare(history);
            for (label n = 0; ; ++n)
            {
                write(history, n, n);
                if (::write(told[1], &n, sizeof(n)) < 0) _exit(1);
            }
        }
        close(told[1]);
        label flushed = -1, n;
        while (flushed < 150 + 37*i && read(told[0], &n, sizeof(n)) == sizeof(n))
        {
            flushed = n;
        }
        usleep(100*i);
        kill(child, SIGKILL);
        while (read(told[0], &n, sizeof(n)) == sizeof(n))
        {
            flushed = n;
        }
        close(told[0]);
        waitpid(child, nullptr, 0);

        readable = readable && sound(file);
        lasts = lasts && label(column(file, position, 0).size()) > flushed;
        {
            historyFile history(file, flushed);
            declare(history);
            write(history, flushed + 1, flushed + 100);
        }
        continues = continues && sound(file)
         && label(column(file, position, 0).size()) == flushed + 101;
    }
    checks.check("20 killed runs leave readable histories", readable);
    checks.check("with every flushed row", lasts);
    checks.check("that can be continued", continues);
}


//- Seconds of a part within another are not counted twice
static void testTimings(fsbi::checks& checks)
{
    fsbi::timings timings;
    const auto wait = [](const double s) { usleep(useconds_t(1e6*s)); };
    {
        auto outer = timings.measure("outer");
        wait(0.05);
        {
            auto inner = timings.measure("inner");
            wait(0.1);
        }
        {
            auto inner = timings.profileMemory("inner");
            wait(0.1);
        }
    }
    {
        auto alone = timings.measure("alone");
        wait(0.05);
    }
    const scalar
        outer = timings.seconds("outer"),
        inner = timings.seconds("inner"),
        alone = timings.seconds("alone");
    checks.check("seconds of the inner part", inner >= 0.2);
    checks.check("seconds of the outer part without it", outer >= 0.05);
    checks.check("seconds of a part after them", alone >= 0.05);
    checks.check
    (
        "parts together take no more than the run",
        outer + inner + alone <= timings.total()
    );
}


int main()
{
    fsbi::checks checks;
    const fileName scratch(cwd()/("fsbiTestHistory." + Foam::name(pid())));
    mkDir(scratch);

    testKill(checks, scratch/"kill.h5");
    testWriteAndContinue(checks, scratch/"folder/history.h5");
    testTogether(checks, scratch/"together.h5");
    testRefusals(checks, scratch/"refuse.h5");
    testTimings(checks);

    rmDir(scratch);
    return checks.finish();
}
