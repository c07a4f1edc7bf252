/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestSolvers

Description
    Checks of the coupled solution and of SIMPLEC on every kind of cell: orders
    against exact Stokes flow, iterations, agreement of the methods, free
    bodies, the stresslet of a sphere, units.

\*---------------------------------------------------------------------------*/

#include "correctionSecants.H"
#include "petscObjects.H"
#include "previousSolutions.H"
#include "strainedSphere.H"
#include "checks.H"
#include "testMeshes.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

static const boundBox cube(point(-1, -1, -1), point(1, 1, 1));
static const boundBox wide(point(-3, -3, -3), point(3, 3, 3));

//- Smooth in the cube: the sphere is outside
static const movingSphere smooth
{
    point(-2.2, -1.9, -2), 1, vector(1, 0.5, -0.3), 1.7
};

//- The sphere in the middle of the wide box
static const movingSphere inside{point(0, 0, 0), 1, vector(0.6, -0.2, 0.7), 1.7};


static void checkOrders(checks& c)
{
    // iterations of a sound preconditioner, to 1e-8, at most
    const scalar most[] = {48, 48, 58, 48};
    const testMeshes meshes(cube);
    const wordList kinds(testMeshes::kinds());
    forAll(kinds, k)
    {
        const word& kind = kinds[k];
        scalar u[2], p[2], h[2];
        label its[2];
        for (label level = 0; level < 2; ++level)
        {
            autoPtr<fvMesh> mesh(meshes.mesh(kind, level ? 16 : 8));
            problem flow(mesh(), smooth);
            flow.solve("tolerance 1e-8;");
            c.check
            (
                kind + (level ? ", fine" : ", coarse") + ": converged",
                flow.report.converged
            );
            flow.errors(u[level], p[level]);
            its[level] = flow.report.iterations;
            h[level] = 1/Foam::cbrt(scalar(mesh->nCells()));
            Info<< "    " << kind << ", " << mesh->nCells() << " cells: "
                << its[level] << " iterations, errors: velocity " << u[level]
                << ", pressure " << p[level] << endl;
        }
        const scalar spacing = Foam::log(h[0]/h[1]);
        const scalar ofU = Foam::log(u[0]/u[1])/spacing;
        const scalar ofP = Foam::log(p[0]/p[1])/spacing;
        Info<< "    " << kind << ": order of velocity " << ofU
            << ", of pressure " << ofP << endl;
        c.check(kind + ": order of the velocity", ofU > 1.8, name(ofU));
        c.check
        (
            kind + ": order of the pressure",
            ofP > (kind == "tetrahedra" ? 0.9 : 1.5), name(ofP)
        );
        c.checkBelow(kind + ": error of the velocity", u[1], 0.01);
        c.checkBelow(kind + ": iterations", its[1], most[k]);
        c.check
        (
            kind + ": iterations are flat", its[1] < 1.25*its[0],
            name(its[0]) + " and " + name(its[1])
        );
    }
}


//- Push the bodies of two solutions harder: the fluid is still at balance, so
//  that only the bodies say that the solution is another now
static void checkPushed
(
    checks& c, const word& kind, problem& coupled, problem& SIMPLEC
)
{
    const vector before(linear(coupled.bodies[0].velocity));
    for (problem* p : {&coupled, &SIMPLEC})
    {
        p->bodies[0].rhs = join(2*inside.force(), Zero);
    }
    coupled.solve("tolerance 1e-8;");
    SIMPLEC.solve("method SIMPLEC; tolerance 1e-8;");
    const vector V(linear(coupled.bodies[0].velocity));
    c.checkBelow
    (
        kind + ": pushed harder from there it moves alike, too",
        mag(V - linear(SIMPLEC.bodies[0].velocity))/mag(V), 1e-5
    );
    c.check
    (
        kind + ": which is another velocity", mag(V - before) > 1e-3*mag(V)
    );
}


