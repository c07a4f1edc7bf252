/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"

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
    const vectorField ways({vector(3, -1, 0.5), vector(-2, 4, 0)});
    const vectorField times(law.times(ways));
    scalar error = 0;
    forAll(ways, i)
    {
        vector made(Zero);
        forAll(times, k)
        {
            made += law.speed(i, k)*times[k];
        }
        error = max(error, mag(made - ways[i]));
    }
    c.checkBelow("times of the modes make the ways", error, 1e-12);

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


static const std::string magnet
(
    "{ type permanent; direction (0 0 1); moment 1e-13; }"
);
static const std::string pairs
(
    "x { arrangement Helmholtz; centre (0 0 0); axis (1 0 0); radius 5e4;"
    " turns 100; } y { arrangement Helmholtz; centre (0 0 0); axis (0 1 0);"
    " radius 5e4; turns 100; } z { arrangement Helmholtz; centre (0 0 0);"
    " axis (0 0 1); radius 5e4; turns 100; }"
);
static const std::string steered
(
    "first { target (9 -0.2 7); advance 1; stepOut 3e-6; }"
    " second { target (3.1 -6 0); advance 1; stepOut 9e-6; }"
);

//- A magnetics dictionary with a controller, some of it replaced
static std::string scene
(
    const std::string& from = "", const std::string& to = ""
)
{
    std::string text
    (
        "bodies { first " + magnet + " second " + magnet + " }"
        " controller { drive rolling; normal (0 0 1); magnitude 1e-3;"
        " frequencies (2e-6 6e-6); period 2.5e5; tolerance 0.5;"
        " place (0 0 0); maxCurrent 1; coils { " + pairs + " }"
        " bodies { " + steered + " } }"
    );
    const size_t at = text.find(from);
    return from.empty() ? text : text.replace(at, from.size(), to);
}


//- Go on to an instant, and what the field is a moment later
static vector fieldAfter
(
    magneticScene& bodies, magnetics& magnets, const scalar t
)
{
    bodies.setClock(t, 1);
    magnets.endStep();
    bodies.setClock(t + 3e4, 1);
    return magnets.states()[0].B;
}


static void checkHold(checks& c)
{
    magneticScene bodies;
    bodies.setClock(0, 1);
    auto magnets(bodies.make(scene()));
    c.checkClose
    (
        "the first instant is a period after the start",
        magnets->nextInstant(), 2.5e5, 1e-12
    );
    bodies.setClock(1e5, 1);
    const vector before(magnets->states()[0].B);
    c.checkClose("the field has the magnitude", mag(before), 1e-3, 1e-6);
    bodies[0].at.centre += vector(0, 5, 0);
    magnets->endStep();
    c.checkBelow
    (
        "it does not see a body that moves between instants",
        mag(magnets->states()[0].B - before)/mag(before), 1e-6
    );
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary saved;
    magnets->save(saved);
    IOstream::defaultPrecision(precision);
    auto again(bodies.make(scene()));
    const vector other(again->states()[0].B);
    again->restore(saved);
    c.check
    (
        "one that begins now orders otherwise, a restored one the same",
        mag(other - before) > 1e-6
     && again->states()[0].B == magnets->states()[0].B
     && again->nextInstant() == magnets->nextInstant()
    );
    const vector then(fieldAfter(bodies, magnets(), 2.5e5));
    const vector thenAgain(fieldAfter(bodies, again(), 2.5e5));
    c.check("and goes on so at the next instant", then == thenAgain);
    c.checkClose
    (
        "the next instant is a period later", magnets->nextInstant(), 5e5, 1e-12
    );
    bodies[0].at.centre = point(9.2, -0.3, 0.5);
    bodies[1].at.centre = point(3, -6.2, -1.7);
    c.check
    (
        "there is no field when all are at their targets",
        mag(fieldAfter(bodies, magnets(), 5e5)) == 0
    );
    bodies[1].at.centre += vector(2, 0, 0);
    c.check
    (
        "and there is when one has left",
        mag(fieldAfter(bodies, magnets(), 7.5e5)) > 0.9e-3
    );
}


//- The last row of the controller's table
class lastRow
:
    public recording
{
public:

    scalarList row;

    void declare(const fileName&, const wordList&, const string&) override
    {}

    void append(const fileName& path, const UList<scalar>& values) override
    {
        if (path == "magnetics/controller")
        {
            row = values;
        }
    }

    static lastRow of(const magnetics& magnets)
    {
        lastRow result;
        magnets.record(result);
        return result;
    }

    // After three currents, mode and heading
    scalar leg() const { return row[7]; }
    scalar distance(const label body) const { return row[8 + body]; }
};


