/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partner.H"

#include <limits>

using namespace Foam;
using namespace Foam::fsbi;

void Foam::fsbi::checkRefused(checks& c)
{
    const partner p(scalarList(1, scalar(1)));
    const auto refused = [&]
    (
        const std::string& entries, const std::string& text
    )
    {
        c.checkFatal("refused: " + entries, [&]{ makeLoop(entries, p); }, text);
    };
    const std::string choices("(Aitken IQNILS explicit semiImplicit)");
    refused("method none;", choices);
    refused("method aitken;", choices);
    refused("", "method");
    refused("method semiImplicit;", "omega");
    refused("method semiImplicit; omega 0;", "'omega' must be above zero");
    refused("method Aitken; omega -0.1;", "'omega' must be above zero");
    refused("method Aitken; omega 0.5; maxOmega 0.2;", "below the first");
    refused("method IQNILS; omega 0;", "'omega' must be above zero");
    refused("method IQNILS; reuse -1;", "'reuse' must be 0 or more");
    refused("method IQNILS; filter 0;", "'filter' must be above zero");
    refused("method IQNILS; filter 1;", "below 1");
    refused("method IQNILS; filter 1e-16;", "1e-14 or more");
    refused("method IQNILS; maxOmega 1;", "Unknown keyword 'maxOmega'");
    refused("method explicit; omega 1;", "Unknown keyword 'omega'");
    refused("method Aitken; tolerance 0;", "'tolerance' must be above zero");
    refused("method Aitken; maxIterations 0;", "'maxIterations' must be 1");

    // the complete dictionaries of the manuals
    const std::string loop(" tolerance 1e-6; maxIterations 50;");
    makeLoop("method explicit;" + loop, p);
    makeLoop("method semiImplicit; omega 0.1;" + loop, p);
    makeLoop("method Aitken; omega 0.1; maxOmega 1;" + loop, p);
    makeLoop("method IQNILS; omega 0.1; reuse 2; filter 1e-8;" + loop, p);
    c.check("the manuals' dictionaries are read", true);
}


void Foam::fsbi::checkFailures(checks& c)
{
    const partner p(partner::spread(10, 1, 1000));
    const auto failure = [&]
    (
        const std::string& entries, const couplingLoop::pass& H
    )
    {
        autoPtr<couplingLoop> loop(makeLoop(entries, p));
        scalarField x(p.weights().size(), Zero);
        loop->beginStep();
        const solverReport report(loop->solve(H, 1, x));
        loop->rewind();
        return report.converged ? "converged" : report.failure;
    };
    const auto plain = [&](const scalarField& x, scalarField& Hx)
    {
        Hx = p.H(x);
        return outcome();
    };
    const std::string fixed("method semiImplicit; omega 1; maxIterations ");
    c.check
    (
        "a loop that diverges says so",
        failure(fixed + "1000;", plain).find("diverges") != string::npos
    );
    c.check
    (
        "too few passes are no failure", failure(fixed + "2;", plain).empty()
    );
    c.check
    (
        "a partner's failure ends the loop",
        failure
        (
            "method IQNILS;",
            [](const scalarField&, scalarField&)
            {
                return outcome::failed("no mesh");
            }
        ) == "no mesh"
    );
    for (const scalar bad : {std::numeric_limits<scalar>::quiet_NaN(), VGREAT})
    {
        const string why = failure
        (
            "method IQNILS;",
            [&](const scalarField& x, scalarField& Hx)
            {
                Hx = scalarField(x.size(), bad);
                return outcome();
            }
        );
        c.check
        (
            "a result that is no number ends the loop",
            why.find("not a number") != string::npos, why
        );
    }
}
