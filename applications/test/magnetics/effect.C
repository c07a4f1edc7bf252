/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magneticChecks.H"
#include "dipole.H"
#include "IFstream.H"
#include "OSspecific.H"

#include <functional>

namespace Foam
{
namespace fsbi
{

static const std::string fields
(
    "fields { steady { type uniform; B (2e-3 1e-3 -1e-3); }"
    " coil { type coil; centre (0 0 -6); axis (1 1 2); radius 5;"
    " turns 100; current 40; } }"
);
static const std::string kinds[] =
{
    "type permanent; direction (1 2 -1); magnetisation 1e5;",
    "type saturated; magnetisation 1e5;",
    "type soft; susceptibility 3; semiAxes (1 2 4);"
};

//- Energy of the first body, in SI units, for its kind
static scalar energy(const magnetics& magnets, const label kind)
{
    const auto s(magnets.states()[0]);
    return kind == 2 ? -0.5*(s.m & s.B) : -(s.m & s.B);
}


//- Derivative with the displacement, or the rotation vector, of a body
static vector derivative
(
    octahedron& body, const bool turn, const std::function<scalar()>& value
)
{
    const placement at(body.at);
    const scalar h = 1e-4;
    vector d(Zero);
    for (direction i = 0; i < 3; ++i)
    {
        for (const scalar sign : {1.0, -1.0})
        {
            vector step(Zero);
            step[i] = sign*h;
            if (turn)
            {
                body.at.orientation = turnedBy(step)*at.orientation;
            }
            else
            {
                body.at.centre = at.centre + step;
            }
            d[i] += sign*value()/(2*h);
            body.at = at;
        }
    }
    return d;
}


static void checkEnergies(checks& c)
{
    const std::string names[] = {"permanent", "saturated", "soft"};
    for (label kind = 0; kind < 3; ++kind)
    {
        magneticScene scene;
        scene[0].at.orientation = quaternion(vector(2, -1, 2)/3, 1.1);
        const auto magnets(scene.make
        (
            fields + " bodies { first {" + kinds[kind] + "} }"
        ));
        const sixVector load(scene.at(magnets()).whole(0));
        const auto E = [&]{ return 1e15*energy(magnets(), kind); };
        const vector F(-derivative(scene[0], false, E));
        const vector T(-derivative(scene[0], true, E));
        c.checkBelow
        (
            names[kind] + ": the force is the energy's slope",
            mag(linear(load) - F)/mag(F), 1e-6
        );
        c.checkBelow
        (
            names[kind] + ": so is the torque",
            mag(angular(load) - T)/mag(E()), 1e-7
        );
        c.check
        (
            names[kind] + ": no torque only if it has no axis of its own",
            (mag(angular(load)) < 1e-12*mag(E())) == (kind == 1)
        );
    }
    // a field of 1 mT, 1e-12 A m^2: 1e-15 J
    magneticScene scene;
    const auto magnets(scene.make
    (
        "fields { up { type uniform; B (0 0 1e-3); } pull { type gradient;"
        " centre (0.3 -0.2 0.5); axis (1 0 0); axial 2; } }"
        " bodies { first { type permanent; direction (1 0 0); moment 1e-12; } }"
    ));
    const sixVector load(scene.at(magnets()).whole(0));
    c.checkBelow
    (
        "units: 1e-15 N m is one of the case's",
        mag(angular(load) - vector(0, -1, 0)), 1e-14
    );
    c.checkBelow
    (
        "units: 1e-9 N is one of the case's",
        mag(linear(load) - vector(2e-3, 0, 0)), 1e-16
    );
}


static void checkStiffness(checks& c)
{
    Random random(3);
    for (label kind = 0; kind < 3; ++kind)
    {
        scalar turning = GREAT, moving = GREAT;
        for (label n = 0; n < 100; ++n)
        {
            magneticScene scene;
            scene[0].at.orientation = turnedBy(pi*randomDirection(random));
            scene[0].at.centre = 3*randomDirection(random);
            const auto magnets(scene.make
            (
                fields + " bodies { first {" + kinds[kind] + "} }"
            ));
            const loads l(scene.at(magnets()));
            const vector e(randomDirection(random));
            // decrease along e: true, by differences, and taken
            const auto torque = [&]
            {
                return angular(scene.at(magnets()).whole(0)) & e;
            };
            const auto force = [&]
            {
                return linear(scene.at(magnets()).whole(0)) & e;
            };
            const scalar T = -(derivative(scene[0], true, torque) & e);
            const scalar F = -(derivative(scene[0], false, force) & e);
            const scalar scale = mag(energy(magnets(), kind))*1e15;
            turning = min
            (
                turning,
                (
                    (angular(magneticScene::decrease(l, join(Zero, e))) & e)
                  - T
                )/scale
            );
            moving = min
            (
                moving,
                (
                    (linear(magneticScene::decrease(l, join(e, Zero))) & e)
                  - F
                )/scale
            );
        }
        const std::string name("kind " + std::to_string(kind));
        c.check
        (
            name + ": stiffness against rotation is never too small",
            turning > -1e-6, std::to_string(turning)
        );
        c.check
        (
            name + ": stiffness against displacement is never too small",
            moving > -1e-6, std::to_string(moving)
        );
    }
    // aligned it is exact across the moment, m B; about it, half of that
    magneticScene scene;
    const auto magnets(scene.make
    (
        "fields { up { type uniform; B (0 0 1e-3); } } bodies { first"
        " { type permanent; direction (0 0 1); moment 1e-12; } }"
    ));
    const loads l(scene.at(magnets()));
    const sixVector K
    (
        magneticScene::decrease(l, sixVector({0, 0, 0, 1, 2, 3}))
    );
    c.checkBelow
    (
        "stiffness of an aligned magnet",
        mag(angular(K) - vector(1, 2, 1.5)) + mag(linear(K)), 1e-14
    );
    c.check("a load that is zero but stiff is one", !l.empty());
}


static void checkPair(checks& c)
{
    Random random(5);
    const std::string text
    (
        "units SI; fields {} interaction {} bodies {"
        " first { type permanent; direction (1 0 0); moment 1; }"
        " second { type permanent; direction (0 1 0); moment 2; } }"
    );
    scalar slope = 0, angularSum = 0, bound = GREAT;
    for (label n = 0; n < 50; ++n)
    {
        magneticScene scene;
        for (label b = 0; b < 2; ++b)
        {
            scene[b].at.orientation = turnedBy(pi*randomDirection(random));
        }
        const auto magnets(scene.make(text));
        const loads l(scene.at(magnets()));
        const auto s(magnets->states());
        const auto E = [&]
        {
            const auto now(magnets->states());
            return -(now[0].m & dipoleB(now[1].m, now[0].x - now[1].x));
        };
        const loads::spring& spring = l.springs()[0];
        const vector F(-derivative(scene[0], false, E));
        slope = max(slope, mag(spring.force - F)/mag(F));
        const vector sum
        (
            angular(l.whole(0)) + angular(l.whole(1))
          + ((s[0].x - s[1].x) ^ spring.force)
        );
        angularSum = max(angularSum, mag(sum)/mag(angular(l.whole(0))));
        const vector e(randomDirection(random));
        const auto force = [&]
        {
            return scene.at(magnets()).springs()[0].force & e;
        };
        const scalar k = -(derivative(scene[0], false, force) & e);
        bound = min(bound, (e & spring.stiffness & e)/mag(k));
    }
    c.checkBelow("two magnets: the force is the energy's slope", slope, 1e-6);
    c.checkBelow("two magnets: angular momentum", angularSum, 1e-13);
    c.check("two magnets: the stiffness is a bound", bound >= 1 - 1e-6,
        std::to_string(bound));

    // in line, the bound is the stiffness: 24 mu0 m1 m2/(4 pi r^5)
    magneticScene line;
    line[0].at.centre = Zero;
    line[1].at.centre = point(2, 0, 0);
    line[1].at.orientation = turnedBy(vector(0, 0, -0.5*pi));
    const auto magnets(line.make(text));
    const auto pull = [&]
    {
        return line.at(magnets()).springs()[0].force.x();
    };
    c.checkClose
    (
        "two magnets in line attract: 6 mu0 m1 m2/(4 pi r^4)",
        pull(), 6e-7*2/16, 1e-12
    );
    c.checkClose
    (
        "two magnets in line: the stiffness is exact",
        mag(derivative(line[0], false, pull).x()),
        line.at(magnets()).springs()[0].stiffness.xx(), 1e-6
    );
}


//- Two magnets, the second one a way off, where its image is taken to be
static void checkImages(checks& c)
{
    const vector period(20, 0, 0);
    const std::string bodies
    (
        " interaction {} bodies {"
        " first { type permanent; direction (1 0 0); moment 1e-12; }"
        " second { type soft; susceptibility 3; semiAxes (1 2 4); } }"
    );
    const std::string fields("fields { up { type uniform; B (0 0 1e-3); } }");
    magneticScene plain;
    const auto magnets(plain.make(fields + bodies));
    const sixVector turning(plain.at(magnets()).whole(0));
    const vector pull(plain.at(magnets()).springs()[0].force);
    const auto difference = [&](const label travelled, const label image)
    {
        magneticScene scene;
        scene.addImages({period, -period});
        scene[1].at.centre += travelled*period;
        scene[1].setImage(image*period);
        const auto there(scene.make(fields + bodies));
        const loads l(scene.at(there()));
        return max
        (
            mag(l.springs()[0].force - pull)/mag(pull),
            mag(angular(l.whole(0)) - angular(turning))/mag(angular(turning))
        );
    };
    // bound: round-off of coordinates of 100 over a distance of 4
    c.checkBelow("two magnets: an image acts as the body", difference(1, 0), 1e-11);
    c.checkBelow("one that has gone far, by its image", difference(5, -4), 1e-11);
    c.check("bodies cross the sides of a periodic scene", magnets->periodic());
    c.check
    (
        "but not in a field that differs from place to place",
        !plain.make
        (
            "fields { pull { type gradient; centre (0 0 0); axis (1 0 0);"
            " axial 2; } }" + bodies
        )->periodic()
    );
}


static void checkInduction(checks& c)
{
    // two soft spheres in a field along their line: m = p (B + 2 k m/r^3)
    magneticScene scene;
    scene[0].at.centre = Zero;
    scene[1].at.centre = point(0, 0, 2.5);
    const std::string sphere
    (
        "{ type soft; susceptibility 50; semiAxes (1 1 1); }"
    );
    const auto magnets(scene.make
    (
        "units SI; fields { up { type uniform; B (0 0 0.01); } }"
        " interaction {} bodies { first " + sphere + " second " + sphere + "}"
    ));
    const auto s(magnets->states());
    const scalar p = 4.0/3*50*3/(53*mu0SI);
    const scalar m = p*0.01/(1 - 2e-7*p/pow3(2.5));
    c.checkClose("soft spheres magnetise each other", s[0].m.z(), m, 1e-12);
    c.checkClose("so does the other", s[1].m.z(), m, 1e-12);
    c.checkClose
    (
        "and attract each other",
        scene.at(magnets()).springs()[0].force.z(), 6e-7*m*m/pow4(2.5), 1e-11
    );
}


static void checkWrongEffects(checks& c)
{
    magneticScene scene;
    const auto wrong = [&]
    (
        const std::string& name, const std::string& text,
        const std::string& message
    )
    {
        c.checkFatal(name, [&]{ scene.make(text); }, message);
    };
    const std::string body("bodies { first { type saturated; moment 1; } }");
    wrong("no fields", body, "fields");
    wrong("no bodies", "fields {}", "bodies");
    wrong("unknown body", "fields {} bodies { third { type saturated; moment"
        " 1; } }", "(first second)");
    wrong("unknown keyword of magnetics", "fields {} steps 3;" + body,
        "'steps'");
    wrong("unknown units", "units cgs; fields {}" + body, "microvascular");
    wrong("entries in interaction", "fields {} interaction { on yes; }" + body,
        "'on'");
    wrong("interaction that is no dictionary", "fields {} interaction yes;"
        + body, "must be a sub-dictionary");
    wrong("no steps per turn", "fields {} stepsPerTurn 0;" + body,
        "'stepsPerTurn' must be above zero");
}


// What etc/dictionaries shows is valid
static void checkManual(checks& c)
{
    IFstream file(fileName(getEnv("FSBI_DIR"))/"etc"/"dictionaries"/"effects");
    const dictionary all(file);
    const dictionary& dict = all.subDict("magnetics");
    const magneticFields fields
    (
        dict.subDict("fields"), unitsOf("microvascular")
    );
    label bodies = 0;
    for (const entry& e : dict.subDict("bodies"))
    {
        bodies += magnetisation::New(e.dict()).valid();
    }
    c.check
    (
        "the annotated dictionary is valid and shows all types",
        fields.size() == 5 && bodies == 3
    );
}


void checkEffect(checks& c)
{
    checkManual(c);
    checkEnergies(c);
    checkStiffness(c);
    checkPair(c);
    checkImages(c);
    checkInduction(c);
    checkWrongEffects(c);
}

} // End namespace fsbi
} // End namespace Foam
