/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partner.H"
#include "interfaceLeastSquares.H"
#include "IQNILS.H"

using namespace Foam;
using namespace Foam::fsbi;

typedef std::vector<label> passes;

static const std::string limits
(
    " tolerance 1e-7; maxIterations 20000;"
);


// Passes in three steps with slowly changing solutions; -1: not converged
static passes threeSteps
(
    checks& c, const std::string& method, const scalarList& eigenvalues,
    const scalar s = 0
)
{
    passes all;
    scalar worst = 0;
    for (const auto where : {partner::shared, partner::onLast})
    {
        partner p(eigenvalues, where, s);
        autoPtr<couplingLoop> loop(makeLoop("method " + method + limits, p));
        scalarField x(p.weights().size(), Zero);
        for (label step = 0; step < 3; ++step)
        {
            p.aim(step);
            const stepRun run(loop(), p, x);
            all.push_back(run.report.converged ? run.report.iterations : -1);
            worst = max(worst, p.error(x, step));
        }
    }
    const bool same = std::equal(all.begin(), all.begin() + 3, all.begin() + 3);
    all.resize(3);
    std::string text(method + " passes:");
    for (const label n : all)
    {
        text += ' ' + Foam::name(n);
    }
    Info<< "    " << text.c_str() << endl;
    if (all[0] > 0)
    {
        const std::string name((s > 0 ? "nonlinear: " : "spectrum: ") + method);
        c.checkBelow(name + " the solution", worst, 1e-6);
        // hundreds of secants magnify round-off: no two divisions agree then
        c.check
        (
            name + " the same passes for any division",
            same || (method == "Aitken;" && all[0] > 100)
        );
    }
    return all;
}


void Foam::fsbi::checkSpectrum(checks& c)
{
    const label n = 60;
    const scalarList lambda(partner::spread(n, 1e-3, 1e3));
    const auto run = [&](const std::string& method)
    {
        return threeSteps(c, method, lambda);
    };
    Info<< "Added-mass spectrum, r from 0.001 to 1000, 60 unknowns" << endl;
    const passes plain(run("semiImplicit; omega 1;"));
    c.check("spectrum: plain repetition diverges", plain[0] < 0);
    const passes high(run("semiImplicit; omega 0.0021;"));
    c.check("spectrum: semiImplicit above 2/1001 diverges", high[0] < 0);
    const passes low(run("semiImplicit; omega 0.0019;"));
    c.check("spectrum: semiImplicit below 2/1001 converges", low[0] > 100);
    const passes Aitken(run("Aitken;"));
    c.check("spectrum: Aitken converges", Aitken[0] > 0 && Aitken[2] > 0);

    const passes none(run("IQNILS;"));
    const passes two(run("IQNILS; reuse 2;"));
    c.check
    (
        "spectrum: IQNILS within n + 2 passes",
        none[0] > 0 && max(none[0], max(none[1], none[2])) <= n + 2
    );
    c.check
    (
        "spectrum: reused columns spare passes in the steps that follow",
        two[0] == none[0] && two[1] > 0 && two[1] <= 0.6*none[1]
     && two[2] > 0 && two[2] <= two[1]
    );
    c.check("spectrum: Aitken needs more than IQNILS", Aitken[0] > none[0]);
}


void Foam::fsbi::checkSuperlinear(checks& c)
{
    const partner p(partner::spread(60, 1e-3, 1e3));
    autoPtr<couplingLoop> loop
    (
        makeLoop("method IQNILS; tolerance 1e-9; maxIterations 62;", p)
    );
    scalarField x(p.weights().size(), Zero);
    const scalarList residuals(stepRun(loop(), p, x).residuals);
    // mean factors of the last ten passes and of the ten before
    const label last = residuals.size() - 1;
    const scalar late = Foam::pow(residuals[last]/residuals[last - 10], 0.1);
    const scalar before =
        Foam::pow(residuals[last - 10]/residuals[last - 20], 0.1);
    Info<< "    IQNILS contracts by " << before << ", then " << late << endl;
    c.checkBelow("spectrum: IQNILS is superlinear", late, 0.8*before);
}