static void checkMethods(checks& c)
{
    const testMeshes box(cube), room(wide);
    for (const word& kind : testMeshes::kinds())
    {
        const bool sphere = kind == "tetrahedra" || kind == "polyhedra";
        autoPtr<fvMesh> mesh
        (
            sphere ? room.mesh(kind, 6, 0.4) : box.mesh(kind, 8)
        );
        problem a(mesh(), sphere ? inside : smooth);
        problem b(mesh(), sphere ? inside : smooth);
        a.solve("tolerance 1e-8;");
        b.solve("method SIMPLEC; tolerance 1e-8;");
        Info<< "    " << kind << ", " << mesh->nCells() << " cells: coupled "
            << a.report.iterations << ", SIMPLEC " << b.report.iterations
            << " iterations, difference " << a.difference(b) << endl;
        c.check(kind + ": coupled converges", a.report.converged);
        c.check(kind + ": SIMPLEC converges", b.report.converged);
        c.checkBelow
        (
            kind + ": coupled and SIMPLEC agree", a.difference(b), 1e-5
        );
        c.checkBelow(kind + ": SIMPLEC's iterations", b.report.iterations, 400);
        forAll(a.bodies, i)
        {
            const vector V(linear(a.bodies[i].velocity));
            c.checkBelow
            (
                kind + ": the free body moves alike",
                mag(V - linear(b.bodies[i].velocity))/mag(V), 1e-5
            );
            checkPushed(c, kind, a, b);
        }
    }
}


static void checkFreeBody(checks& c)
{
    const testMeshes room(wide);
    for (const word kind : {"tetrahedra", "polyhedra"})
    {
        autoPtr<fvMesh> mesh(room.mesh(kind, 6, 0.3));
        problem free(mesh(), inside);
        free.solve("tolerance 1e-7;");

        // the fluid's share of the walls balances what is put in
        const sixVector load(free.load());
        c.checkBelow
        (
            kind + ": force balance of a free body",
            mag(linear(load) + inside.force())/mag(inside.force()), 1e-5
        );
        c.checkBelow
        (
            kind + ": torque balance of a free body",
            mag(angular(load))/mag(inside.force()), 1e-5
        );
        const vector V(linear(free.bodies[0].velocity));
        const scalar bound = kind == "tetrahedra" ? 0.02 : 0.06;
        Info<< "    " << kind << ", " << mesh->nCells() << " cells: V/exact "
            << (V & inside.velocity)/magSqr(inside.velocity)
            << ", omega " << mag(angular(free.bodies[0].velocity)) << endl;
        c.checkBelow
        (
            kind + ": V = F/(6 pi mu a)",
            mag(V - inside.velocity)/mag(inside.velocity), bound
        );
        c.checkBelow
        (
            kind + ": it does not turn",
            mag(angular(free.bodies[0].velocity))/mag(V), 0.01
        );

        problem fixed(mesh(), inside);
        fixed.bodies[0].free = false;
        fixed.bodies[0].velocity = free.bodies[0].velocity;
        fixed.solve("tolerance 1e-7;");
        c.checkBelow
        (
            kind + ": moved with that velocity it meets that force",
            mag(linear(fixed.load()) + inside.force())/mag(inside.force()), 1e-4
        );
        Info<< "    " << kind << ": " << free.report.iterations
            << " iterations free, " << fixed.report.iterations << " given"
            << endl;
        c.check
        (
            kind + ": iterations of a free body",
            free.report.iterations <= 1.3*fixed.report.iterations + 1,
            name(free.report.iterations) + " against "
          + name(fixed.report.iterations)
        );

        problem heavy(mesh(), inside);
        const scalar m = 40;
        heavy.bodies[0].massRate = m;
        heavy.bodies[0].inertiaRate = 16*tensor::I;
        heavy.solve("tolerance 1e-7;");
        const sixVector v(heavy.bodies[0].velocity);
        c.checkBelow
        (
            kind + ": inertia is balanced",
            mag(linear(heavy.load()) + inside.force() - m*linear(v))
           /mag(inside.force()), 1e-5
        );
    }
}


