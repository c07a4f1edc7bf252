/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourierChecks.H"
#include "laplaceSymbol.H"
#include "mathematicalConstants.H"
#include "SORSymbol.H"

namespace Foam
{
namespace fsbi
{

static const scalar pi = constant::mathematical::pi;

static const scalar waveMin = pi/64;

// One sweep over a line of n cells in a ring, on the wave exp(i theta x):
// what the wave is multiplied by far from the first cell
static scalar sweptWave(const scalar theta, const scalar omega)
{
    const label n = 4000;
    std::complex<scalar> before = 0;    // the new value of the cell before
    for (label x = 0; x < n; ++x)
    {
        const auto wave = [&](label i) { return std::polar(1.0, theta*i); };
        before =
            omega*(wave(x + 1) + before)/2.0 + (1 - omega)*wave(x);
    }
    return std::abs(before);
}


static void checkJacobi(checks& test)
{
    const laplaceSymbol line(vector(1, 0, 0));
    const eigenvalueRange all = line.range(waveMin, false);
    const scalarList plain(1, 1.0), half(1, 0.5), over(1, 1.05);
    scalar worst = 0;
    for (label k = 1; k <= 64; ++k)
    {
        const vector phi(k*waveMin, 0, 0);
        for (const scalar w : {0.3, 1.0, 1.4})
        {
            worst = max
            (
                worst,
                mag
                (
                    line.spectralRadius(scalarList(1, w), phi)
                  - mag(w*cos(phi.x()) - w + 1)
                )
            );
        }
    }
    test.checkBelow("relaxed Jacobi, |w cos(theta) - w + 1|", worst, 1e-12);
    test.checkClose("Jacobi does not converge", spectralRadius(plain, all), 1, 1e-12);
    test.checkClose
    (
        "Jacobi, half relaxed", spectralRadius(half, all),
        (1 + cos(waveMin))/2, 1e-12
    );
    test.checkClose
    (
        "over-relaxed Jacobi diverges, |1 - 2 w|",
        spectralRadius(over, all), 1.1, 1e-12
    );
    test.checkClose
    (
        "three directions, a wave along one",
        laplaceSymbol(vector(1, 2, 4)).range(waveMin, true).lowest,
        (1 - cos(waveMin))/16/(1 + 0.25 + 1/16.0), 1e-12
    );
}


static void checkSOR(checks& test)
{
    scalar gauss = 0, relaxed = 0, swept = 0;
    for (label k = 1; k <= 64; ++k)
    {
        const scalar t = k*waveMin;
        gauss = max
        (
            gauss, mag(std::abs(SORSymbol::step(t, 1)) - 1/sqrt(5 - 4*cos(t)))
        );
        const scalar w = 1.6;
        const scalar printed =      // Gaskin 2018, 3.62
            sqrt
            (
                pow4(w)*sqr(sin(2*t) - 2*sin(t))
              + sqr(sqr(w)*(cos(2*t) - 2*cos(t)) + 4*(w - 1))
            )/mag(-4*w*cos(t) + w*w + 4);
        const scalar ours = std::abs(SORSymbol::step(t, w));
        relaxed = max(relaxed, mag(ours - printed));
        swept = max(swept, mag(ours - sweptWave(t, w)));
    }
    test.checkBelow("Gauss-Seidel, 1/sqrt(5 - 4 cos(theta))", gauss, 1e-12);
    test.checkBelow("SOR as in equation 3.62", relaxed, 1e-12);
    test.checkBelow("SOR as a sweep over a line does it", swept, 1e-12);
    test.checkClose
    (
        "largest over all waves, Gauss-Seidel",
        SORSymbol::spectralRadius(scalarList(1, 1.0), waveMin),
        1/sqrt(5 - 4*cos(waveMin)), 1e-12
    );
}


// The maximum of a product lies inside the range: against fine sampling
static void checkInside(checks& test)
{
    const scalarList factors({0.9, 2.9});
    scalar sampled = 0;
    const label n = 2000000;
    for (label i = 0; i <= n; ++i)
    {
        const scalar t = waveMin + (pi - waveMin)*i/n;
        sampled = max
        (
            sampled,
            std::abs(SORSymbol::step(t, 0.9)*SORSymbol::step(t, 2.9))
        );
    }
    const scalar largest = SORSymbol::spectralRadius(factors, waveMin);
    test.checkClose("two steps of SOR, against two million waves", largest, sampled, 1e-12);
    const scalar end = std::abs
    (
        SORSymbol::step(waveMin, 0.9)*SORSymbol::step(waveMin, 2.9)
    );
    const scalar other = std::abs
    (
        SORSymbol::step(pi, 0.9)*SORSymbol::step(pi, 2.9)
    );
    test.check("their maximum is inside", largest > 1.0001*max(end, other));
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::checkLaplace(checks& test)
{
    checkJacobi(test);
    checkSOR(test);
    checkInside(test);
}