void Foam::fsbi::checkNonlinear(checks& c)
{
    Info<< "Mildly nonlinear partner, r from 0.01 to 30, 60 unknowns" << endl;
    const scalarList lambda(partner::spread(60, 0.01, 30));
    for
    (
        const std::string method :
        {
            "semiImplicit; omega 0.06;", "Aitken;", "IQNILS;",
            "IQNILS; reuse 2;", "IQNILS; reuse 2; filter 1e-3;"
        }
    )
    {
        const passes found(threeSteps(c, method, lambda, 0.5));
        c.check
        (
            "nonlinear: " + method + " converges",
            found[0] > 0 && found[1] > 0 && found[2] > 0
        );
    }
}


// Whole columns with a condition number of about 1e8, powers of a coordinate
static List<scalarField> powers(const partner& p, const label count)
{
    List<scalarField> columns(count);
    forAll(columns, j)
    {
        scalarField f(p.size());
        forAll(f, i)
        {
            f[i] = Foam::pow(scalar(i + 1)/f.size(), j);
        }
        columns[j] = p.part(f);
    }
    return columns;
}


void Foam::fsbi::checkLeastSquares(checks& c)
{
    const partner p(partner::spread(60, 1, 2));
    const interfaceProduct product(p.weights());
    const List<scalarField> columns(powers(p, 12));
    List<const scalarField*> V(columns.size());
    forAll(V, j)
    {
        V[j] = &columns[j];
    }
    const scalarField b(p.part(p.solution(3)));
    const interfaceLeastSquares fit(product, V, b, 1e-14);
    scalarField rest(b);
    forAll(V, j)
    {
        rest -= fit.coefficients()[j]*columns[j];
    }
    const scalarList left(product.products(columns, rest));
    scalar worst = 0;
    for (const scalar part : left)
    {
        worst = max(worst, mag(part)/sqr(product.norm(b)));
    }
    c.check("least squares: no column of full rank is lost", fit.rank() == 12);
    c.checkBelow("least squares: the rest is orthogonal", worst, 1e-9);
    c.checkClose
    (
        "shared entries count once", sqr(product.norm(columns[0])), 60, 1e-14
    );
}


static void checkFilter(checks& c)
{
    const partner p(partner::spread(60, 1, 2));
    const interfaceProduct product(p.weights());
    const List<scalarField> independent(powers(p, 2));
    const scalarField& u = independent[0];
    const scalarField& v = independent[1];
    const scalarField sum(2*u - v);
    const scalarField none(u.size(), Zero);
    const scalarField endless(u.size(), VGREAT);
    const interfaceLeastSquares fit
    (
        product, List<const scalarField*>({&none, &u, &v, &u, &sum, &endless}),
        3*u - v, 1e-10
    );
    const scalarField expected(scalarList({0, 3, -1, 0, 0, 0}));
    c.check("least squares: dependent columns are left out", fit.rank() == 2);
    c.checkBelow
    (
        "least squares: coefficients of the first columns",
        max(mag(scalarField(fit.coefficients()) - expected)), 1e-12
    );
}


void Foam::fsbi::checkDependent(checks& c)
{
    checkFilter(c);

    // two directions and the rest of the space: four columns at most
    scalarList lambda(60, Zero);
    lambda[7] = 300;
    lambda[30] = 5;
    const partner p(lambda);
    autoPtr<couplingLoop> loop
    (
        makeLoop("method IQNILS; reuse 3; tolerance 1e-9;", p)
    );
    scalarField x(p.weights().size(), Zero);
    label most = 0;
    bool finite = true;
    for (label step = 0; step < 4; ++step)
    {
        scalarField again(x.size(), scalar(step));
        const stepRun run(loop(), p, again);
        most = max(most, run.report.iterations);
        finite = finite && run.report.converged && p.error(again, 0) < 1e-8;
    }
    c.check("dependent columns: the solution", finite);
    c.checkBelow("dependent columns: passes, two stiff directions", most, 5);
}


void Foam::fsbi::checkSamePass(checks& c)
{
    const partner q(partner::spread(60, 1, 10));
    const dictionary dict{IStringStream("method IQNILS;")()};
    autoPtr<accelerator> method(accelerator::New(checkedDictionary(dict)));
    method->start(q.weights());
    method->beginStep();
    scalarField first(q.weights().size(), Zero);
    const scalarField H(q.H(first));
    for (label pass = 0; pass < 3; ++pass)
    {
        first = 0;
        method->next(first, H);
    }
    c.checkBelow
    (
        "a pass made twice is relaxed, not divided by zero",
        gMax(mag(first - 0.1*H)), 1e-12
    );
    c.check
    (
        "a pass made twice is left out",
        refCast<const IQNILS>(method()).filtered() == 2
    );
}