//- The first moment of the traction, where pressure and shear have a part each
static void checkStresslet(checks& c)
{
    const testMeshes room(wide);
    vector error[2];
    const scalar size[2] = {0.3, 0.2};
    for (label level = 0; level < 2; ++level)
    {
        autoPtr<fvMesh> mesh
        (
            room.mesh("tetrahedra", level ? 18 : 12, size[level])
        );
        const strainedSphere sphere(mesh(), 1.7);
        const vector moments(sphere.moments());
        error[level] = cmptMag(moments - vector::one);
        Info<< "    strained sphere, " << mesh->nCells() << " cells: "
            << sphere.flow.report.iterations
            << " iterations, stresslet over the exact one: of pressure "
            << moments.x() << ", of shear " << moments.y() << ", in all "
            << moments.z() << endl;
    }
    const scalar order =
        Foam::log(error[0].z()/error[1].z())/Foam::log(size[0]/size[1]);
    c.check("stresslet: order", order > 1.8, name(order));
    c.checkBelow("stresslet", error[1].z(), 0.02);
    c.checkBelow("stresslet of the pressure", error[1].x(), 0.09);
    c.checkBelow("stresslet of the shear", error[1].y(), 0.03);
}


//- A sphere turning in its own flow, u = omega x r/r^3, meets the torque
//  8 pi mu omega: a third of it by the transposed velocity gradient, which is
//  no part of forces, nor of tractions on bodies at rest
static void checkSpin(checks& c)
{
    const vector omega(0.3, -0.5, 0.7);
    const scalar mu = 1.7, size = 0.3;
    const testMeshes room(wide);
    autoPtr<fvMesh> mesh(room.mesh("tetrahedra", 12, size));
    problem spin(mesh(), movingSphere{Zero, 1, Zero, mu});
    const auto u = [&](const point& x)
    {
        const scalar r = mag(x);
        return vector((omega ^ x)/(r < 1.5 ? 1 : pow3(r)));
    };
    forAll(spin.given.vertices, i)
    {
        spin.given.vertices[i] =
            u(spin.stokes.wallPoints()[i]);
    }
    forAll(spin.given.faces, i)
    {
        spin.given.faces[i] =
            u(mesh->faceCentres()[mesh->nInternalFaces() + i]);
    }
    spin.balance();
    spin.bodies[0].free = false;
    spin.bodies[0].velocity = join(Zero, omega);
    spin.solve("tolerance 1e-7;");
    const vector exact(-8*constant::mathematical::pi*mu*omega);
    const vector torque(angular(spin.load()));
    Info<< "    turning sphere: torque over the exact one "
        << (torque & exact)/magSqr(exact) << endl;
    // second order in the size over the radius
    c.checkBelow
    (
        "torque of a turning sphere", mag(torque - exact)/mag(exact),
        0.5*sqr(size)
    );
}


//- Guesses from previous solutions, of a system whose right-hand side goes along
//  a parabola: three solutions span it
static void checkPrevious(checks& c)
{
    const label n = 6;
    const auto multiply = [](const scalar* x, scalar* y)
    {
        for (label i = 0; i < n; ++i)
        {
            y[i] = (3 + i)*x[i] - x[(i + 1) % n] + 0.5*x[(i + 4) % n];
        }
    };
    const auto solution = [](const scalar t)
    {
        scalarList x(n);
        forAll(x, i)
        {
            x[i] = Foam::sin(1.0 + i) + t*Foam::cos(3.0*i) + sqr(t)*(i - 2);
        }
        return x;
    };
    // residual of x, beside that of the guess, for the right-hand side at t
    const auto improved = [&](const previousSolutions& previous, const scalar t)
    {
        const auto norm = [&](const scalarList& x, scalarList& r)
        {
            scalarList b(n);
            multiply(solution(t).cdata(), b.begin());
            multiply(x.cdata(), r.begin());
            scalar sum = 0;
            forAll(r, i)
            {
                r[i] -= b[i];
                sum += sqr(r[i]);
            }
            return Foam::sqrt(sum);
        };
        scalarList x(solution(0.3)), r(n);
        const scalar before = norm(x, r);
        previous.improve(multiply, x, r);
        return norm(x, r)/before;
    };
    previousSolutions previous;
    c.checkClose("previous solutions: none", improved(previous, 0.5), 1, 1e-14);
    previous.add(solution(0));
    previous.add(solution(0.1));
    const scalar two = improved(previous, 0.5);
    c.check
    (
        "previous solutions: two and the last one leave nothing of a parabola",
        two < 1e-12, name(two)
    );
    previousSolutions same;
    same.add(solution(0.3));
    same.add(solution(0.3));
    c.checkClose("previous solutions: all alike", improved(same, 0.5), 1, 1e-12);
    // one: what is left of a residual r along a line is its part at right angles
    previousSolutions line;
    line.add(solution(0));
    scalarList d(solution(0)), e(solution(0.5)), Ad(n), r(n);
    forAll(d, i)
    {
        d[i] -= solution(0.3)[i];
        e[i] -= solution(0.3)[i];
    }
    multiply(d.cdata(), Ad.begin());
    multiply(e.cdata(), r.begin());
    scalar along = 0, lengths = 0, size = 0;
    forAll(r, i)
    {
        along += r[i]*Ad[i];
        lengths += sqr(Ad[i]);
        size += sqr(r[i]);
    }
    c.checkClose
    (
        "previous solutions: one", improved(line, 0.5),
        Foam::sqrt(1 - sqr(along)/(lengths*size)), 1e-12
    );
}


