/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "annealing.H"
#include "elasticSymbol.H"
#include "fourierChecks.H"
#include "IStringStream.H"
#include "laplaceSymbol.H"
#include "mathematicalConstants.H"
#include "scheduledJacobi.H"
#include "SORSymbol.H"

namespace Foam
{
namespace fsbi
{

static const scalar pi = constant::mathematical::pi;

// Values of a script of its own (NumPy, sampled waves): nu 0.3, phi >= pi/64
static void checkPair(checks& test, const eigenvalueRange& range)
{
    const scalarList one = bestFactors(1, range);
    test.checkClose("best single factor", one[0], 0.999671431, 1e-8);
    const scalar rho1 = spectralRadius(one, range);
    test.checkClose("its radius", rho1, 0.999342862, 1e-8);
    scalarList two = bestFactors(2, range);
    sort(two);
    test.checkClose("best pair, lower", two[0], 0.585753406, 1e-8);
    test.checkClose("best pair, upper", two[1], 3.40768557, 1e-8);
    const scalar rho2 = spectralRadius(two, range);
    test.checkClose("radius of the pair", rho2, 0.997375761, 1e-8);
    test.checkClose
    (
        "gain per step 99.9 %", speedUp(rho2, rho1)/2, 1.99868702, 1e-8
    );
    scalar worst = 0;
    for (const label m : {1, 2, 3, 4, 5, 8, 16})
    {
        const scalar radius = spectralRadius(bestFactors(m, range), range);
        worst = max(worst, mag(radius/bestRadius(m, range) - 1));
    }
    test.checkBelow("1/T_m((b + a)/(b - a)) for up to 16 steps", worst, 1e-12);
}


static void checkAnnealing(checks& test, const eigenvalueRange& range)
{
    const auto found = [&](const label m, const scalar highest)
    {
        return annealed
        (
            scalarList(m, 1.0),
            [&](const scalarList& w) { return log(spectralRadius(w, range)); },
            scalarMinMax(0.1, highest)
        );
    };
    for (const label m : {2, 3})
    {
        const scalar radius = spectralRadius(found(m, 50), range);
        test.checkClose
        (
            "annealing finds the best " + std::to_string(m) + " factors",
            log(radius), log(bestRadius(m, range)), 1e-3
        );
    }
    // factors up to 2.95 only: what limits is |p(2)|, so the lower factor is
    // (1 + rho/(2 2.95 - 1))/2 with rho near one
    scalarList capped = found(2, 2.95);
    sort(capped);
    const scalar rho = spectralRadius(capped, range);
    test.checkClose("capped pair, upper", capped[1], 2.95, 1e-6);
    test.checkClose("capped pair, lower", capped[0], (1 + rho/4.9)/2, 1e-4);
    test.checkClose
    (
        "its gain, 78 %", speedUp(rho, bestRadius(1, range))/2, 1.78, 0.005
    );
}


static void checkSORPair(checks& test)
{
    const auto cost = [](const scalarList& w)
    {
        return log(SORSymbol::spectralRadius(w, pi/64))/w.size();
    };
    const scalarList one = annealed(scalarList(1, 1.0), cost, {0.1, 1.99});
    test.checkBelow
    (
        "annealed SOR is no worse than a thousand others",
        cost(one) - [&]
        {
            scalar lowest = GREAT;
            for (label i = 1; i < 1000; ++i)
            {
                lowest = min(lowest, cost(scalarList(1, 0.1 + 1.89*i/1000)));
            }
            return lowest;
        }(),
        1e-9
    );
}


static void checkEntries(checks& test)
{
    const auto factors = [](const string& entries)
    {
        IStringStream is(entries);
        return scheduledJacobi::factors(dictionary(is));
    };
    test.check
    (
        "factors as given",
        factors("factors (0.6 3.1);") == scalarList({0.6, 3.1})
    );
    const scalarList best = factors("factors auto; steps 3; phiMin 0.4;");
    const scalar radius = spectralRadius
    (
        best, laplaceSymbol(vector::one).range(0.4, true)
    );
    test.checkClose
    (
        "factors auto", radius,
        bestRadius(3, laplaceSymbol(vector::one).range(0.4, true)), 1e-12
    );
    test.checkFatal("no steps are refused", [&] { factors("steps 0;"); }, "steps");
    test.checkFatal("no factors are refused", [&] { factors("factors ();"); }, "factors");
    test.checkFatal("an unknown entry is refused", [&] { factors("step 3;"); }, "step");
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::checkSchedules(checks& test)
{
    const eigenvalueRange range =
        elasticSymbol(1, 0.3, vector::one).range(pi/64, false);
    checkPair(test, range);
    checkAnnealing(test, range);
    checkSORPair(test);
    checkEntries(test);
}
