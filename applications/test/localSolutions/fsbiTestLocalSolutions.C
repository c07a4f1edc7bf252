/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestLocalSolutions

Description
    Checks of the Stokes operator of fourth order: exact for cubic solutions,
    moved meshes, drag, velocity and torque of a sphere. Run on several
    processors (mpirun -np 3 fsbiTestLocalSolutions -parallel) it compares with
    one processor.

\*---------------------------------------------------------------------------*/

#include "appliedOperator.H"
#include "checks.H"
#include "cubicFlow.H"
#include "meshDistribution.H"
#include "petscObjects.H"
#include "problem.H"
#include "testMeshes.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

static const scalar mu = 1.7;

//- Power of what fits leave, over the dissipation, of the whole flow
static scalar defects(const stokesOperator& stokes, const fvMesh& mesh)
{
    const scalarField dissipation
    (
        2*mu*magSqr(symm(stokes.velocityGradients()))*mesh.cellVolumes()
    );
    return gSum(stokes.defectPower()())/gSum(dissipation);
}


static void checkCubic(checks& c)
{
    const testMeshes box(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    autoPtr<fvMesh> mesh(box.mesh("tetrahedra", 5));
    appliedOperator a(mesh(), mu, wordList(), {4});
    const exactFlow flow(cubicFlow(mu));
    setFlow(a, flow, mu);
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
    // bound: round-off as above, squared
    c.checkBelow("cubic flow: fits leave nothing", defects(a.stokes, mesh()), 1e-20);
    // the total over the boundary, of tractions that are themselves not linear
    vector force(Zero);
    for (const vector& t : a.traction)
    {
        force += t;
    }
    c.checkBelow("cubic flow: no force on the whole boundary", mag(force), 1e-9);
}


//- Rows without a force per volume, where there is one
static void checkForced(checks& c, const word& name, const wordList& open)
{
    const testMeshes box(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    autoPtr<fvMesh> mesh(box.mesh("tetrahedra", 5));
    const vector push(0.4, -1, 0.7), spin(-1.1, 0.6, 0.8);
    const symmTensor stretch(1, -0.4, 0.3, 2, 0.9, -1.3);
    appliedOperator a(mesh(), mu, open, {4});
    const scalarField& V = mesh->cellVolumes();
    a.force =
        push + (stretch & mesh->cellCentres()) + (spin ^ mesh->cellCentres());
    setFlow(a, cubicFlow(mu, push, stretch, spin), mu);
    forAll(V, i)
    {
        for (label k = 0; k < 3; ++k)
        {
            a.r[4*i + k] -= V[i]*a.force[i][k];
        }
    }
    // bound: as without a force
    const scalar S = Foam::pow(gAverage(V), 2.0/3.0);
    c.checkBelow(name + ": momentum rows", a.largest(true)/S, 1e-10);
    c.checkBelow(name + ": continuity rows", a.largest(false)/S, 1e-11);
}


//- Tetrahedra around a sphere whose vertices have radius 1, in a cube of 8;
//  edges grow with the distance as they are
static autoPtr<fvMesh> aroundSphere(const scalar size)
{
    const testMeshes room(boundBox(point(-4, -4, -4), point(4, 4, 4)));
    autoPtr<fvMesh> scaledOutward(room.mesh("tetrahedra", 3, size, size));
    const polyPatch& sphere = scaledOutward->boundaryMesh()["sphere"];
    return room.scaled
    (
        listsOf(scaledOutward()), 1/mag(sphere.localPoints()[0])
    );
}


//- Root mean square of the cells' velocities less the flow's means
static scalar velocityError(const problem& p)
{
    const std::function<vector(const point&)> u = [&](const point& x)
    {
        return p.flow.u(x);
    };
    const scalarField& V = p.mesh.cellVolumes();
    scalar sum = 0;
    forAll(V, i)
    {
        const vector exact(simplexMean(corners(p.mesh, i), u));
        const vector found(p.x[4*i], p.x[4*i + 1], p.x[4*i + 2]);
        sum += V[i]*magSqr(found - exact);
    }
    return Foam::sqrt(sum/gSum(V));
}


static void checkSphere(checks& c)
{
    // bound: required before: drag 0.3 % at 5 000 tetrahedra, 0.05 % at 13 000,
    // 45 iterations, order 3.5 of the velocity
    const scalar size[] = {0.28, 0.2}, most[] = {0.003, 0.0005};
    scalar error[2], left[2];
    for (label level = 0; level < 2; ++level)
    {
        autoPtr<fvMesh> mesh(aroundSphere(size[level]));
        const std::string name = Foam::name(mesh->nCells()) + " tetrahedra: ";
        problem p(mesh(), movingSphere{Zero, 1, vector(0.6, -0.2, 0.7), mu}, 4);
        p.bodies[0].free = false;
        p.bodies[0].velocity = join(p.flow.velocity, Zero);
        p.solve("tolerance 1e-6;");
        const vector F(linear(p.load())), exact(-p.flow.force());
        error[level] = velocityError(p);
        left[level] = defects(p.stokes, mesh());
        Info<< "    " << name.c_str() << "drag over the exact one "
            << (F & exact)/magSqr(exact) << ", " << p.report.iterations
            << " iterations, error of the velocity " << error[level] << endl;
        c.check(name + "converged", p.report.converged);
        c.checkBelow(name + "iterations", p.report.iterations, 45);
        c.checkClose
        (
            name + "drag", (F & exact)/magSqr(exact), 1, most[level]
        );
    }
    const scalar order =
        Foam::log(error[0]/error[1])/Foam::log(size[0]/size[1]);
    c.check("sphere: order of the velocity", order > 3.5, name(order));
    const scalar orderOfPower =
        Foam::log(left[0]/left[1])/Foam::log(size[0]/size[1]);
    // bound: jumps of means fall as h^4, k in a volume as h^-2; meshes that are
    // not similar as of the velocity
    c.checkClose("sphere: order of what fits leave", orderOfPower, 6, 0.2);
}


//- A sphere turning in its exact far field, which pulls with 8 pi mu omega
static void checkTorque(checks& c)
{
    const vector omega(0.3, -0.5, 0.7);
    autoPtr<fvMesh> mesh(aroundSphere(0.2));
    problem p(mesh(), movingSphere{Zero, 1, Zero, mu}, 4);
    const auto u = [&](const point& x)
    {
        return vector((omega ^ x)/pow3(max(mag(x), scalar(1))));
    };
    forAll(p.given.vertices, i)
    {
        p.given.vertices[i] = u(p.stokes.wallPoints()[i]);
    }
    forAll(p.given.faces, i)
    {
        p.given.faces[i] = u(mesh->faceCentres()[mesh->nInternalFaces() + i]);
    }
    p.balance();
    p.bodies[0].free = false;
    p.bodies[0].velocity = join(Zero, omega);
    p.solve("tolerance 1e-6;");
    const vector exact(-8*constant::mathematical::pi*mu*omega);
    const vector torque(angular(p.load()));
    Info<< "    turning sphere, " << mesh->nCells()
        << " tetrahedra: torque over the exact one "
        << (torque & exact)/magSqr(exact) << ", " << p.report.iterations
        << " iterations" << endl;
    // bound: required before: 0.3 % at 13 000 tetrahedra
    c.checkBelow
    (
        "turning sphere: torque", mag(torque - exact)/mag(exact), 0.003
    );
}


//- A free sphere pushed with the drag of a velocity goes with it
static void checkFree(checks& c)
{
    autoPtr<fvMesh> mesh(aroundSphere(0.28));
    problem p(mesh(), movingSphere{Zero, 1, vector(0.6, -0.2, 0.7), mu}, 4);
    p.solve("tolerance 1e-6;");
    const vector V(linear(p.bodies[0].velocity));
    Info<< "    free sphere: V/exact " << (V & p.flow.velocity)
          /magSqr(p.flow.velocity) << ", omega "
        << mag(angular(p.bodies[0].velocity)) << ", "
        << p.report.iterations << " iterations" << endl;
    // bound: as the drag at 5 000 tetrahedra; two to four iterations more than
    // a sphere of given velocity, as with order 2
    c.checkBelow
    (
        "free sphere: velocity", mag(V - p.flow.velocity)/mag(V), 0.003
    );
    c.checkBelow("free sphere: iterations", p.report.iterations, 49);
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


//- Velocities in the middle of the edges of a sphere from those of its vertices
static void checkEdges(checks& c)
{
    autoPtr<fvMesh> mesh(aroundSphere(0.2));
    appliedOperator a(mesh(), mu, wordList(), {4});
    const auto u = [](const point& x)
    {
        return vector(x.y()*x.z(), Foam::sin(2*x.x()), sqr(x.z()) - x.x());
    };
    const label patchi = mesh->boundaryMesh().findPatchID("sphere");
    const label nVertices = a.stokes.wallVertices().size();
    vectorField found(a.stokes.wallPoints().size(), Zero);
    for (label i = 0; i < nVertices; ++i)
    {
        found[i] = u(a.stokes.wallPoints()[i]);
    }
    a.stokes.setOnEdges(patchi, found);
    scalar plain = 0, better = 0;
    const labelList points
    (
        a.stokes.wallPointsOn(mesh->boundaryMesh()[patchi].meshPoints())
    );
    for (const label i : points)
    {
        if (i >= nVertices)
        {
            const edge& e = a.stokes.wallEdges()[i - nVertices];
            const vector exact(u(a.stokes.wallPoints()[i]));
            const vector ends
            (
                u(mesh->points()[e.start()]) + u(mesh->points()[e.end()])
            );
            plain += magSqr(ends/2 - exact);
            better += magSqr(found[i] - exact);
        }
    }
    Info<< "    edges of a sphere: error of the velocity over that of the mean of"
        << " both ends " << Foam::sqrt(better/plain) << endl;
    // bound: of the mean h^2/8 u''; of the cubic a fifth of it, the gradients'
    // errors being of first order, and mostly alike at both ends
    c.checkBelow("velocity on edges of a sphere", Foam::sqrt(better/plain), 0.2);
}


//- The same on one processor and on all, the body's surface cut as well
static void checkParallel(checks& c)
{
    const testMeshes room(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    meshLists whole;
    labelList ranks;
    scalarList r;
    scalarField power;
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
        power = a.stokes.defectPower();
        Pstream::parRun() = true;
    }
    Pstream::scatter(r);
    Pstream::scatter(power);
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
    const scalarField own(a.stokes.defectPower());
    scalar powers = 0;
    forAll(own, i)
    {
        powers = max(powers, mag(own[i]/power[part.cells[i]] - 1));
    }
    c.checkBelow
    (
        "in parallel: power of defects", returnReduce(powers, maxOp<scalar>()),
        1e-10
    );
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
    checkForced(c, "cubic flow, driven", wordList());
    checkForced(c, "cubic flow, driven, two tractions given", {"xMin", "xMax"});
    checkUpdate(c);
    checkEdges(c);
    checkSphere(c);
    checkTorque(c);
    checkFree(c);
    return c.finish();
}