//- Go on to an instant with the bodies at these places
static lastRow measuredAt
(
    magneticScene& bodies, magnetics& magnets, const scalar t,
    const point& first, const point& second
)
{
    bodies[0].at.centre = first;
    bodies[1].at.centre = second;
    fieldAfter(bodies, magnets, t);
    return lastRow::of(magnets);
}


static void checkWayPoints(checks& c)
{
    magneticScene bodies;
    bodies.setClock(0, 1);
    const auto make = [&]
    {
        return bodies.make(scene("target (9", "via ((4 -0.2 7)); target (9"));
    };
    auto magnets(make());
    c.checkClose
    (
        "a body heads for its way point first",
        lastRow::of(magnets()).distance(0), 3.7, 1e-12
    );
    const point via(4.1, -0.2, 0), far(8.1, 1, 0), target(3.1, -6, 0);
    lastRow now(measuredAt(bodies, magnets(), 2.5e5, via, far));
    c.check
    (
        "and waits there for the others",
        now.leg() == 1 && mag(now.distance(0) - 0.1) < 1e-12
    );
    now = measuredAt(bodies, magnets(), 5e5, via, target);
    c.check
    (
        "then all go on, who has no more points stays",
        now.leg() == 2 && mag(now.distance(0) - 4.9) < 1e-12
     && now.distance(1) < 1e-12
    );
    c.check
    (
        "the field is on again", mag(magnets->states()[0].B) > 0.9e-3
    );
    dictionary saved;
    magnets->save(saved);
    auto again(make());
    again->restore(saved);
    now = measuredAt(bodies, again(), 7.5e5, via - vector(2, 0, 0), far);
    c.check("a restored one does not go back", now.leg() == 2);
    measuredAt(bodies, again(), 1e6, point(9, -0.2, 0), target);
    c.check
    (
        "at the targets there is no field", mag(again->states()[0].B) == 0
    );
}


//- Bodies that go as the law says, without a fluid: from start to arrival
struct journey
{
    scalar time = 0;

    //- Least distances of the first body from the origin and from the other
    scalar fromOrigin = GREAT;
    scalar apart = GREAT;

    //- Move to the controller's next instant
    void go(magneticScene& bodies, magnetics& magnets)
    {
        const scalar instant = magnets.nextInstant(), dt = instant - time;
        bodies.setClock(time = instant, 1);
        const scalarList row(lastRow::of(magnets).row);
        const label mode = label(row[3]);
        const vector heading(row[4], row[5], row[6]);
        const scalarList stepOuts({3.4e-6, 10.3e-6});
        const label pieces = 50;
        for (label n = 0; mode > 0 && n < pieces; ++n)
        {
            for (label i = 0; i < 2; ++i)
            {
                bodies[i].at.centre +=
                    1.25*dt/pieces*heading
                   *steeringLaw::rate(frequencies[mode - 1], stepOuts[i]);
            }
            const point& x = bodies[0].at.centre;
            fromOrigin = min(fromOrigin, mag(x));
            apart = min(apart, mag(x - bodies[1].at.centre));
        }
        magnets.endStep();
    }

    static bool arrived(magneticScene& bodies)
    {
        return
            mag(bodies[0].at.centre - point(15, 0, 0)) < 0.5
         && mag(bodies[1].at.centre - point(38, 32, 0)) < 0.5;
    }

    //- Until both are at their targets; at most a minute
    static journey of(magneticScene& bodies, const std::string& via)
    {
        bodies.setClock(0, 1);
        bodies[0].at.centre = point(-15, 0, 0);
        bodies[1].at.centre = point(18, -21, 0);
        auto magnets
        (
            bodies.make
            (
                scene
                (
                    steered,
                    "first { " + via + " target (15 0 0); advance 1.25;"
                    " stepOut 3.4e-6; } second { target (38 32 0);"
                    " advance 1.25; stepOut 10.3e-6; }"
                )
            )
        );
        journey result;
        do
        {
            result.go(bodies, magnets());
        }
        while (!arrived(bodies) && result.time < 6e7);
        return result;
    }
};


