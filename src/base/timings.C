/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timings.H"
#include "Ostream.H"

void Foam::fsbi::timings::report(Ostream& os) const
{
    const scalar all = total();
    scalar rest = all;

    const auto row = [&](const word& part, const scalar s)
    {
        const std::string name = part + std::string(14, ' ');
        char line[80];
        snprintf
        (
            line, sizeof(line), "    %.14s %10.2f s %5.1f %%",
            name.c_str(), s, 100*s/max(all, SMALL)
        );
        os << line << nl;
    };

    os << nl << "Seconds per part" << nl;
    for (const word& part : parts_)
    {
        row(part, seconds_[part]);
        rest -= seconds_[part];
    }
    row("other", rest);
    row("total", all);
}
