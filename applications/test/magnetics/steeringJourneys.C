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


void checkJourneys(checks& c)
{
    checkWayPoints(c);
    checkObstacle(c);
}

} // End namespace fsbi
} // End namespace Foam
