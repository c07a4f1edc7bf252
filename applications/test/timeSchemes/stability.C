/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parts.H"
#include "oscillator.H"
#include "Random.H"
#include "mathematicalConstants.H"
#include "scalarMatrices.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static const label startSteps = 8;


// Amplification matrix of a step dt = 1, after steps that grew by a ratio: cell
// j starts with the unit vector j of all that the history holds
static scalarSquareMatrix amplification
(
    const std::string& entry, const oscillator& o, const scalar ratio = 1
)
{
    autoPtr<motionScheme> s(makeScheme(entry));
    label n = 0;
    const vectorField one(1, vector::one);
    s->start(one, one, one);
    for (label i = 0; i < startSteps; ++i)
    {
        o.step(s(), Foam::pow(ratio, i - startSteps));
    }
    s->fields([&](const word&, vectorField&){ ++n; });
    label slot = 0;
    s->fields
    (
        [&](const word&, vectorField& f)
        {
            f = vectorField(n, Zero);
            f[slot++] = vector::one;
        }
    );
    o.step(s(), 1);

    scalarSquareMatrix A(n, Zero);
    slot = 0;
    s->fields
    (
        [&](const word&, vectorField& f)
        {
            forAll(f, j)
            {
                A(slot, j) = f[j].x();
            }
            ++slot;
        }
    );
    return A;
}


// From the norm of A^(2^30): defective eigenvalues do not matter
static scalar spectralRadius(scalarSquareMatrix A)
{
    scalar logarithm = 0;
    scalar power = 1;
    for (label squaring = 0; squaring <= 30; ++squaring)
    {
        scalar norm = 0;
        for (const scalar a : A)
        {
            norm = max(norm, mag(a));
        }
        logarithm += Foam::log(max(norm, VSMALL))/power;
        forAll(A, i)
        {
            A.data()[i] /= max(norm, VSMALL);
        }
        A = scalarSquareMatrix(A*A);
        power *= 2;
    }
    return Foam::exp(logarithm);
}


static scalar radius
(
    const std::string& entry, const scalar x, const scalar damping = 0
)
{
    return spectralRadius(amplification(entry, {x, damping}));
}


// Largest spectral radius over omega dt
static scalar largestRadius
(
    const std::string& entry, const scalar damping,
    const scalar from = 1e-3, const scalar to = 1e3
)
{
    scalar largest = 0;
    const label n = 240;
    for (label i = 0; i <= n; ++i)
    {
        const scalar x = from*Foam::pow(to/from, scalar(i)/n);
        largest = max(largest, radius(entry, x, damping));
    }
    return largest;
}


static void checkAStable(checks& c)
{
    for
    (
        const std::string entry :
        {
            "Fornberg 1", "Fornberg 2", "Newmark", "Newmark 0.3025 0.6",
            "generalisedAlpha", "generalisedAlpha 0", "generalisedAlpha 0.5",
            "generalisedAlpha 1"
        }
    )
    {
        scalar excess = 0;
        for (const scalar damping : {0.0, 0.01, 0.1, 0.7, 1.0, 10.0, 1000.0})
        {
            excess = max(excess, largestRadius(entry, damping) - 1);
        }
        c.checkBelow(entry + ": A-stable, damped or not", excess, 1e-6);
        c.check
        (
            entry + ": no warning", makeScheme(entry)->warning(1, 1e3).empty()
        );
    }
    c.checkClose("Newmark: no damping", radius("Newmark", 3), 1, 1e-6);
    c.checkClose
    (
        "Fornberg 1: damping", radius("Fornberg 1", 1), Foam::sqrt(0.5), 1e-6
    );
    for (const scalar r : {0.0, 0.5, 0.8, 1.0})
    {
        const std::string entry("generalisedAlpha " + Foam::name(r));
        // defective at infinity: approached slowly
        c.checkBelow
        (
            entry + ": radius at infinity", mag(radius(entry, 1e5) - r), 1e-3
        );
    }
}


