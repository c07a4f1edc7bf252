/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestLocalSolutions

Description
    Checks of the Stokes operator of fourth order: exact for cubic solutions,
    drag of a sphere in its exact far field.

\*---------------------------------------------------------------------------*/

#include "appliedOperator.H"
#include "checks.H"
#include "meshDistribution.H"
#include "petscObjects.H"
#include "problem.H"
#include "testMeshes.H"
#include "argList.H"
#include "cpuTime.H"
#include "triPointRef.H"

using namespace Foam;
using namespace Foam::fsbi;

static const scalar mu = 1.7;

//- Gauss' rule for polynomials up to degree five
static const scalar gaussPoint[] =
{
    0.5 - Foam::sqrt(0.15), 0.5, 0.5 + Foam::sqrt(0.15)
};
static const scalar gaussWeight[] = {5.0/18, 8.0/18, 5.0/18};

//- Mean over a tetrahedron of polynomials up to degree three, in the directions
//  of a collapsed cube
template<class Type>
static Type mean
(
    const std::function<Type(const point&)>& f, const FixedList<point, 4>& x
)
{
    Type sum(Zero);
    for (label i = 0; i < 27; ++i)
    {
        const label a = i/9, b = i/3 % 3, c = i % 3;
        const scalar u = gaussPoint[a], v = gaussPoint[b], w = gaussPoint[c];
        const point y
        (
            x[0] + u*(x[1] - x[0] + v*(x[2] - x[1] + w*(x[3] - x[2])))
        );
        sum += 6*gaussWeight[a]*gaussWeight[b]*gaussWeight[c]*u*u*v*f(y);
    }
    return sum;
}


//- The same over a triangle
static vector mean
(
    const std::function<vector(const point&)>& f, const triPointRef& t
)
{
    vector sum(Zero);
    for (label i = 0; i < 9; ++i)
    {
        const scalar u = gaussPoint[i/3], v = gaussPoint[i % 3];
        const point y(t.a() + u*(t.b() - t.a() + v*(t.c() - t.b())));
        sum += 2*gaussWeight[i/3]*gaussWeight[i % 3]*u*f(y);
    }
    return sum;
}


static FixedList<point, 4> corners(const fvMesh& mesh, const label celli)
{
    FixedList<point, 4> x;
    forAll(x, k)
    {
        x[k] = mesh.points()[mesh.cellPoints()[celli][k]];
    }
    return x;
}


//- A cubic flow with quadratic pressure, in axes that are not the mesh's
static exactFlow cubicFlow()
{
    const vector a(normalised(vector(1, 2, -1)));
    const vector b(normalised(vector(2, -1, 0)));
    const tensor R(a, b, a ^ b);
    // one with pressure, the gradient of a harmonic function, lower degrees
    const auto local = [](const point& x)
    {
        const scalar X = x.x(), Y = x.y(), Z = x.z();
        return vector
        (
            -pow3(Z) + 4*pow3(X) - 12*X*sqr(Y) + Y*Z + 2*Y - 0.4,
            -12*sqr(X)*Y + 4*pow3(Y) + 0.7*sqr(X),
            -pow3(X) - 0.3*X*Y + 1.1
        );
    };
    const auto gradient = [](const point& x)
    {
        const scalar X = x.x(), Y = x.y(), Z = x.z();
        return tensor
        (
            12*sqr(X) - 12*sqr(Y), -24*X*Y + 1.4*X, -3*sqr(X) - 0.3*Y,
            -24*X*Y + Z + 2, -12*sqr(X) + 12*sqr(Y), -0.3*X,
            -3*sqr(Z) + Y, 0, 0
        );
    };
    exactFlow flow;
    flow.u = [=](const point& x) { return R.T() & local(R & x); };
    flow.gradU = [=](const point& x)
    {
        return R.T() & gradient(R & x) & R;
    };
    flow.p = [=](const point& x)
    {
        const point y(R & x);
        return mu*(-6*y.x()*y.z() + 1.4*y.y()) + 0.3;
    };
    return flow;
}


