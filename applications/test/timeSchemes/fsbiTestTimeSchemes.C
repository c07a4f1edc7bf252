/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestTimeSchemes

Description
    Checks of the time schemes of solids: Fornberg's weights against tables and
    polynomials, orders, stability, energy, rewind and restart to the last bit,
    and bad entries.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "oscillator.H"
#include "parts.H"
#include "Fornberg.H"
#include "Random.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static const std::vector<std::string> inertial
({
    "Fornberg 1", "Fornberg 2", "Fornberg 3", "Fornberg 4", "Newmark",
    "Newmark 0.3025 0.6", "generalisedAlpha", "generalisedAlpha 0",
    "generalisedAlpha 0.5", "generalisedAlpha 1"
});


static scalar largestDifference(const scalarList& a, const scalarList& b)
{
    scalar largest = a.size() == b.size() ? 0 : GREAT;
    for (label i = 0; i < min(a.size(), b.size()); ++i)
    {
        largest = max(largest, mag(a[i] - b[i]));
    }
    return largest;
}


static void checkTables(checks& c)
{
    const auto backward = [](const label n, const label derivative)
    {
        scalarList nodes(n);
        forAll(nodes, i)
        {
            nodes[i] = 7 - i;
        }
        return Fornberg::fornbergWeights(7, nodes, derivative);
    };
    const auto table = [&]
    (
        const std::string& name, const scalarList& w, const scalarList& known
    )
    {
        c.checkBelow("weights: " + name, largestDifference(w, known), 1e-13);
    };
    table("BDF2", backward(3, 1), {1.5, -2, 0.5});
    table("BDF3", backward(4, 1), {11./6, -3, 1.5, -1./3});
    table("u'', order 1", backward(3, 2), {1, -2, 1});
    table("u'', order 2 (Houbolt)", backward(4, 2), {2, -5, 4, -1});
    table
    (
        "u'', order 3", backward(5, 2),
        {35./12, -26./3, 9.5, -14./3, 11./12}
    );
    table
    (
        "u'', order 4", backward(6, 2),
        {3.75, -77./6, 107./6, -13, 61./12, -5./6}
    );
    table
    (
        "central u'', order 4",
        Fornberg::fornbergWeights(0, {-2, -1, 0, 1, 2}, 2),
        {-1./12, 4./3, -2.5, 4./3, -1./12}
    );
    table
    (
        "interpolation", Fornberg::fornbergWeights(0.5, {0, 1, 2}, 0),
        {0.375, 0.75, -0.125}
    );
    // u0 + dt v0 + dt^2 a/2 = u with a constant
    table
    (
        "Hermite u''", Fornberg::HermiteWeights(3, {3, 1, 1}, {0, 0, 1}, 2),
        {0.5, -0.5, -1}
    );
}


// Derivative of x^power
static scalar monomial
(
    const scalar x, const label power, const label derivative
)
{
    scalar factor = 1;
    for (label i = 0; i < derivative; ++i)
    {
        factor *= power - i;
    }
    return factor == 0 ? 0 : factor*Foam::pow(x, power - derivative);
}


static void checkExactness(checks& c)
{
    Random random(5);
    scalar plain = 0;
    scalar Hermite = 0;
    for (label n = 3; n <= 6; ++n)
    {
        for (label trial = 0; trial < 50; ++trial)
        {
            scalarList nodes(n, scalar(2));
            for (label i = 1; i < n; ++i)
            {
                nodes[i] = nodes[i - 1] - random.position<scalar>(0.4, 1.2);
            }
            scalarList twice(nodes);
            twice[n - 1] = twice[n - 2];
            labelList given(n, Zero);
            given[n - 1] = 1;
            for (label k = 0; k < n; ++k)
            {
                for (label derivative = 0; derivative < 3; ++derivative)
                {
                    const scalar exact = monomial(2, k, derivative);
                    const scalarList w
                    (
                        Fornberg::fornbergWeights(2, nodes, derivative)
                    );
                    const scalarList h
                    (
                        Fornberg::HermiteWeights(2, twice, given, derivative)
                    );
                    scalar a = 0;
                    scalar b = 0;
                    forAll(nodes, i)
                    {
                        a += w[i]*monomial(nodes[i], k, 0);
                        b += h[i]*monomial(twice[i], k, given[i]);
                    }
                    plain = max(plain, mag(a - exact));
                    Hermite = max(Hermite, mag(b - exact));
                }
            }
        }
    }
    c.checkBelow("weights: exact for polynomials", plain, 1e-10);
    c.checkBelow("weights: Hermite exact for polynomials", Hermite, 1e-10);
}


// Largest errors of displacement and velocity in n steps, their sizes varying
// smoothly by the factor 1 +- variation
static std::pair<scalar, scalar> errors
(
    const std::string& entry, const oscillator& o, const label n,
    const scalar variation
)
{
    autoPtr<motionScheme> s(makeScheme(entry));
    o.start(s());
    const vectorField amplitudes(oscillator::amplitudes());
    const scalar end = 3;
    scalar t = 0;
    std::pair<scalar, scalar> largest(0, 0);
    for (label i = 1; i <= n; ++i)
    {
        const scalar x = scalar(i)/n;
        const scalar next = end*(x + variation*Foam::sin(2*pi*x)/(2*pi));
        const vectorField u(o.step(s(), next - t, next));
        t = next;
        const scalar eu = max(mag(u - o.u(t)*amplitudes));
        const scalar ev = max(mag(s->velocity(u) - o.v(t)*amplitudes));
        largest.first = max(largest.first, eu);
        largest.second = max(largest.second, ev);
    }
    return largest;
}


