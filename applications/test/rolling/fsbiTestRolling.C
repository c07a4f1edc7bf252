/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestRolling

Description
    Checks of the rolling leukocyte: the way of its material against the exact
    times and places, velocities tangential to the shape and equal to the
    points' motion, no flux through the surface, state saved and restored.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "rollingLeukocyte.H"
#include "IStringStream.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

static const scalar r = 4, Ax = 1, Ay = 0.1, By = 0.4;

static dictionary entries(const std::string& motion, const scalar size)
{
    return dictionary
    (
        IStringStream
        (
            "type rollingLeukocyte; shape { type leukocyte; radius 4; Ax 1;"
            " Ay 0.1; By 0.4; size " + name(size) + "; } position (3 2.6 -1); "
          + motion
        )()
    );
}


static rollingLeukocyte leukocyte
(
    const std::string& motion,
    const scalar size = 1
)
{
    return rollingLeukocyte("cell", entries(motion, size), 0);
}


// One accepted step
static void step(prescribedBody& body, const scalar time, const scalar dt)
{
    body.beginStep();
    body.advance(time, dt);
    body.endStep();
}


// The map's inverse by bisection, independent of the class
static point onSphere(const point& q)
{
    scalar low = -2*r, high = 2*r;
    for (label i = 0; i < 200; ++i)
    {
        const scalar x = 0.5*(low + high);
        (x + Ax*Foam::cos(pi*x/(2*r)) < q.x() ? low : high) = x;
    }
    const scalar squeeze = q.y() < 0 ? By*Foam::cos(pi*low/(8*r)) : Ay;
    return point(low, q.y()/(1 - squeeze), q.z());
}


// Ten turns in steps of different lengths
static void checkTurns(checks& c)
{
    rollingLeukocyte body
    (
        leukocyte("velocity (0.2 0 0); angularVelocity (0.01 0 -0.05);")
    );
    const bodySurface first(body.placedSurface());
    const point centre(body.now().centre);
    const scalar turn = 2*pi/mag(vector(0.01, 0, -0.05));
    scalar time = 0, off = 0;
    for (label i = 0; i < 300; ++i)
    {
        const scalar dt = turn/30*(i % 2 ? 0.7 : 1.3);
        step(body, time += dt, dt);
        const bodySurface surface(body.placedSurface());
        for (const point& x : surface.points())
        {
            off = max(off, mag(mag(onSphere(x - body.now().centre)) - r));
        }
        if (i % 37 == 0)
        {
            surface.check("the material");
        }
    }
    const bodySurface last(body.placedSurface());
    const vector way(0.2*10*turn, 0, 0);
    c.checkBelow("ten turns: all points on the shape", off, 1e-10);
    c.checkBelow
    (
        "ten turns: every point is back",
        max(mag(last.points() - first.points() - way)), 1e-10
    );
    c.check
    (
        "ten turns: the same triangles, no crossings",
        last.triangles() == first.triangles()
    );
    c.checkBelow
    (
        "ten turns: the meshed triangles only travel",
        max
        (
            mag
            (
                body.meshedSurface().points() - first.points()
              - (body.now().centre - centre)
            )
        ),
        1e-11
    );
}


// Part of the time backward of a point on a circle of radius s of the sphere,
// by the roots of its velocity V + s w sin(a) (1 - k Ax sin(k s cos(a))): the
// angle a runs at a constant rate
static scalar partBackward(const scalar V, const scalar w, const scalar s)
{
    const scalar k = pi/(2*r);
    const auto velocity = [&](const scalar a)
    {
        return
            V + s*w*Foam::sin(a)*(1 - k*Ax*Foam::sin(k*s*Foam::cos(a)));
    };
    scalar backward = 0;
    const label n = 1000;
    for (label i = 0; i < n; ++i)
    {
        scalar a = 2*pi*(i + 0.3)/n, b = a + 2*pi/n;
        const bool begins = velocity(a) > 0, ends = velocity(b) > 0;
        if (begins == ends)
        {
            backward += begins ? 0 : b - a;
            continue;
        }
        const scalar from = a, to = b;
        for (label j = 0; j < 60; ++j)
        {
            const scalar middle = 0.5*(a + b);
            ((velocity(middle) > 0) == begins ? a : b) = middle;
        }
        backward += begins ? to - a : a - from;
    }
    return backward/(2*pi);
}


// The way of a point near the middle plane against the exact times
static void checkTimes(checks& c)
{
    rollingLeukocyte body
    (
        leukocyte("velocity (0.2 0 0); angularVelocity (0 0 -0.05);")
    );
    const scalar w = 0.05;
    const scalarField z
    (
        mag(body.placedSurface().points().component(vector::Z)() + 1)
    );
    const label nearest = findMin(z);
    const scalar backward =
        partBackward(0.2, w, Foam::sqrt(sqr(r) - sqr(z[nearest])));
    const label steps = 4000;
    const scalar dt = 2*pi/w/steps;
    label back = 0, up = 0;
    for (label i = 0; i < steps; ++i)
    {
        const point before(body.placedSurface().points()[nearest]);
        step(body, (i + 1)*dt, dt);
        const point after(body.placedSurface().points()[nearest]);
        back += after.x() < before.x();
        up += after.y() > before.y();
    }
    Info<< "    part of the time backward " << scalar(back)/steps << ", exact "
        << backward << ", up " << scalar(up)/steps << endl;
    c.check("it is backward for a part of the time", backward > 0.01);
    c.checkBelow
    (
        "that is the exact part, less than half",
        mag(scalar(back)/steps - backward), 3.0/steps
    );
    c.checkBelow
    (
        "and upward for half of it", mag(scalar(up)/steps - 0.5), 2.0/steps
    );
}


