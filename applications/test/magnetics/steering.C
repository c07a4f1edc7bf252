/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "steeringScene.H"

namespace Foam
{
namespace fsbi
{

static const scalarList frequencies({2e-6, 6e-6, 18e-6});
static const scalarList advances({1.2, -0.7});
static const scalarList stepOuts({3e-6, 10e-6});

//- Mean turns per time of a body by its phase: da/dt = 2 pi (f - s sin(a)),
//  over a time in which the field overtakes it many times
static scalar followed(const scalar f, const scalar s)
{
    const scalar dt = 1e-3/f;
    scalar turned = 0, lag = 0, overtaken = 0;
    label n = 0;
    for (; overtaken < 50; ++n)
    {
        const scalar middle = lag + pi*dt*(f - s*Foam::sin(lag));
        const scalar step = s*Foam::sin(middle)*dt;
        turned += step;
        lag += 2*pi*(f*dt - step);
        overtaken = lag/(2*pi);
    }
    return turned/(n*dt);
}


static void checkLaw(checks& c)
{
    c.checkBelow
    (
        "a body beyond stepping out turns at f - sqrt(f2 - s2)",
        mag(steeringLaw::rate(6e-6, 3e-6)/followed(6e-6, 3e-6) - 1), 2e-3
    );
    c.check
    (
        "below it turns with the field",
        steeringLaw::rate(2e-6, 3e-6) == 2e-6
    );
    const steeringLaw law(frequencies, advances, stepOuts);
    const vectorField displacements({vector(3, -1, 0.5), vector(-2, 4, 0)});
    const vectorField times(law.times(displacements, identity(2)));
    scalar error = 0;
    forAll(displacements, i)
    {
        vector made(Zero);
        forAll(times, k)
        {
            made += law.speed(i, k)*times[k];
        }
        error = max(error, mag(made - displacements[i]));
    }
    c.checkBelow("times of the modes make the displacements", error, 1e-12);

    // of one that is alone, by the law of its own
    const vectorField alone
    (
        law.times(displacements, labelList({1}))
      - steeringLaw
        (
            frequencies, scalarList({advances[1]}), scalarList({stepOuts[1]})
        ).times(vectorField({displacements[1]}), identity(1))
    );
    c.check("a body that is absent counts in nothing", max(mag(alone)) == 0);

    // what makes no way: the kernel of the speeds, two bodies by three modes
    vector a, b;
    for (direction k = 0; k < 3; ++k)
    {
        a[k] = law.speed(0, k);
        b[k] = law.speed(1, k);
    }
    const vector idle(a ^ b);
    scalar along = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const vector t(times[0][d], times[1][d], times[2][d]);
        along = max(along, mag(t & idle)/(mag(t)*mag(idle) + VSMALL));
    }
    c.checkBelow("and none that makes no way", along, 1e-12);
    c.check
    (
        "bodies that step out apart are told apart", law.distinction() > 0.1
    );
    c.checkBelow
    (
        "bodies that all follow are not",
        steeringLaw
        (
            scalarList({2e-6, 2.5e-6}), scalarList({1, 2}), stepOuts
        ).distinction(),
        1e-7
    );
}


static const std::string coilEntries
(
    "x { axis (1 0 0); centre (-9 0 0); radius 10; turns 100; }"
    " y { arrangement Helmholtz; axis (1 3 0); centre (0 0 0); radius 12; }"
    " z { arrangement Helmholtz; axis (0 0 1); centre (0 0 1); radius 9;"
    " turns 20; } w { axis (1 1 1); centre (0 1 4); radius 5; turns 50; }"
);

static void checkCoils(checks& c)
{
    const point place(0.3, -0.2, 0.5);
    const coilSet coils(dictOf(coilEntries), place, unitsOf("microvascular"));
    const vector B(1e-3, -2e-3, 0.5e-3);
    const scalarField currents(coils.currents(B));
    c.checkBelow
    (
        "currents make the field that is wanted",
        mag(coils.B(place, currents) - B)/mag(B), 1e-12
    );
    scalar exceeded = 0;
    Random random(7);
    for (label n = 0; n < 100; ++n)
    {
        const scalarField I(coils.currents(randomDirection(random)));
        forAll(I, i)
        {
            exceeded = max(exceeded, mag(I[i])/coils.mostPerField(i));
        }
    }
    c.check
    (
        "no direction takes more than the largest current",
        exceeded <= 1 && exceeded > 0.9
    );
    tensor slope(Zero);
    const scalar h = 1e-3;
    for (direction d = 0; d < 3; ++d)
    {
        vector step(Zero);
        step[d] = h;
        const vector change
        (
            coils.B(place + step, currents) - coils.B(place - step, currents)
        );
        for (direction j = 0; j < 3; ++j)
        {
            slope(d, j) = change[j]/(2*h);
        }
    }
    const tensor G(coils.gradient(place, currents));
    c.checkBelow("their gradient is the slope", mag(G - slope)/mag(G), 1e-6);
}


void checkSteering(checks& c)
{
    checkLaw(c);
    checkCoils(c);
    checkOrders(c);
    checkJourneys(c);
}

} // End namespace fsbi
} // End namespace Foam
