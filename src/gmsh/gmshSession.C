/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshSession.H"

#include <gmsh.h>

Foam::fsbi::gmshSession::gmshSession()
{
    for (const int s : {SIGFPE, SIGSEGV, SIGINT, SIGABRT, SIGTERM, SIGPIPE})
    {
        struct sigaction action;
        sigaction(s, nullptr, &action);
        handlers_.push_back({s, action});
    }
    // OpenFOAM traps division by zero, which gmsh relies on
    std::feholdexcept(&floatingPoint_);

    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.AbortOnError", 2);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::logger::start();
    gmsh::model::add("domain");
}


Foam::fsbi::gmshSession::~gmshSession()
{
    gmsh::logger::stop();
    gmsh::finalize();
    std::feclearexcept(FE_ALL_EXCEPT);
    std::fesetenv(&floatingPoint_);
    for (const auto& handler : handlers_)
    {
        sigaction(handler.first, &handler.second, nullptr);
    }
}


std::string Foam::fsbi::gmshSession::errors() const
{
    std::vector<std::string> log;
    gmsh::logger::get(log);
    std::string text;
    int n = 0;
    for (auto line = log.rbegin(); line != log.rend() && n < 5; ++line)
    {
        if (line->compare(0, 4, "Info"))
        {
            text = *line + "; " + text;
            ++n;
        }
    }
    return text;
}
