/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "steeringScene.H"

namespace Foam
{
namespace fsbi
{

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


void checkOrders(checks& c)
{
    checkHold(c);
    checkAxes(c);
    checkRefusals(c);
}

} // End namespace fsbi
} // End namespace Foam