//- Set the cells to the means of a flow, and what is given to its velocity
static void setFlow(appliedOperator& a, const exactFlow& flow)
{
    for (label i = 0; i < a.mesh.nCells(); ++i)
    {
        const FixedList<point, 4> x(corners(a.mesh, i));
        const vector u(mean(flow.u, x));
        a.x[4*i] = u.x();
        a.x[4*i + 1] = u.y();
        a.x[4*i + 2] = u.z();
        a.x[4*i + 3] = mean(flow.p, x);
    }
    forAll(a.b.faces, i)
    {
        const face& f = a.mesh.faces()[a.mesh.nInternalFaces() + i];
        const pointField& p = a.mesh.points();
        a.b.faces[i] = mean(flow.u, triPointRef(p[f[0]], p[f[1]], p[f[2]]));
    }
    forAll(a.b.vertices, i)
    {
        a.b.vertices[i] = flow.u(a.stokes.wallPoints()[i]);
    }
    a.apply();
}


static void checkCubic(checks& c)
{
    const testMeshes box(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    autoPtr<fvMesh> mesh(box.mesh("tetrahedra", 5));
    appliedOperator a(mesh(), mu, wordList(), {4});
    const exactFlow flow(cubicFlow());
    setFlow(a, flow);
    const scalar S = Foam::pow(gAverage(mesh->cellVolumes()), 2.0/3.0);
    Info<< "    " << mesh->nCells() << " tetrahedra" << endl;
    // bound: round-off in sums of some hundred terms of order ten
    c.checkBelow("cubic flow: momentum rows", a.largest(true)/S, 1e-10);
    c.checkBelow("cubic flow: continuity rows", a.largest(false)/S, 1e-11);
    const tensorField grad(a.stokes.velocityGradients());
    scalar worst = 0;
    forAll(grad, i)
    {
        worst = max(worst, mag(grad[i] - flow.gradU(mesh->cellCentres()[i])));
    }
    c.checkBelow("cubic flow: gradients at cells", worst, 1e-10);
    // the total over the boundary, of tractions that are themselves not linear
    vector force(Zero);
    for (const vector& t : a.traction)
    {
        force += t;
    }
    c.checkBelow("cubic flow: no force on the whole boundary", mag(force), 1e-9);
}


static scalar drag
(
    const fvMesh& mesh, const label order, const scalar radius, checks& c
)
{
    const movingSphere flow{Zero, radius, vector(0.6, -0.2, 0.7), mu};
    cpuTime clock;
    problem p(mesh, flow, order);
    const scalar setUp = clock.cpuTimeIncrement();
    p.bodies[0].free = false;
    p.bodies[0].velocity = join(flow.velocity, Zero);
    p.solve("tolerance 1e-6;");
    const scalar solve = clock.cpuTimeIncrement();
    const vector F(linear(p.load()));
    for (label i = 0; i < 20; ++i)
    {
        scalarList r(p.x.size());
        p.stokes.residual(p.x.cdata(), p.given, r.begin(), p.traction);
    }
    const scalar apply = clock.cpuTimeIncrement()/20;
    const vector exact(-flow.force());
    Info<< "    order " << order << ", " << mesh.nCells() << " cells: drag "
        << 100*((F & exact)/magSqr(exact) - 1) << " %, across "
        << 100*mag(F - (F & exact)/magSqr(exact)*exact)/mag(exact) << " %, "
        << p.report.iterations << " iterations; set-up "
        << 1e6*setUp/mesh.nCells() << " us a cell, solution " << solve
        << " s, application " << 1e6*apply/mesh.nCells() << " us a cell"
        << endl;
    c.check("converged", p.report.converged);
    return mag(F - exact)/mag(exact);
}


//- Any smooth flow on the boundary, anything at all in the cells
static void disturb(appliedOperator& a, const labelUList& cells)
{
    const auto u = [](const point& x)
    {
        return vector
        (
            Foam::sin(x.y() + 2*x.z()), Foam::cos(x.x() - x.z()),
            Foam::sin(x.x()*x.y())
        );
    };
    forAll(a.x, i)
    {
        a.x[i] = noise(4*cells[i/4] + i % 4);
    }
    forAll(a.b.faces, i)
    {
        a.b.faces[i] = u(a.mesh.faceCentres()[a.mesh.nInternalFaces() + i]);
    }
    forAll(a.b.vertices, i)
    {
        a.b.vertices[i] = u(a.stokes.wallPoints()[i]);
    }
    a.apply();
}


//- A moved mesh against a new one
static void checkUpdate(checks& c)
{
    const testMeshes room(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    autoPtr<fvMesh> mesh(room.mesh("tetrahedra", 4, 0.4));
    const labelList cells(identity(mesh->nCells()));
    appliedOperator moved(mesh(), mu, wordList(), {4});
    pointField x(mesh->points());
    forAll(x, i)
    {
        const vector way(x[i].y(), -x[i].x(), 0.1*x[i].z());
        x[i] += 0.1*way*(1 - sqr(mag(x[i])/6));
    }
    mesh->movePoints(x);
    moved.stokes.update();
    disturb(moved, cells);
    appliedOperator made(mesh(), mu, wordList(), {4});
    disturb(made, cells);
    scalar worst = 0;
    forAll(made.r, i)
    {
        worst = max(worst, mag(made.r[i] - moved.r[i]));
    }
    // bound: the same numbers, but that a moved mesh may have more cells at
    // badly conditioned vertices: none here
    c.checkBelow("a moved mesh is as a new one", worst, 1e-12);
}


//- The same on one processor and on all, the body's surface cut as well
static void checkParallel(checks& c)
{
    const testMeshes room(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    meshLists whole;
    labelList ranks;
    scalarList r;
    vectorField traction;
    if (Pstream::master())
    {
        Pstream::parRun() = false;
        whole = room.lists("tetrahedra", 4, 0.4);
        ranks = meshDistribution::bisect(whole, Pstream::nProcs());
        autoPtr<fvMesh> mesh(room.scaled(whole, 1));
        appliedOperator a(mesh(), mu, wordList(), {4});
        disturb(a, identity(mesh->nCells()));
        r = a.r;
        traction = a.traction;
        Pstream::parRun() = true;
    }
    Pstream::scatter(r);
    Pstream::scatter(traction);
    const meshDistribution part(whole, ranks);
    autoPtr<fvMesh> mesh(room.scaled(part.mesh, 1));
    appliedOperator a(mesh(), mu, wordList(), {4});
    disturb(a, part.cells);
    scalar rows = 0, tractions = 0;
    forAll(a.r, i)
    {
        rows = max(rows, mag(a.r[i] - r[4*part.cells[i/4] + i % 4]));
    }
    forAll(a.traction, i)
    {
        if (a.uncoupled(i))
        {
            const label facei =
                part.faces[mesh->nInternalFaces() + i]
              - part.wholePatchStarts[0];
            tractions = max(tractions, mag(a.traction[i] - traction[facei]));
        }
    }
    // bound: sums in another order, of numbers up to ten
    c.checkBelow("in parallel: residual", returnReduce(rows, maxOp<scalar>()), 1e-10);
    c.checkBelow
    (
        "in parallel: traction", returnReduce(tractions, maxOp<scalar>()), 1e-10
    );
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    petscSession petsc;
    checks c;
    if (Pstream::parRun())
    {
        checkParallel(c);
        return c.finish();
    }
    checkCubic(c);
    checkUpdate(c);
    const testMeshes room(boundBox(point(-4, -4, -4), point(4, 4, 4)));
    for (const scalar size : {0.4, 0.28, 0.2, 0.132})
    {
        autoPtr<fvMesh> mesh(room.mesh("tetrahedra", 3, size, size));
        const polyPatch& sphere = mesh->boundaryMesh()["sphere"];
        const scalar radius = mag(sphere.localPoints()[0]);
        drag(mesh(), 2, 1, c);
        drag(mesh(), 4, radius, c);
    }
    return c.finish();
}
