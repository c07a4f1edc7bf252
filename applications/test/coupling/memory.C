/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partner.H"

using namespace Foam;
using namespace Foam::fsbi;

static const std::vector<std::string> methods
({
    "method explicit; tolerance 1e-8;",
    "method semiImplicit; omega 0.1; tolerance 1e-8; maxIterations 2000;",
    "method Aitken; tolerance 1e-8; maxIterations 2000;",
    "method IQNILS; tolerance 1e-8;",
    "method IQNILS; reuse 3; tolerance 1e-8;"
});


// In a problem that explicit passes survive for some steps
static partner problem()
{
    return partner(partner::spread(30, 0.01, 10), partner::shared, 0.3);
}


static autoPtr<couplingLoop> restarted
(
    const std::string& entries, const couplingLoop& old, const partner& p
)
{
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    old.save(state);
    OStringStream text;
    text<< state;
    IOstream::defaultPrecision(precision);
    autoPtr<couplingLoop> loop(makeLoop(entries, p));
    loop->restore(dictionary{IStringStream(text.str())()});
    return loop;
}


static void checkRewind(checks& c, const std::string& entries)
{
    partner p(problem());
    autoPtr<couplingLoop> a(makeLoop(entries, p));
    autoPtr<couplingLoop> b(makeLoop(entries, p));
    scalarField x(p.weights().size(), Zero);
    scalarField y(x);
    bool same = true;
    for (label step = 0; step < 5; ++step)
    {
        p.aim(2*step + 1);
        scalarField rejected(y);
        const stepRun lost(b(), p, rejected, false);
        p.aim(step);
        const stepRun plain(a(), p, x);
        const stepRun again(b(), p, y);
        same = same && x == y && plain.residuals == again.residuals;
    }
    reduce(same, andOp<bool>());
    c.check(entries + " rewound is as never tried", same);
}


static void checkRestart(checks& c, const std::string& entries)
{
    bool same = true;
    for (label kill = 0; kill < 4; ++kill)
    {
        partner p(problem());
        autoPtr<couplingLoop> a(makeLoop(entries, p));
        autoPtr<couplingLoop> b;
        scalarField x(p.weights().size(), Zero);
        scalarField y;
        for (label step = 0; step < 6; ++step)
        {
            p.aim(step);
            if (step == kill)
            {
                b = restarted(entries, a(), p);
                y = x;
            }
            const stepRun plain(a(), p, x);
            if (step >= kill)
            {
                const stepRun other(b(), p, y);
                same = same && x == y && plain.residuals == other.residuals;
            }
        }
    }
    reduce(same, andOp<bool>());
    c.check(entries + " restarted is as never stopped", same);
}


// A state of another method or interface: the run goes on without memory
static void checkForeign(checks& c)
{
    const partner p(problem());
    autoPtr<couplingLoop> old(makeLoop(methods[4], p));
    scalarField x(p.weights().size(), Zero);
    stepRun(old(), p, x);
    bool converged = true;
    for (const std::string& entries : methods)
    {
        autoPtr<couplingLoop> loop(restarted(entries, old(), p));
        scalarField y(x.size(), Zero);
        converged = converged && stepRun(loop(), p, y).report.converged;
    }
    c.check("the state of another method does no harm", converged);

    const partner other(partner::spread(20, 0.01, 10));
    autoPtr<couplingLoop> loop(restarted(methods[4], old(), other));
    autoPtr<couplingLoop> fresh(makeLoop(methods[4], other));
    scalarField y(other.weights().size(), Zero);
    scalarField z(y);
    const stepRun a(loop(), other, y);
    const stepRun b(fresh(), other, z);
    c.check
    (
        "the state of another division is not used",
        a.residuals == b.residuals
    );

    old->start(other.weights());
    y = 0;
    const stepRun anew(old(), other, y);
    c.check
    (
        "a new interface starts without memory", anew.residuals == b.residuals
    );
}


void Foam::fsbi::checkMemory(checks& c)
{
    for (const std::string& entries : methods)
    {
        checkRewind(c, entries);
        checkRestart(c, entries);
    }
    checkForeign(c);
}
