/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestElastic

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "elasticCase.H"
#include "checks.H"
#include "testMeshes.H"
#include "argList.H"
#include "clockTime.H"

using namespace Foam;
using namespace Foam::fsbi;

static void beam(const word& kind, const label across, const scalar L, const string& law, const bool mixed, const string& controls)
{
    const boundBox box(point(0, -0.5, -0.5), point(L, 0.5, 0.5));
    const testMeshes meshes(box);
    autoPtr<fvMesh> mesh(meshes.mesh(kind, label(across*L + 0.5)));
    clockTime clock;
    elasticCase c
    (
        mesh(), law,
        [&](const point& p){ return p.x() < 1e-9 ? solidBoundary::displacement : solidBoundary::traction; },
        elasticOperator::formulation::totalLagrangian, mixed
    );
    const scalar tau = 1e-6;
    c.give
    (
        [](const point& p){ return vector::zero; },
        [&](const point& p, const vector& n){ return p.x() > L - 1e-9 ? vector(0, tau, 0) : vector::zero; }
    );
    const scalar setup = clock.timeIncrement();
    c.solve(controls);
    const scalar seconds = clock.timeIncrement();
    scalar tip = 0, V = 0;
    const vectorField ub(c.elastic->boundaryDisplacement());
    forAll(ub, i)
    {
        const label f = mesh->nInternalFaces() + i;
        if (mesh->faceCentres()[f].x() > L - 1e-9)
        {
            const scalar A = mag(mesh->faceAreas()[f]);
            tip += A*ub[i].y(); V += A;
        }
    }
    tip /= V;
    const scalar E = c.material->E(), G = c.material->mu(), nu = c.material->nu();
    const scalar k = 10*(1 + nu)/(12 + 11*nu);
    const scalar theory = tau*(pow3(L)/(3*E/12) + L/(k*G));
    Info<< kind << " across " << across << " L " << L << " nu " << nu << " mixed " << mixed << " cells " << mesh->nCells()
        << " its " << c.report.iterations << " newton " << c.report.corrections << " res " << c.report.residual
        << " conv " << c.report.converged << " tip-1 " << tip/theory - 1 << " setup " << setup << " solve " << seconds << " " << c.report.failure.c_str() << endl;
}

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addArgument("kind"); argList::addArgument("across"); argList::addArgument("L"); argList::addArgument("law"); argList::addArgument("mixed"); argList::addArgument("controls");
    argList args(argc, argv);
    petscSession petsc;
    const untrapped scope;
    beam(word(args[1]), args.get<label>(2), args.get<scalar>(3), args[4], args.get<bool>(5), args[6]);
    return 0;
}