static void checkGrowth
(
    checks& c, const std::string& entry, const scalar largest,
    const scalar at, const scalar stableAbove, const scalar damping
)
{
    autoPtr<motionScheme> s(makeScheme(entry));
    const scalar limit = s->stepLimit();
    c.checkClose
    (
        entry + ": 1 % growth in a period at the limit",
        Foam::pow(radius(entry, limit), 2*pi/limit), 1.01, 3e-4
    );
    c.check
    (
        entry + ": warns above the limit only",
        s->warning(1, 0.99*limit).empty() && !s->warning(1, 1.01*limit).empty()
    );
    c.checkClose
    (
        entry + ": largest growth", largestRadius(entry, 0), largest, 1e-3
    );
    c.checkClose(entry + ": where", radius(entry, at), largest, 1e-3);
    c.check
    (
        entry + ": stable above",
        largestRadius(entry, 0, stableAbove, 1e3) < 1
     && radius(entry, 0.99*stableAbove) > 1
    );
    c.checkBelow
    (
        entry + ": stable with damping", largestRadius(entry, damping) - 1, 0
    );
    c.check
    (
        entry + ": unstable with less", largestRadius(entry, 0.9*damping) > 1
    );
}


static void checkConditional(checks& c)
{
    checkGrowth(c, "Fornberg 3", 1.0258, 0.82, 1.291, 0.054);
    checkGrowth(c, "Fornberg 4", 1.1206, 1.36, 2.814, 0.30);

    const std::string central("Newmark 0.0833333333333333 0.5");
    const scalar limit = makeScheme(central)->stepLimit();
    c.checkClose(central + ": limit", limit, Foam::sqrt(6.0), 1e-9);
    c.checkBelow
    (
        central + ": stable below", radius(central, 0.99*limit), 1 + 1e-6
    );
    c.check(central + ": unstable above", radius(central, 1.01*limit) > 1.01);
}


// Steps that go on growing: growth of differences beyond that of u = t
static void checkGrowingSteps(checks& c)
{
    const oscillator free(0, 0);
    const auto excess = [&](const std::string& entry, const scalar ratio)
    {
        return spectralRadius(amplification(entry, free, ratio)) - ratio;
    };
    const std::vector<std::pair<std::string, scalar>> limits
    ({
        {"Fornberg 2", 1.73}, {"Fornberg 3", 1.38}, {"Fornberg 4", 1.18}
    });
    for (const auto& limit : limits)
    {
        const std::string& entry = limit.first;
        c.checkBelow
        (
            entry + ": steps may grow by " + Foam::name(limit.second),
            excess(entry, limit.second), 1e-6
        );
        c.check
        (
            entry + ": and not by more", excess(entry, 1.02*limit.second) > 1e-3
        );
    }
    c.checkBelow("Fornberg 1: steps may grow", excess("Fornberg 1", 3), 1e-6);
}


void Foam::fsbi::checkStability(checks& c)
{
    checkAStable(c);
    checkConditional(c);
    checkGrowingSteps(c);
}


struct energies
{
    scalar smallest = GREAT;
    scalar largest = 0;
    scalar last = 0;
};


// Energy over the initial one in many steps of random size
static energies energyOf
(
    const std::string& entry, const scalar x, const scalar variation
)
{
    const oscillator o(1, 0);
    autoPtr<motionScheme> s(makeScheme(entry));
    o.start(s());
    const scalar initial = sum(magSqr(oscillator::amplitudes()));
    Random random(3);
    energies e;
    for (label i = 0; i < 2000; ++i)
    {
        const vectorField u
        (
            o.step(s(), x*random.position<scalar>(1 - variation, 1 + variation))
        );
        e.last = (sum(magSqr(u)) + sum(magSqr(s->velocity(u))))/initial;
        e.smallest = min(e.smallest, e.last);
        e.largest = max(e.largest, e.last);
    }
    return e;
}


void Foam::fsbi::checkEnergy(checks& c)
{
    for (const scalar x : {0.01, 0.3, 1.0, 10.0, 300.0})
    {
        for (const scalar r : {0.0, 0.5})
        {
            const std::string at
            (
                ", omega dt " + Foam::name(x) + (r > 0 ? ", random steps" : "")
            );
            const energies e(energyOf("Newmark", x, r));
            c.checkBelow
            (
                "Newmark: conserves energy" + at, e.largest - e.smallest, 1e-10
            );
            for (const std::string entry : {"Fornberg 1", "Fornberg 2"})
            {
                const scalar largest = energyOf(entry, x, r).largest;
                c.checkBelow(entry + ": energy falls" + at, largest, 1);
            }
            // velocity overshoots where omega dt >> 1
            const energies a(energyOf("generalisedAlpha 0.8", x, r));
            const energies b(energyOf("generalisedAlpha 0", x, r));
            c.check
            (
                "generalisedAlpha: energy is bounded" + at,
                a.largest < 1 + sqr(x/45) && b.largest < 1 + sqr(x/4)
             && (x < 1 || a.last < 0.2) && (x < 0.3 || b.last < 1e-4)
            );
        }
    }
}