//- Corrections that leave the parts of an error to entries 0, 1 ..., until it is
//  below 1e-9 of the first; GREAT: never
static scalar correctionsNeeded(const scalarList& parts)
{
    const label n = 40, begin = 10;
    correctionSecants secants;
    secants.start(begin, n);
    scalarList x(n);
    forAll(x, i)
    {
        x[i] = 1 + 0.1*i;           // the solution is zero
    }
    for (label k = 1; k <= 40; ++k)
    {
        scalarList next(n, Zero), better;
        forAll(parts, i)
        {
            next[begin + i] = parts[i]*x[begin + i];
        }
        x = secants.better(x, next, better) ? better : next;
        scalar largest = 0;
        for (label i = begin; i < n; ++i)
        {
            largest = max(largest, mag(x[i]));
        }
        if (largest < 1e-9)
        {
            return k;
        }
    }
    return GREAT;
}


static void checkSecants(checks& c)
{
    const auto most = [&](const char* what, const scalarList& parts, const label n)
    {
        const scalar k = correctionsNeeded(parts);
        c.check(string("secants: ") + what, k <= n, name(k));
    };
    // bound: theory. Linear, it is exact once there are as many differences as
    // shapes that are left, all else dies in the first correction; the first four
    // corrections are plain
    most("one shape that shrinks slowly", {0.9}, 5);
    most("one that grows", {-1.3}, 5);
    // of shapes whose corrections differ by more than the filter's 100 it finds the
    // larger one first: two that go from side to side do not
    most("two, one of which grows", {-0.8, -1.2}, 5);
    // a thousandth a time: plain corrections are better than that
    most("none where corrections are good", {1e-3, -1e-3}, 4);
}


static void checkUnits(checks& c)
{
    const testMeshes room(wide);
    const meshLists lists(room.lists("tetrahedra", 6, 0.4));
    const auto run = [&](const scalar L, const scalar U, const scalar mu)
    {
        autoPtr<fvMesh> mesh(room.scaled(lists, L));
        problem flow(mesh(), movingSphere{Zero, L, U*inside.velocity, mu});
        flow.solve("tolerance 1e-7;");
        return Tuple2<label, vector>
        (
            flow.report.iterations, linear(flow.bodies[0].velocity)/U
        );
    };
    const auto microvascular = run(8, 1e-4, 1);
    const auto SI = run(8e-6, 1e-4, 1e-3);
    c.check
    (
        "SI and microvascular units: iterations",
        mag(microvascular.first() - SI.first()) <= 1,
        name(microvascular.first()) + " and " + name(SI.first())
    );
    c.checkBelow
    (
        "SI and microvascular units: answer",
        mag(microvascular.second() - SI.second()), 1e-7
    );
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    petscSession petsc;
    checks c;
    checkOrders(c);
    checkMethods(c);
    checkFreeBody(c);
    checkStresslet(c);
    checkSpin(c);
    checkUnits(c);
    checkPrevious(c);
    checkSecants(c);
    return c.finish();
}
