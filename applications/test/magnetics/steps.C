/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "OStringStream.H"

namespace Foam
{
namespace fsbi
{

static const std::string magnet
(
    "bodies { first { type permanent; direction (1 0 0); moment 1e-12; } }"
);

//- What a checkpoint holds
static dictionary saved(const magnetics& magnets)
{
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    magnets.save(state);
    OStringStream os;
    state.write(os, false);
    IOstream::defaultPrecision(precision);
    return dictOf(os.str());
}


//- As the coupled system turns a body of some resistance: with the torque at
//  the end of the step by the stiffness
static void turn
(
    magneticScene& scene, const magnetics& magnets, const scalar dt
)
{
    const tensor resistance(1, 0, 0, 0, 0.1, 0, 0, 0, 7);
    const loads l(scene.at(magnets));
    tensor A(resistance/dt);
    for (direction j = 0; j < 3; ++j)
    {
        vector unit(Zero);
        unit[j] = 1;
        const vector f(angular(magneticScene::decrease(l, join(Zero, unit))));
        for (direction i = 0; i < 3; ++i)
        {
            A(i, j) += f[i];
        }
    }
    scene[0].at.orientation =
        turnedBy(inv(A) & angular(l.whole(0)))*scene[0].at.orientation;
}


static void checkFall(checks& c)
{
    // m B = 1; steps of a thousandth to a million times the time to align
    Random random(11);
    bool falls = true;
    scalar slowest = 0;
    for (label n = 0; n < 300; ++n)
    {
        magneticScene scene;
        scene[0].at.orientation = turnedBy(pi*randomDirection(random));
        const auto magnets(scene.make
        (
            "fields { up { type uniform; B (0 0 1e-3); } }" + magnet
        ));
        const auto energy = [&]{ return -magnets->states()[0].m.z()*1e12; };
        const scalar dt = pow(10, 9*random.sample01<scalar>() - 3);
        for (label step = 0; step < 60; ++step)
        {
            const scalar before = energy();
            turn(scene, magnets(), dt);
            falls = falls && energy() <= before + 1e-14;
        }
        slowest = dt > 100 ? max(slowest, 1 + energy()) : slowest;
    }
    c.check("the energy falls in steps of any length, from any angle", falls);
    c.checkBelow("long steps end aligned", slowest, 1e-10);
}


static void checkLength(checks& c)
{
    magneticScene scene;
    string reason;
    const auto longest = [&](const std::string& field, const scalar dt)
    {
        scene.setClock(0, dt);
        const auto magnets(scene.make("fields { " + field + "}" + magnet));
        return magnets->longestStep(reason);
    };
    const std::string turning
    (
        "turning { type rotating; magnitude 5e-3; axis (0 0 1);"
        " start (1 0 0); frequency 1e-5; }"
    );
    // chords of a fortieth of a turn; found by halving
    for (const scalar dt : {100.0, 2000.0, 3000.0, 1e5, 2e5})
    {
        const scalar found = longest(turning, dt);
        c.check
        (
            "steps of a turning field, from " + std::to_string(dt),
            dt == 100 ? found == GREAT : found <= 2510 && found > 1250,
            std::to_string(found)
        );
    }
    c.check
    (
        "a steady field asks for no step",
        longest("up { type uniform; B (0 0 1); }", 1e9) == GREAT
    );

    // an alternating field does not stop the clock where it vanishes
    scene.setClock(0, 1000);
    autoPtr<magnetics> magnets(scene.make
    (
        "fields { ac { type coil; centre (0 0 0); axis (0 0 1); radius 1e4;"
        " current { type sine; frequency 1e-5; amplitude 1; scale 1; level 0; }"
        " } }" + magnet
    ));
    scalar t = 0, shortest = GREAT;
    label steps = 0;
    for (; t < 2e5 && steps < 1000; ++steps)
    {
        const scalar dt = min(magnets->longestStep(reason), 1e4);
        shortest = steps > 40 ? min(shortest, dt) : shortest;
        t += dt;
        scene.setClock(t, dt);
        magnets->endStep();
    }
    c.check
    (
        "steps of an alternating field",
        t >= 2e5 && shortest > 1000, std::to_string(shortest)
    );
}


static void checkLag(checks& c)
{
    magneticScene scene;
    scene.setClock(0, 1);
    const std::string text
    (
        "units SI; fields { turning { type rotating; magnitude 1;"
        " axis (0 1 0); start (0 0 1); frequency 0.01; } }" + magnet
    );
    autoPtr<magnetics> magnets(scene.make(text));
    // the body follows at a third of the speed, a quarter of a turn behind at
    // the start: field along z, moment along x turns about y
    const auto step = [&](const label n)
    {
        scene.setClock(n, 1);
        scene[0].at.orientation =
            turnedBy(vector(0, -0.5*pi + 0.02*pi*n/3 - 0.25*pi, 0));
        magnets->endStep();
    };
    const auto lagNow = [&]
    {
        return saved(magnets()).subDict("first").subDict("lag")
            .get<scalar>("angle");
    };
    for (label n = 1; n <= 250; ++n)
    {
        step(n);
    }
    // x turned by -pi/2 about y is z
    const scalar expected = 0.02*pi*250*2/3 + 0.25*pi;
    c.checkClose("lag behind a turning field", lagNow(), expected, 1e-12);

    autoPtr<magnetics> again(scene.make(text));
    again->restore(saved(magnets()));
    step(251);
    const scalar whole = lagNow();
    magnets = std::move(again);
    step(251);
    c.check("lag after a restart: the same", lagNow() == whole);

    phaseLag lag(vector(1, 0, 0));
    c.check("no slip before the field turns", lag.slips() == 0);
    for (label n = 1; n <= 500; ++n)
    {
        const scalar a = 0.02*pi*n;
        lag.update(vector(cos(a), sin(a), 0), vector(1, 0, 0.3));
    }
    c.check("five turns of the field about a body that rests",
        lag.slips() == 5, std::to_string(lag.slips()));
}


void checkSteps(checks& c)
{
    checkFall(c);
    checkLength(c);
    checkLag(c);
}

} // End namespace fsbi
} // End namespace Foam
