/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestOperators

Description
    Checks of the mesh stencil and of the Stokes operator against exact flows
    on every kind of cell. Run on several processors (mpirun -np 2
    fsbiTestOperators -parallel) it compares with one processor.

\*---------------------------------------------------------------------------*/

#include "operatorChecks.H"
#include "testMeshes.H"
#include "meshDistribution.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

//- Poiseuille flow between z = -1 and 1
static exactFlow channelFlow()
{
    exactFlow flow;
    flow.u = [](const point& x) { return vector(1 - sqr(x.z()), 0, 0); };
    flow.gradU = [](const point& x)
    {
        return tensor(0, 0, 0, 0, 0, 0, -2*x.z(), 0, 0);
    };
    flow.p = [](const point& x) { return -2*mu*x.x(); };
    return flow;
}


static void checkOrders(checks& c, const testMeshes& meshes)
{
    // at least: order of force on the walls, of the momentum rows' mean
    const exactFlow flow(channelFlow());
    for (const word& kind : testMeshes::kinds())
    {
        scalar error[2], rows[2], h[2];
        for (label level = 0; level < 2; ++level)
        {
            autoPtr<fvMesh> mesh(meshes.mesh(kind, level ? 16 : 8));
            appliedOperator a(mesh(), mu);
            a.apply(flow);
            scalar sum = 0, area = 0;
            const polyPatch& walls = mesh->boundaryMesh()["walls"];
            forAll(walls, i)
            {
                const vector& S = mesh->faceAreas()[walls.start() + i];
                const vector exact
                (
                    flow.traction(walls.faceCentres()[i], S, mu)
                );
                const label at = walls.start() + i - mesh->nInternalFaces();
                sum += magSqr(a.traction[at] - exact)/mag(S);
                area += mag(S);
            }
            error[level] = Foam::sqrt(sum/area)/mu;
            rows[level] = mag(a.momentumError())/mu;
            h[level] = 1/Foam::cbrt(scalar(mesh->nCells()));
        }
        const scalar spacing = Foam::log(h[0]/h[1]);
        const scalar order = Foam::log(error[0]/error[1])/spacing;
        Info<< "    " << kind << ": Poiseuille, wall traction error "
            << error[0] << ' ' << error[1] << ", order " << order
            << "; rows over volume " << rows[0] << ' ' << rows[1] << endl;
        c.check
        (
            kind + ": order of the wall traction", order > 0.9 || error[1] < 1e-9,
            Foam::name(order)
        );
    }
}


static void checkSerial(checks& c)
{
    const testMeshes cube(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    wordList kinds(testMeshes::kinds());
    kinds.append("cyclic");
    for (const word& kind : kinds)
    {
        autoPtr<fvMesh> mesh(cube.mesh(kind, 6));
        c.check
        (
            kind + ": OpenFOAM's checks of the mesh",
            !mesh->checkTopology(false)
         && (kind != "hexahedra" || !mesh->checkGeometry(false))
        );
        checkLinear(c, kind, mesh());
        checkRotation(c, kind, mesh());
        checkBalances(c, kind, mesh(), wordList());
        if (kind != "cyclic")
        {
            checkBalances(c, kind, mesh(), {"xMin", "xMax"});
        }
        checkWallWeights(c, kind, mesh());
        checkUpdate(c, kind, mesh());
    }

    const testMeshes wide(boundBox(point(-3, -3, -3), point(3, 3, 3)));
    for (const word kind : {"tetrahedra", "polyhedra"})
    {
        autoPtr<fvMesh> mesh(wide.mesh(kind, 6, 0.35));
        const word name(kind + " around a sphere");
        checkLinear(c, name, mesh());
        checkRotation(c, name, mesh());
        checkBalances(c, name, mesh(), wordList());
        checkWallWeights(c, name, mesh());
    }
    checkOrders(c, cube);
}


//- The same field on one processor and on all
static void checkParallel(checks& c)
{
    const testMeshes cube(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    wordList kinds(testMeshes::kinds());
    kinds.append("cyclic");     // cut across its period
    for (const word& kind : kinds)
    {
        const wordList open(kind == "cyclic" ? 0 : 1, word("xMax"));
        meshLists whole;
        labelList ranks;
        scalarList x, r;
        tensorField grad;
        vectorField traction;
        const exactFlow flow(channelFlow());
        const auto setState = [](appliedOperator& a, const UList<scalar>& x)
        {
            // random in the cells, smooth on the boundary
            a.apply(channelFlow());
            forAll(a.x, i)
            {
                a.x[i] += x[i];
            }
            a.apply();
        };
        if (Pstream::master())
        {
            Pstream::parRun() = false;
            whole = cube.lists(kind, 6);
            ranks = meshDistribution::bisect(whole, 2);
            autoPtr<fvMesh> mesh(cube.scaled(whole, 1));
            appliedOperator a(mesh(), mu, open);
            x.setSize(a.x.size());
            forAll(x, i)
            {
                x[i] = noise(i);
            }
            setState(a, x);
            r = a.r;
            grad = a.stokes.velocityGradients();
            traction = a.traction;
            Pstream::parRun() = true;
        }
        Pstream::scatter(x);
        Pstream::scatter(r);
        Pstream::scatter(grad);
        Pstream::scatter(traction);

        const meshDistribution part(whole, ranks);
        autoPtr<fvMesh> mesh(cube.scaled(part.mesh, 1));
        appliedOperator a(mesh(), mu, open);
        checkVertices(c, kind + " in parallel", a, kind == "cyclic");
        scalarList own(a.x.size());
        forAll(own, i)
        {
            own[i] = x[4*part.cells[i/4] + i % 4];
        }
        setState(a, own);
        const tensorField ownGrad(a.stokes.velocityGradients());

        scalar rows = 0, gradients = 0, tractions = 0;
        forAll(own, i)
        {
            rows = max(rows, mag(a.r[i] - r[4*part.cells[i/4] + i % 4]));
        }
        forAll(ownGrad, i)
        {
            gradients =
                max(gradients, mag(ownGrad[i] - grad[part.cells[i]]));
        }
        label nWhole = part.wholePatchStarts[0];
        forAll(a.traction, i)
        {
            if (a.uncoupled(i))
            {
                const label facei = part.faces[mesh->nInternalFaces() + i];
                tractions = max
                (
                    tractions, mag(a.traction[i] - traction[facei - nWhole])
                );
            }
        }
        const auto worst = [](scalar v)
        {
            return returnReduce(v, maxOp<scalar>());
        };
        c.checkBelow(kind + " in parallel: residual", worst(rows), 1e-10);
        c.checkBelow(kind + " in parallel: gradients", worst(gradients), 1e-10);
        c.checkBelow(kind + " in parallel: traction", worst(tractions), 1e-10);
    }
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    checks c;
    if (Pstream::parRun())
    {
        checkParallel(c);
    }
    else
    {
        checkSerial(c);
    }
    return c.finish();
}