static void checkObstacle(checks& c)
{
    magneticScene bodies;
    const scalar diameter = 10;
    const journey straight(journey::of(bodies, ""));
    c.check
    (
        "without a way point a sphere would meet the obstacle",
        straight.fromOrigin < diameter
    );
    const journey led(journey::of(bodies, "via ((9 18 0));"));
    c.check("with one it does not", led.fromOrigin > 1.2*diameter);
    c.check("nor the sphere whose path it crosses", led.apart > 1.2*diameter);
    c.check("both arrive", journey::arrived(bodies));
    // by the same law in another program; arrival is seen at the period's end
    c.checkClose
    (
        "in the time that was planned",
        2.5e5*std::ceil(led.time/2.5e5 - 1e-6), 2.9e7, 1e-9
    );
}


//- A body that is on its own goes straight: axis of the field, right-handed
static vector axisOf(const std::string& drive)
{
    std::string text(scene("drive rolling; normal (0 0 1);", drive));
    const std::string second("second { target");
    const size_t at = text.find(second);
    text.erase(at, text.find("}", at) + 1 - at);
    magneticScene bodies;
    bodies.setClock(0, 1);
    const auto magnets(bodies.make(text));
    bodies.setClock(1e4, 1);
    const vector B(magnets->states()[0].B);
    bodies.setClock(2e4, 1);
    const vector turn(B ^ magnets->states()[0].B);
    return turn/mag(turn);
}


static void checkAxes(checks& c)
{
    // from (0.3 -0.2 0.5) to (9 -0.2 7)
    const vector way(vector(8.7, 0, 6.5)/mag(vector(8.7, 0, 6.5)));
    c.checkBelow
    (
        "the field of a body that rolls on turns about normal x heading",
        mag(axisOf("drive rolling; normal (0 0 1);") - vector(0, 1, 0)), 1e-6
    );
    c.checkBelow
    (
        "under a wall the other way",
        mag(axisOf("drive rolling; normal (0 0 -1);") - vector(0, -1, 0)), 1e-6
    );
    c.checkBelow
    (
        "that of a swimmer about its way",
        mag(axisOf("drive swimming;") - way), 1e-6
    );
}


static void checkRefusals(checks& c)
{
    const auto refuses = [&]
    (
        const std::string& what, const std::string& from, const std::string& to,
        const std::string& message
    )
    {
        magneticScene bodies;
        c.checkFatal
        (
            "refuses " + what, [&]{ bodies.make(scene(from, to)); }, message
        );
    };
    refuses
    (
        "an unknown body", "first { target", "third { target",
        "no body 'third'"
    );
    refuses
    (
        "a body without a magnet", "first " + magnet, "",
        "bodies that it turns are 1(second)"
    );
    refuses
    (
        "one that no field turns", "type permanent; direction (0 0 1);",
        "type saturated;", "preferred axis"
    );
    refuses
    (
        "a zero moment", "moment 1e-13", "moment 0",
        "'moment' must be above zero"
    );
    refuses
    (
        "a way point that is no list", "target (9", "via (1 2 3); target (9",
        "Expected a '('"
    );
    refuses("no target", "target (9 -0.2 7);", "", "'target' not found");
    refuses("a target of two numbers", "(9 -0.2 7)", "(9 -0.2)", "expected scalar");
    refuses("a zero advance", "advance 1", "advance 0", "'advance' is zero");
    refuses
    (
        "fewer frequencies than bodies", "(2e-6 6e-6)", "(2e-6)",
        "1 frequencies"
    );
    refuses
    (
        "a negative frequency", "(2e-6 6e-6)", "(2e-6 -6e-6)",
        "above zero"
    );
    refuses
    (
        "bodies that answer alike", "(2e-6 6e-6)", "(1e-6 2e-6)",
        "second: 1e-06 2e-06"
    );
    refuses
    (
        "currents above the limit", "maxCurrent 1", "maxCurrent 0.5",
        "0.556064 A in coil 'x'"
    );
    refuses
    (
        "coils in a plane", "axis (0 0 1)", "axis (1 1 0)",
        "every direction"
    );
    refuses
    (
        "a coil with a current", "turns 100;", "turns 100; current 1;",
        "without a current"
    );
    refuses("an unknown keyword", "period", "periods 1; period", "'periods'");
    refuses("another drive", "drive rolling", "drive flying", "swimming");
}


void checkSteering(checks& c)
{
    checkLaw(c);
    checkCoils(c);
    checkHold(c);
    checkWayPoints(c);
    checkObstacle(c);
    checkAxes(c);
    checkRefusals(c);
}

} // End namespace fsbi
} // End namespace Foam
