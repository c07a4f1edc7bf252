/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestRigidBodies

Description
    Checks of the time integration of rigid bodies without a flow: a drag
    proportional to the velocity takes its place. Steps of changing length
    against exact motions: slowing down, tumbling free of torque, turning at a
    constant rate; angular momentum; rejected steps; saved states.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "rigidBody.H"
#include "IStringStream.H"

using namespace Foam;
using namespace Foam::fsbi;

static const vector spin(0.1, 1, 0.05);


static dictionary entries(const std::string& more)
{
    return dictionary
    (
        IStringStream
        (
            "type rigidBody; density 2; position (5 -3 2); "
            "shape { type ellipsoid; semiAxes (3 2 1); size 0.8; } " + more
        )()
    );
}


// One step up to the given time, not yet accepted: force and torque are those of
// the velocities times minus the drag
static void attempt
(
    rigidBody& body, const scalar time, const scalar dt, const scalar drag = 0
)
{
    body.beginStep();
    body.advance(dt);
    const bodyRows rows(body.rows(time));
    sixVector v(rows.velocity);
    const vector V(linear(rows.rhs)/(rows.massRate + drag));
    const vector omega
    (
        inv(rows.inertiaRate + drag*tensor::I) & angular(rows.rhs)
    );
    const sixVector solved(join(V, omega));
    forAll(v, k)
    {
        v[k] = rows.free[k] ? solved[k] : v[k];
    }
    body.set(v, join(-drag*linear(v), -drag*angular(v)));
}


// A run of so many steps, every third of them longer than the others
static void run
(
    rigidBody& body, const scalar duration, const label steps,
    const scalar drag = 0
)
{
    scalar time = 0;
    for (label i = 0; i < steps; ++i)
    {
        const scalar dt = (i % 3 ? 0.75 : 1.5)*duration/steps;
        time += dt;
        attempt(body, time, dt, drag);
        body.endStep();
    }
}


static scalar angleBetween(const quaternion& a, const quaternion& b)
{
    return mag(angleOf(a*conjugate(b)));
}


static void checkOrder(checks& c, const std::string& name, const scalar* error)
{
    const scalar order = Foam::log(error[0]/error[1])/Foam::log(2.0);
    Info<< "    " << name.c_str() << ": errors " << error[0] << ", " << error[1]
        << ", order " << order << endl;
    c.check("order of " + name, order > 1.8, Foam::name(order));
    c.checkBelow(name, error[1], 0.01);
}


// m V' = -k V: V = V0 exp(-k t/m), and the way there
static void checkSlowing(checks& c)
{
    scalar ofV[2], ofX[2];
    for (label level = 0; level < 2; ++level)
    {
        rigidBody body("body", entries("velocity (1 2 -1);"));
        const vector V0(1, 2, -1);
        const scalar drag = body.mass();
        run(body, 1.5, 60*(1 << level), drag);
        const scalar left = Foam::exp(-1.5);
        ofV[level] = mag(linear(body.now().velocity) - left*V0)/mag(V0);
        ofX[level] =
            mag(body.now().centre - body.start() - (1 - left)*V0)/mag(V0);
    }
    checkOrder(c, "velocity of a body that slows down", ofV);
    checkOrder(c, "way of a body that slows down", ofX);
}


// Euler's equations in the body's axes by Runge and Kutta, steps so short that
// their error does not count
static quaternion tumbled(const tensor& inertia, const scalar duration)
{
    const label steps = 20000;
    const scalar dt = duration/steps;
    const tensor inverse(inv(inertia));
    struct motion { quaternion q; vector w; };
    const auto rate = [&](const motion& m)
    {
        return motion
        {
            0.5*(m.q*quaternion(scalar(0), m.w)),
            inverse & ((inertia & m.w) ^ m.w)
        };
    };
    const auto moved = [](const motion& m, const scalar h, const motion& r)
    {
        return motion{m.q + h*r.q, m.w + h*r.w};
    };
    motion m{quaternion::I, spin};
    for (label i = 0; i < steps; ++i)
    {
        const motion a(rate(m));
        const motion b(rate(moved(m, 0.5*dt, a)));
        const motion d(rate(moved(m, 0.5*dt, b)));
        const motion e(rate(moved(m, dt, d)));
        for (const auto* k : {&a, &b, &b, &d, &d, &e})
        {
            m = moved(m, dt/6, *k);
        }
    }
    return m.q/mag(m.q);
}


static void checkTumbling(checks& c)
{
    const scalar duration = 6;
    scalar error[2], momentum[2];
    for (label level = 0; level < 2; ++level)
    {
        rigidBody body
        (
            "body", entries("angularVelocity (0.1 1 0.05);")
        );
        const vector start(body.inertia() & spin);
        run(body, duration, 300*(1 << level));
        error[level] = angleBetween
        (
            body.now().orientation, tumbled(body.inertia(), duration)
        );
        const tensor R(body.now().orientation.R());
        const vector end
        (
            R & body.inertia() & R.T() & angular(body.now().velocity)
        );
        momentum[level] = mag(end - start)/mag(start);
    }
    checkOrder(c, "turn of a body that tumbles", error);
    c.checkBelow("its angular momentum stays", momentum[1], 1e-12);
}


// A step's rotation is exact at a constant rate, however long
static void checkTurning(checks& c)
{
    rigidBody body
    (
        "body",
        entries
        (
            "angularVelocity (0.3 -0.2 0.6);"
            "constraints { angularVelocity constant (0.3 -0.2 0.6); }"
        )
    );
    run(body, 30, 30);
    const vector rate(0.3, -0.2, 0.6);
    const scalar off = angleBetween
    (
        body.now().orientation, quaternion(rate/mag(rate), 30*mag(rate))
    );
    c.checkBelow("a constant rate turns exactly", off, 1e-12);
}


static scalar difference(const rigidBody& a, const rigidBody& b)
{
    scalar sum =
        mag(a.now().centre - b.now().centre)
      + mag(a.now().orientation.w() - b.now().orientation.w())
      + mag(a.now().orientation.v() - b.now().orientation.v());
    forAll(a.now().velocity, k)
    {
        sum += mag(a.now().velocity[k] - b.now().velocity[k]);
    }
    return sum;
}


static const std::string moving
(
    "velocity (1 2 -1); angularVelocity (0.1 1 0.05);"
    " torque constant (3 -20 7);"
);


static void checkRejected(checks& c)
{
    rigidBody plain("body", entries(moving)), tried("body", entries(moving));
    scalar time = 0;
    for (label i = 0; i < 20; ++i)
    {
        const scalar dt = i % 2 ? 0.1 : 0.2;
        attempt(tried, time + 2*dt, 2*dt, 5);
        tried.rewind();
        time += dt;
        for (rigidBody* body : {&plain, &tried})
        {
            attempt(*body, time, dt, 5);
            body->endStep();
        }
    }
    c.checkBelow("rejected steps leave no trace", difference(plain, tried), 0);
}


static void checkSaved(checks& c)
{
    rigidBody whole("body", entries(moving));
    run(whole, 3, 30, 5);
    const unsigned precision = IOstream::defaultPrecision(17);
    dictionary state;
    whole.save(state);
    IOstream::defaultPrecision(precision);
    rigidBody again("body", entries(moving), state);
    run(whole, 3, 30, 5);
    run(again, 3, 30, 5);
    c.checkBelow("a saved body goes on as before", difference(whole, again), 0);
}


int main()
{
    checks c;
    checkSlowing(c);
    checkTumbling(c);
    checkTurning(c);
    checkRejected(c);
    checkSaved(c);
    return c.finish();
}