static void checkOrder
(
    checks& c, const std::string& entry, const std::string& name,
    const oscillator& o, const scalar variation, const scalar order
)
{
    const auto coarse = errors(entry, o, 400, variation);
    const auto fine = errors(entry, o, 800, variation);
    const scalar u = std::log2(coarse.first/fine.first);
    const scalar v = std::log2(coarse.second/fine.second);
    char line[120];
    snprintf
    (
        line, sizeof(line), "    %-20s %-28s error %.1e, order %.2f, velocity "
        "%.1e, %.2f", entry.c_str(), name.c_str(), fine.first, u, fine.second, v
    );
    Info<< line << endl;
    c.check
    (
        entry + ": order, " + name, u > order - 0.15 && v > order - 0.15,
        "observed " + Foam::name(u) + ", of velocity " + Foam::name(v)
    );
}


static void checkOrders(checks& c)
{
    for (const std::string& entry : inertial)
    {
        const scalar order =
            entry.substr(0, 8) == "Fornberg" ? std::stod(entry.substr(9))
          : entry == "Newmark 0.3025 0.6" ? 1 : 2;
        const scalar abrupt = min(order, 3);
        for (const scalar r : {0.0, 0.5})
        {
            const std::string steps(r > 0 ? ", varying steps" : "");
            checkOrder(c, entry, "free" + steps, {2, 0}, r, abrupt);
            checkOrder(c, entry, "damped" + steps, {2, 0.2}, r, abrupt);
            checkOrder(c, entry, "forced" + steps, {2, 0.1, 3}, r, abrupt);
            checkOrder(c, entry, "from rest" + steps, {2, 0.1, 3, 0}, r, order);
        }
    }
}


static bool same(motionScheme& a, motionScheme& b)
{
    std::map<word, vectorField> kept;
    a.fields([&](const word& n, vectorField& f){ kept.emplace(n, f); });
    label visited = 0;
    bool equal = true;
    b.fields
    (
        [&](const word& n, vectorField& f)
        {
            ++visited;
            equal = equal && kept.count(n) && kept.at(n) == f;
        }
    );
    return equal && visited == label(kept.size()) && visited > 0;
}


static void checkRewind(checks& c, const std::string& entry)
{
    const oscillator o(2, 0.1, 3);
    autoPtr<motionScheme> a(makeScheme(entry));
    autoPtr<motionScheme> b(makeScheme(entry));
    o.start(a());
    o.start(b());
    scalar t = 0;
    bool equal = true;
    for (label i = 0; i < 12; ++i)
    {
        const scalar dt = 0.1 + 0.02*(i % 3);
        t += dt;
        const vectorField u(o.step(a(), dt, t));
        vectorField R;
        b->beginStep(2*dt);
        o.solve(b(), t + dt, R);
        b->rewind();
        equal = equal && u == o.step(b(), dt, t) && same(a(), b());
    }
    c.check(entry + ": rewound is as never tried", equal);
}


// Save to text, restore into a new scheme
static autoPtr<motionScheme> restarted
(
    const std::string& entry, motionScheme& old
)
{
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    old.save(state);
    OStringStream text;
    text<< state;
    IOstream::defaultPrecision(precision);
    autoPtr<motionScheme> s(makeScheme(entry));
    const dictionary copy{IStringStream(text.str())()};
    s->restore(copy);
    std::map<word, vectorField> kept;
    old.fields([&](const word& n, vectorField& f){ kept.emplace(n, f); });
    s->fields([&](const word& n, vectorField& f){ f = kept.at(n); });
    return s;
}


static void checkRestart(checks& c, const std::string& entry)
{
    const oscillator o(2, 0.1, 3);
    bool equal = true;
    for (label kill = 0; kill < 9; ++kill)
    {
        autoPtr<motionScheme> a(makeScheme(entry));
        autoPtr<motionScheme> b;
        o.start(a());
        scalar t = 0;
        for (label i = 0; i < 16; ++i)
        {
            if (i == kill)
            {
                b = restarted(entry, a());
            }
            const scalar dt = 0.1 + 0.02*(i % 3);
            t += dt;
            const vectorField u(o.step(a(), dt, t));
            equal = equal
             && (i < kill || (u == o.step(b(), dt, t) && same(a(), b())));
        }
    }
    c.check(entry + ": restarted is as never stopped", equal);
}


static void checkSteady(checks& c)
{
    autoPtr<motionScheme> s(makeScheme("steadyState"));
    const vectorField u(oscillator::amplitudes());
    s->start(u, u, u);
    autoPtr<motionScheme> r(restarted("steadyState", s()));
    r->beginStep(0.1);
    c.check
    (
        "steadyState: no acceleration, no velocity",
        r->accelerationCoeff() == 0 && r->velocityCoeff() == 0
     && r->knownAcceleration() == vectorField(3, Zero)
     && r->knownVelocity() == vectorField(3, Zero)
    );
    r->endStep(2*u, u);
    s->start(2*u, u, u);
    c.check("steadyState: keeps the displacement", same(r(), s()));
}


int main()
{
    checks c;
    checkTables(c);
    checkExactness(c);
    checkOrders(c);
    for (const std::string& entry : inertial)
    {
        checkRewind(c, entry);
        checkRestart(c, entry);
    }
    checkSteady(c);
    checkWords(c);
    checkStability(c);
    checkEnergy(c);
    return c.finish();
}