// Slope of |onSphere|: the normal of the shape
static vector normalAt(const point& q)
{
    const scalar h = 1e-5;
    vector g(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        vector e(Zero);
        e[d] = h;
        g[d] = mag(onSphere(q + e)) - mag(onSphere(q - e));
    }
    return g/mag(g);
}


static void checkVelocities(checks& c)
{
    const std::string turned("orientation ((1 2 0) 0.7); ");
    rollingLeukocyte body
    (
        leukocyte
        (
            turned
          + "velocity (0.1 0.02 0.3); angularVelocity (0.01 0.03 -0.05);"
        )
    );
    step(body, 7, 7);
    const quaternion axes(body.placed().orientation);
    const vector V(0.1, 0.02, 0.3);
    const vectorField v(body.pointVelocity());
    const pointField x(body.placedSurface().points());
    const scalar dt = 1e-4;
    rollingLeukocyte next
    (
        leukocyte
        (
            turned
          + "velocity (0.1 0.02 0.3); angularVelocity (0.01 0.03 -0.05);"
        )
    );
    step(next, 7 + dt, 7 + dt);
    const pointField later(next.placedSurface().points());
    step(next, 7 - dt, -2*dt);
    const pointField earlier(next.placedSurface().points());

    scalar through = 0, motion = 0, field = 0;
    label used = 0;
    forAll(x, i)
    {
        const point q(axes.invTransform(x[i] - body.now().centre));
        field = max(field, mag(body.velocityAt(x[i]) - v[i]));
        if (mag(q.y()) > 1e-3)          // not across the halves of the map
        {
            ++used;
            motion = max(motion, mag((later[i] - earlier[i])/(2*dt) - v[i]));
            through =
                max(through, mag(axes.invTransform(v[i] - V) & normalAt(q)));
        }
    }
    c.check("velocities at most points", used > 0.9*x.size());
    c.checkBelow("points move with their velocity", motion, 1e-8);
    c.checkBelow("velocities are tangential to the shape", through, 1e-8);
    c.checkBelow("the velocity at a place is the material's", field, 1e-12);
}


// Sum of the flux through the faces, over the gross sliding speed times area
static scalar netFlux(const scalar size, scalar& sliding)
{
    const rollingLeukocyte body
    (
        leukocyte("angularVelocity (0.01 0.03 -0.05);", size)
    );
    const bodySurface surface(body.meshedSurface());
    scalar net = 0, gross = 0;
    sliding = 0;
    for (const triFace& t : surface.triangles())
    {
        const point x(t.centre(surface.points()));
        const vector S(t.areaNormal(surface.points()));
        net += body.velocityAt(x) & S;
        gross += mag(body.velocityAt(x))*mag(S);
        sliding = max
        (
            sliding, mag(body.velocityAt(x, S) & S)/mag(S)
        );
    }
    return mag(net)/gross;
}


static void checkFlux(checks& c)
{
    scalar sliding;
    const scalar coarse = netFlux(1, sliding);
    const scalar fine = netFlux(0.35, sliding);
    Info<< "    net flux / gross " << coarse << ", " << fine << endl;
    c.checkBelow("no net flux through the surface", coarse, 5e-4);
    c.checkBelow("less with finer triangles", fine, 0.35*coarse);
    c.checkBelow("none at all through a face of the mesh", sliding, 1e-16);
}


static void checkState(checks& c)
{
    const std::string motion
    (
        "velocity table ((0 (0 0 0)) (10 (1 0 0)));"
        " angularVelocity polynomial (((0 0 -0.1) (0 0 0))"
        " ((0 0 0.02) (1 1 1)));"
    );
    rollingLeukocyte body(leukocyte(motion));
    step(body, 2, 2);
    c.checkClose
    (
        "path of a growing velocity", body.now().centre.x(), 3.2, 1e-14
    );
    const tensor R(body.now().orientation.R());
    c.checkClose
    (
        "angle of a changing rotation", Foam::atan2(R.yx(), R.xx()),
        -0.16, 1e-12
    );

    const pointField before(body.placedSurface().points());
    body.beginStep();
    body.advance(5, 3);
    body.rewind();
    c.check
    (
        "a rejected step leaves nothing",
        body.placedSurface().points() == before
    );

    IOstream::defaultPrecision(17);
    dictionary saved;
    body.save(saved);
    rollingLeukocyte again("cell", entries(motion, 1), 2, saved);
    step(body, 5, 3);
    step(again, 5, 3);
    c.check
    (
        "a restored one continues to the last bit",
        again.placedSurface().points() == body.placedSurface().points()
     && again.pointVelocity() == body.pointVelocity()
    );
    c.checkFatal
    (
        "another shape than the saved one is refused",
        [&]{ rollingLeukocyte("cell", entries(motion, 1.1), 2, saved); },
        "no longer the one of the saved state"
    );

    rollingLeukocyte still(leukocyte(""));
    const pointField there(still.placedSurface().points());
    step(still, 5, 5);
    c.check
    (
        "without velocities it stays as it is",
        still.placedSurface().points() == there
     && max(mag(still.pointVelocity())) == 0
    );
}


int main()
{
    checks c;
    checkTurns(c);
    checkTimes(c);
    checkVelocities(c);
    checkFlux(c);
    checkState(c);
    return c.finish();
}
