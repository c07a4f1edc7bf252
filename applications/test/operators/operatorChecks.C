/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "operatorChecks.H"
#include "testMeshes.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- A linear flow without divergence, at constant pressure; none of it changes
//  along x if it is to be periodic
static exactFlow linearFlow(const bool periodic)
{
    tensor g(0.3, 0.7, -0.4, 1.1, -0.8, 0.2, -0.6, 0.9, 0.5);
    if (periodic)
    {
        g = tensor(0, 0, 0, 1.1, -0.8, 0.2, -0.6, 0.9, 0.8);
    }
    exactFlow flow;
    flow.gradU = [=](const point&) { return g; };
    flow.u = [=](const point& x) { return vector(0.2, -0.5, 0.1) + (x & g); };
    flow.p = [](const point&) { return 2.3; };
    return flow;
}


void checkVertices
(
    checks& c, const word& name, const appliedOperator& a, const bool periodic
)
{
    const fvMesh& mesh = a.mesh;
    const meshStencil& s = a.stokes.stencil();
    scalarList phi(mesh.nCells() + s.halo().size());
    const vector slope(periodic ? 0 : 1.3, -0.7, 2.1);
    forAll(mesh.cellCentres(), i)
    {
        phi[i] = 0.4 + (slope & mesh.cellCentres()[i]);
    }
    s.halo().fill(phi.data(), 1);
    scalarField sum(mesh.nPoints(), Zero);
    forAll(sum, v)
    {
        for (label i = s.vertexStart()[v]; i < s.vertexStart()[v + 1]; ++i)
        {
            sum[v] += s.vertexWeight()[i]*phi[s.vertexCell()[i]];
        }
    }
    syncTools::syncPointList(mesh, sum, plusEqOp<scalar>(), scalar(0));
    c.checkBelow
    (
        name + ": vertex weights reproduce a linear field",
        gMax(mag(sum - 0.4 - (slope & mesh.points()))), 1e-12
    );
}


void checkLinear(checks& c, const word& name, const fvMesh& mesh)
{
    const bool periodic = name == "cyclic";
    // walls that are not plane
    const bool warped = name == "polyhedra around a sphere";
    const exactFlow flow(linearFlow(periodic));
    appliedOperator a(mesh, mu);
    a.apply(flow);
    checkVertices(c, name, a, periodic);

    const tensorField grad(a.stokes.velocityGradients());
    c.checkBelow
    (
        name + ": gradients of a linear velocity",
        max(mag(grad - flow.gradU(Zero))), 1e-11
    );
    // rows over the area of a cell's face
    const scalar S = Foam::pow(gAverage(mesh.cellVolumes()), 2.0/3.0);
    c.checkBelow
    (
        name + ": linear velocity, momentum rows", a.largest(true)/S, 1e-11
    );
    c.checkBelow
    (
        name + ": linear velocity, continuity rows", a.largest(false)/S,
        warped ? 0.3 : 1e-11
    );
    c.checkBelow
    (
        name + ": traction of a linear velocity", a.tractionError(flow),
        warped ? 5e-2 : 1e-11
    );
    if (!periodic)
    {
        appliedOperator open(mesh, mu, {"xMin", "xMax"});
        open.apply(flow);
        c.checkBelow
        (
            name + ": open ends, momentum rows", open.largest(true)/S, 1e-11
        );
        c.checkBelow
        (
            name + ": open ends, continuity rows", open.largest(false)/S,
            warped ? 0.3 : 1e-11
        );
    }
}


void checkRotation(checks& c, const word& name, const fvMesh& mesh)
{
    // around x only, if it is to be periodic
    const vector omega(0.3, name == "cyclic" ? 0 : -0.9, name == "cyclic" ? 0 : 0.5);
    exactFlow flow;
    flow.u = [=](const point& x) { return vector(1, 2, 3) + (omega ^ x); };
    flow.gradU = [=](const point&) { return -(*omega); };
    flow.p = [](const point&) { return 0; };
    appliedOperator a(mesh, mu);
    a.apply(flow);
    vector torque(Zero);
    forAll(a.traction, i)
    {
        torque +=
            mesh.faceCentres()[mesh.nInternalFaces() + i] ^ a.traction[i];
    }
    c.checkBelow
    (
        name + ": a rigid rotation has no traction",
        max(mag(a.traction))/gMax(mag(mesh.faceAreas())), 1e-11
    );
    c.checkBelow(name + ": a rigid rotation has no torque", mag(torque), 1e-11);
}


