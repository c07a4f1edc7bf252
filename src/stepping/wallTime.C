/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallTime.H"
#include "PstreamReduceOps.H"
#include <regex>

namespace
{

//- Length of the next step in that of the longest one so far
const Foam::scalar reserve = 1.5;

} // End anonymous namespace


Foam::scalar Foam::fsbi::wallTime::seconds(const string& text)
{
    static const std::regex form
    (
        "(?:(?:(\\d+)-)?(?:(\\d+):))?(?:(\\d+):)?(\\d+(?:\\.\\d*)?)"
    );
    std::smatch parts;
    if (!std::regex_match(static_cast<const std::string&>(text), parts, form))
    {
        return -1;
    }
    const auto number = [&](const int i)
    {
        return parts[i].matched ? std::stod(parts[i].str()) : 0;
    };
    // of one colon only it is minutes that are before it
    const bool hours = parts[2].matched && parts[3].matched;
    if (parts[1].matched && !hours)
    {
        return -1;
    }
    const scalar minutes = hours ? number(3) : number(2) + number(3);
    return
        number(4) + 60*minutes
      + (hours ? 3600*(number(2) + 24*number(1)) : 0);
}


Foam::fsbi::wallTime::wallTime(const argList& args)
:
    given_(args.getOrDefault<string>("maxWallTime", "")),
    limit_(args.found("maxWallTime") ? seconds(given_) : GREAT),
    began_(-1),
    longest_(0)
{
    if (!(limit_ > 0))
    {
        FatalErrorInFunction
            << "-maxWallTime '" << given_.c_str() << "' is no time above zero:"
            << " seconds, or [days-][hours:]minutes:seconds, as 23:50:00"
            << exit(FatalError);
    }
}


void Foam::fsbi::wallTime::count()
{
    if (began_ >= 0)
    {
        longest_ = max(longest_, clock_.elapsedTime() - began_);
    }
}


void Foam::fsbi::wallTime::begin()
{
    count();
    began_ = clock_.elapsedTime();
}


Foam::string Foam::fsbi::wallTime::shortage()
{
    if (limit_ == GREAT)
    {
        return string();
    }
    count();
    bool short_ = clock_.elapsedTime() + reserve*longest_ > limit_;
    Pstream::scatter(short_);       // all end with the same step
    return
        short_
      ? "of -maxWallTime " + given_ + " too little is left for another step"
      : string();
}
