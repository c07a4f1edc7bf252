/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partner.H"
#include "OFstream.H"

using namespace Foam;
using namespace Foam::fsbi;

// One row: how a method does with one unknown, H(x) = -r x + b
static stepRun row
(
    autoPtr<OFstream>& table, const std::string& method, const scalar omega,
    const scalar r, const scalar theory
)
{
    const partner p(scalarList(1, r));
    OStringStream entries;
    entries << "method " << method.c_str() << "; tolerance 1e-7; "
        << "maxIterations 20000; omega " << omega << ';';
    autoPtr<couplingLoop> loop(makeLoop(entries.str(), p));
    scalarField x(p.weights().size(), Zero);
    const stepRun run(loop(), p, x);
    // exact methods need one pass to learn
    const label last = run.residuals.size() - 1;
    const label pass = theory == 0 ? min(last, 2) : 1;
    if (table)
    {
        char line[160];
        snprintf
        (
            line, sizeof(line), "%s,%g,%.6g,%.10g,%.10g,%d,%s",
            method.c_str(), omega, r, theory, pass ? run.factor(pass) : 0,
            int(run.report.iterations), run.report.converged ? "yes" : "no"
        );
        table() << line << endl;
    }
    return run;
}


static void checkFixed
(
    checks& c, autoPtr<OFstream>& table, const scalarList& ratios,
    const scalar omega
)
{
    scalar worst = 0;
    bool asExpected = true;
    for (const scalar r : ratios)
    {
        const scalar theory = mag(1 - omega*(1 + r));
        const stepRun run(row(table, "semiImplicit", omega, r, theory));
        worst = max(worst, mag(run.factor(1) - theory)/max(theory, 1.0));
        asExpected = asExpected && run.report.converged == (theory < 1)
            && run.report.failure.empty() == (theory < 1);
    }
    const std::string name("semiImplicit, omega " + Foam::name(omega));
    c.checkBelow(name + ": contraction |1 - omega(1 + r)|", worst, 1e-6);
    c.check(name + ": converges where that is below 1 only", asExpected);
}


static void checkSecant
(
    checks& c, autoPtr<OFstream>& table, const scalarList& ratios,
    const std::string& method
)
{
    label most = 0;
    bool converged = true;
    for (const scalar r : ratios)
    {
        const stepRun run(row(table, method, 0.1, r, 0));
        most = max(most, run.report.iterations);
        converged = converged && run.report.converged;
    }
    c.check(method + ", one unknown: converges for all r", converged);
    c.checkBelow(method + ", one unknown: passes", most, 3);
}


void Foam::fsbi::checkContraction(checks& c, const fileName& path)
{
    autoPtr<OFstream> table;
    if (path.size() && Pstream::master())
    {
        table.reset(new OFstream(path));
        table() << "method,omega,r,theory,measured,passes,converged" << endl;
    }
    const scalarList ratios(partner::spread(21, 0.01, 1000));
    for (const scalar omega : {1., 0.5, 0.1, 0.01, 0.0015})
    {
        // 1 is the plain repetition, r = 1 its limit
        scalarList tried(ratios);
        if (omega == 1)
        {
            tried[8] = 0.99;
        }
        checkFixed(c, table, tried, omega);
    }
    checkSecant(c, table, ratios, "Aitken");
    checkSecant(c, table, ratios, "IQNILS");
}


void Foam::fsbi::checkExplicit(checks& c)
{
    scalar worst = 0;
    bool onePass = true;
    for (const scalar r : {0.01, 0.5, 2., 200.})
    {
        const partner p(scalarList(1, r));
        autoPtr<couplingLoop> loop(makeLoop("method explicit;", p));
        scalarField x(p.weights().size(), Zero);
        const stepRun first(loop(), p, x);
        const stepRun second(loop(), p, x);
        worst = max
        (
            worst, mag(second.residuals[0]/first.residuals[0] - r)/max(r, 1.)
        );
        const scalarField twice(p.H(p.H(scalarField(x.size(), Zero))));
        onePass = onePass && x == twice
            && first.report.iterations == 1 && first.report.converged;
    }
    reduce(onePass, andOp<bool>());
    c.check("explicit: one pass a step, accepted as it is", onePass);
    c.checkBelow("explicit: errors grow by r from step to step", worst, 1e-6);
}