//- Anything at all in the cells and on the boundary
static void disturb(appliedOperator& a, const label seed)
{
    forAll(a.x, i)
    {
        a.x[i] = noise(i + seed);
    }
    forAll(a.b.faces, i)
    {
        a.b.faces[i] = vector(noise(5*i + seed), noise(7*i), noise(9*i));
    }
    forAll(a.b.vertices, i)
    {
        // the same on both sides of a periodic mesh
        const point& x = a.stokes.wallPoints()[i];
        const label key = label(1e4*(3*x.y() + 7*x.z())) + seed;
        a.b.vertices[i] = vector(noise(key), noise(3*key), noise(5*key));
    }
    a.apply();
}


void checkBalances
(
    checks& c, const word& name, const fvMesh& mesh, const wordList& open
)
{
    appliedOperator a(mesh, mu, open);
    disturb(a, 3);

    vector rows(Zero), forces(Zero);
    scalar fluxes = 0, given = 0, scale = 0;
    for (label i = 0; i < mesh.nCells(); ++i)
    {
        rows += vector(a.r[4*i], a.r[4*i + 1], a.r[4*i + 2]);
        fluxes += a.r[4*i + 3];
    }
    const tensorField grad(a.stokes.velocityGradients());
    forAll(a.traction, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const vector& S = mesh.faceAreas()[facei];
        if (a.uncoupled(i))
        {
            forces += a.traction[i];
            if (!a.stokes.velocityGiven()[i])
            {
                // rows have the stress without its transposed part, which
                // around given velocities adds up to nothing
                forces -= mu*(grad[mesh.faceOwner()[facei]] & S);
            }
            given += a.b.faces[i] & S;
            scale += mag(a.traction[i]);
        }
    }
    if (open.empty())
    {
        c.checkBelow
        (
            name + ": sum of momentum rows is minus the boundary's force",
            mag(rows + forces)/scale, 1e-12
        );
        c.checkClose
        (
            name + ": sum of continuity rows is the net flux",
            fluxes, given, 1e-9
        );
    }

    appliedOperator b(mesh, mu, open), both(mesh, mu, open);
    disturb(b, 50);
    forAll(both.x, i)
    {
        both.x[i] = a.x[i] + 2*b.x[i];
    }
    both.b.faces = a.b.faces + 2*b.b.faces;
    both.b.vertices = a.b.vertices + 2*b.b.vertices;
    both.apply();
    scalar error = 0;
    forAll(both.r, i)
    {
        error = max(error, mag(both.r[i] - a.r[i] - 2*b.r[i]));
    }
    c.checkBelow
    (
        name + (open.size() ? ": linear, open ends" : ": linear"),
        error/max(both.largest(true), both.largest(false)), 1e-12
    );
}


void checkWallWeights(checks& c, const word& name, const fvMesh& mesh)
{
    const meshStencil stencil(mesh);
    scalar low = GREAT, high = 0, mean = 0;
    label n = 0;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for
        (
            label i = pp.start(); !pp.coupled() && i < pp.start() + pp.size();
            ++i
        )
        {
            const scalar w = stencil.wallWeight()[i - mesh.nInternalFaces()];
            low = min(low, w);
            high = max(high, w);
            mean += w;
            ++n;
        }
    }
    mean /= n;
    Info<< "    " << name << ": wall weights " << low << " to " << high
        << ", mean " << mean << endl;
    if (name == "hexahedra")
    {
        c.checkClose(name + ": wall weights", low, 2, 1e-9);
        c.checkClose(name + ": wall weights, largest", high, 2, 1e-9);
    }
    else
    {
        c.check
        (
            name + ": wall weights in bounds", low >= 1.2 && high <= 3,
            Foam::name(low) + " to " + Foam::name(high)
        );
        if (name.find("tetra") == 0)
        {
            c.check
            (
                name + ": mean wall weight", mean > 1.3 && mean < 1.8,
                Foam::name(mean)
            );
        }
    }
}


void checkUpdate(checks& c, const word& name, fvMesh& mesh)
{
    appliedOperator moved(mesh, mu);
    pointField points(mesh.points());
    points +=
        0.1*(points & tensor(1, 0.3, 0, 0, -0.5, 0.2, 0.4, 0, 0.7));
    mesh.movePoints(points);
    mesh.moving(false);
    moved.stokes.update();
    disturb(moved, 1);
    appliedOperator fresh(mesh, mu);
    disturb(fresh, 1);
    scalar error = 0;
    forAll(fresh.r, i)
    {
        error = max(error, mag(fresh.r[i] - moved.r[i]));
    }
    c.checkBelow(name + ": a moved mesh is seen", error, 1e-14);
}

} // End namespace fsbi
} // End namespace Foam
