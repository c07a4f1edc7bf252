/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timings.H"
#include "Ostream.H"
#include <malloc.h>
#include <sys/resource.h>

Foam::fsbi::timings::cost& Foam::fsbi::timings::at(const word& part)
{
    if (!costs_.found(part))
    {
        parts_.append(part);
        costs_.insert(part, cost());
    }
    return costs_[part];
}


Foam::scalar Foam::fsbi::timings::heap()
{
    const auto info = mallinfo2();
    return scalar(info.uordblks) + scalar(info.hblkhd);
}


Foam::fsbi::timings::scope Foam::fsbi::timings::profileMemory(const word& part)
{
    cost& c = at(part);
    c.memoryProfiled = true;
    return scope(*this, c);
}


Foam::scalar Foam::fsbi::timings::peakMemory()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1.024e-3*usage.ru_maxrss;
}


void Foam::fsbi::timings::report(Ostream& os) const
{
    const scalar all = total();
    scalar rest = all;

    const auto row = [&](const word& part, const scalar s, const char* end)
    {
        const std::string name = part + std::string(14, ' ');
        char line[120];
        snprintf
        (
            line, sizeof(line), "    %.14s %10.2f s %5.1f %%%s",
            name.c_str(), s, 100*s/max(all, SMALL), end
        );
        os << line << nl;
    };
    const auto megabytes = [](const scalar mb)
    {
        char text[40];
        snprintf(text, sizeof(text), " %10.2f MB", mb);
        return std::string(text);
    };

    os << nl << "Seconds per part" << nl;
    for (const word& part : parts_)
    {
        const cost& c = costs_[part];
        row
        (
            part, c.seconds,
            c.memoryProfiled ? megabytes(c.bytes/1e6).c_str() : ""
        );
        rest -= c.seconds;
    }
    row("other", rest, "");
    row("total", all, megabytes(peakMemory()).c_str());
}
