/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestElastic

Description
    Checks of the elastic operator and its solvers on every kind of cell:
    linear fields are exact, the derivative is that of the residual, rotation
    makes no stress, beams bend as they should, also where nothing can be
    compressed, and all methods find the same. A cortex and a liquid (skin.C).

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "beam.H"
#include "skin.H"
#include "checks.H"
#include "argList.H"
#include "mathematicalConstants.H"
#include "quaternion.H"

#include <map>

using namespace Foam;
using namespace Foam::fsbi;

typedef constitutiveState::formulation formulation;

static const boundBox cube(point(-1, -1, -1), point(1, 1, 1));

static const string hooke("type linearElastic; E 1; nu 0.3;");

static solidBoundary::kind allGiven(const point&)
{
    return solidBoundary::displacement;
}

static solidBoundary::kind allFree(const point&)
{
    return solidBoundary::traction;
}

//- Displacements at cells and ghosts from a function of the place
static void set(elasticCase& c, const elasticCase::vectorFunction& u)
{
    const elasticStencil& stencil = c.elastic->stencil();
    const vectorField C(stencil.centres());
    const auto put = [&](const label column, const label row)
    {
        const vector value(u(C[column]));
        std::copy_n(value.v_, 3, c.x.begin() + 3*row);
    };
    for (label i = 0; i < stencil.nCells(); ++i)
    {
        put(i, i);
    }
    for (label g = 0; g < stencil.nGhosts(); ++g)
    {
        put(stencil.firstGhost() + g, stencil.nCells() + g);
    }
}


static scalar maxOf(const scalarList& r, const label n)
{
    scalar most = 0;
    for (label i = 0; i < n; ++i)
    {
        most = max(most, mag(r[i]));
    }
    return most;
}


//- A linear field is a solution, whatever is given of it
static void checkLinear(checks& c, const testMeshes& meshes, const word& kind)
{
    const tensor H(0.1, 0.2, -0.3, 0.05, -0.1, 0.2, 0.3, -0.1, 0.15);
    const auto u = [&](const point& p){ return vector((H & p) + vector(1, 2, 3)); };
    autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
    for (const bool free : {false, true})
    {
        elasticCase body(mesh(), hooke, free ? allFree : allGiven);
        const symmTensor sigma(body.material->Cauchy
        (
            body.material->stress(tensor::I + H), tensor::I + H
        ));
        body.give
        (
            u, [&](const point&, const vector& n){ return vector(sigma & n); }
        );
        set(body, u);
        scalarList r(body.x.size());
        body.elastic->residual(body.x.cdata(), body.given, r.begin());
        c.checkClose
        (
            kind + ": linear field, " + (free ? "tractions" : "displacements")
          + " given, residual",
            maxOf(r, r.size()), 0, 1e-12
        );
        const vectorField atFaces(body.elastic->boundaryDisplacement());
        const vectorField atVertices(body.elastic->vertexDisplacement());
        scalar most = 0;
        forAll(atFaces, i)
        {
            most = max
            (
                most,
                mag
                (
                    atFaces[i]
                  - u(mesh->faceCentres()[mesh->nInternalFaces() + i])
                )
            );
        }
        forAll(atVertices, v)
        {
            most = max(most, mag(atVertices[v] - u(mesh->points()[v])));
        }
        c.checkClose(kind + ": its faces and vertices", most, 0, 1e-12);
    }
}


//- The derivative against central differences of the residual
static void checkTangent
(
    checks& c,
    const fvMesh& mesh,
    const string& law,
    const formulation form,
    const bool mixed
)
{
    elasticCase body(mesh, law, elasticCase::heldAndLoaded, form, mixed);
    body.giveLoads();
    body.elastic->state().setStep(2, 0);
    tensorField& prior = body.elastic->state().referenceF();
    for (label v = 0; form != formulation::totalLagrangian && v < prior.size(); ++v)
    {
        prior[v] = tensor(1.1, 0.1, 0, -0.2, 0.9, 0.1, 0, 0.1, 1.05);
    }
    body.elastic->state().oldF() = prior;

    c.checkClose
    (
        "derivative of " + law.substr(5, law.find(';') - 5) + ", "
      + constitutiveState::formulationNames[form] + (mixed ? ", mixed" : ""),
        body.derivativeError(0.02, 1e-5), 0, 1e-7
    );
}


//- What the formulations make of a step F'' after a deformation F': against
//  their definitions, written out for Saint Venant and Kirchhoff's law. With a
//  pressure of its own, the body has the same stress where the pressure is
//  what the volume asks for
static void checkDefinitions(checks& c, const fvMesh& mesh, const bool mixed)
{
    const scalar nu = 0.3, mu = 0.5/(1 + nu), lambda = 2*mu*nu/(1 - 2*nu);
    const auto S = [&](const tensor& F)
    {
        const symmTensor E(0.5*(symm(F.T() & F) - symmTensor::I));
        return tensor((lambda*tr(E))*tensor::I + 2*mu*E);
    };
    const tensor prior(1.1, 0.3, 0, -0.4, 0.9, 0.1, 0, 0.1, 1.05);
    const tensor H(0.05, 0.2, -0.1, -0.2, 0.05, 0.03, 0.1, 0, 0.02);
    const tensor step(tensor::I + H), F(step & prior);
    const auto traceOfStrain = [](const tensor& f){ return 0.5*(magSqr(f) - 3); };
    const std::map<formulation, std::pair<tensor, scalar>> expected
    {
        {
            formulation::updatedLagrangian,
            {(F & S(F) & prior.T())/det(prior), traceOfStrain(F)}
        },
        {
            formulation::slowProcess,
            {
                step & (S(prior) + S(step)),
                traceOfStrain(prior) + traceOfStrain(step)
            }
        },
        {
            formulation::slowProcessTotalStrain,
            {step & S(F), traceOfStrain(F)}
        }
    };
    for (const auto& form : expected)
    {
        elasticCase body
        (
            mesh, "type StVenantKirchhoff; E 1; nu 0.3;", allGiven, form.first,
            mixed
        );
        body.elastic->state().referenceF() = prior;
        body.elastic->state().oldF() = prior;
        set(body, [&](const point& p){ return H & p; });
        const label nGhosts = body.elastic->stencil().nGhosts();
        const label first = 3*(mesh.nCells() + nGhosts);
        for (label i = first; i < body.x.size(); ++i)
        {
            body.x[i] = -lambda*form.second.second;
        }
        scalarList r(body.x.size());
        body.elastic->residual(body.x.cdata(), body.given, r.begin());
        const tensorField stress
        (
            body.elastic->state().stress() - form.second.first
        );
        const std::string name
        (
            constitutiveState::formulationNames[form.first]
          + (mixed ? ", mixed" : "")
        );
        c.checkBelow(name + ": stress on the mesh", max(mag(stress)), 1e-12);
        if (mixed)
        {
            scalar most = 0;
            for (label i = first; i < r.size(); ++i)
            {
                most = max(most, mag(r[i]));
            }
            c.checkBelow(name + ": its volume", most, 1e-12);
        }
        const symmTensor Cauchy
        (
            symm(form.second.first & step.T())/det(step)
        );
        c.checkBelow
        (
            name + ": stress on the deformed body",
            max(mag(body.elastic->state().CauchyStress()() - Cauchy)), 1e-12
        );
    }
}


//- Stress over E of a body turned about an odd axis, in one step or many
static scalar rotationStress
(
    const fvMesh& mesh, const formulation form, const scalar angle
)
{
    elasticCase body
    (
        mesh, "type StVenantKirchhoff; E 1; nu 0.3;", allGiven, form
    );
    const vector axis(normalised(vector(1, 2, 3)));
    const quaternion q(axis, angle);
    set(body, [&](const point& p){ return q.transform(p) - p; });
    scalarList r(body.x.size());
    body.elastic->residual(body.x.cdata(), body.given, r.begin());
    return max(mag(body.elastic->state().CauchyStress()));
}


static void checkRotation(checks& c, const testMeshes& meshes, const word& kind)
{
    autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
    for (const label degrees : {10, 90, 179})
    {
        c.checkClose
        (
            kind + ": stress of a rotation by " + std::to_string(degrees),
            rotationStress
            (
                mesh(), formulation::totalLagrangian,
                degrees*constant::mathematical::pi/180
            ),
            0, 1e-12
        );
    }
}


//- 36 steps of 10 degrees, the mesh moving along
static void checkRotationSteps
(
    checks& c, const testMeshes& meshes, const formulation form
)
{
    autoPtr<fvMesh> mesh(meshes.mesh("tetrahedra", 4));
    elasticCase body
    (
        mesh(), "type StVenantKirchhoff; E 1; nu 0.3;", allGiven, form
    );
    const quaternion q(normalised(vector(1, 2, 3)), constant::mathematical::pi/18);
    scalar most = 0;
    for (label step = 0; step < 36; ++step)
    {
        const auto u = [&](const point& p){ return q.transform(p) - p; };
        body.give(u, [](const point&, const vector&){ return vector::zero; });
        body.x = 0;
        body.solve("tolerance 1e-13;");
        most = max(most, max(mag(body.elastic->state().CauchyStress())));
        mesh->movePoints
        (
            mesh->points() + body.elastic->vertexDisplacement()
        );
        mesh->moving(false);
        body.elastic->endStep();
        body.elastic->update();
    }
    c.checkClose
    (
        constitutiveState::formulationNames[form]
      + ": largest stress over E in 36 steps of 10 degrees",
        most, 0, 1e-10
    );
}


static void checkBending(checks& c)
{
    // deflection over Timoshenko's, and iterations, at most
    const auto bends =
        [&](const string& entries, const scalar bound, const label iterations)
        {
            beam b(entries);
            b.solve();
            c.check(b.name() + ": converged", b.report.converged);
            c.checkClose(b.name() + ": deflection", b.ratio(), 1, bound);
            c.check
            (
                b.name() + ": iterations", b.report.iterations <= iterations,
                std::to_string(b.report.iterations)
            );
        };
    bends("kind hexahedra; across 8; length 5;", 0.02, 50);
    bends("kind hexahedra; across 4; length 40;", 0.03, 75);
    bends("kind tetrahedra; across 8; length 5;", 0.02, 55);
    bends("kind tetrahedra; across 4; length 20;", 0.05, 75);
    bends("kind polyhedra; across 4; length 5;", 0.1, 85);
    bends("kind hexahedra; across 8; length 5; nu 0.49;", 0.03, 80);
    bends("kind hexahedra; across 8; length 5; nu 0.499;", 0.03, 80);
    bends("kind tetrahedra; across 8; length 5; nu 0.499;", 0.03, 80);
}


//- Both methods find the same deflection
static void checkMethods(checks& c)
{
    for (const string kind : {"hexahedra", "tetrahedra"})
    {
        const string entries("kind " + kind + "; across 3; length 2;");
        beam coupled(entries), swept(entries + "solid { method segregated; }");
        coupled.solve();
        swept.solve();
        c.check(kind + ", segregated: converged", swept.report.converged);
        c.checkClose
        (
            kind + ", segregated: deflection over that of NewtonKrylov",
            swept.deflection/coupled.deflection, 1, 1e-6
        );
    }
}


//- One line of a study: what it cost and how good it is
static void printStudy(const string& entries)
{
    beam b(entries);
    b.solve();
    Info<< "cells,newton,krylov,residual,converged,ratio,displacementError,"
        << "stressError,seconds" << nl
        << b.cells << ',' << b.report.corrections << ','
        << b.report.iterations << ',' << b.report.residual << ','
        << b.report.converged << ',' << b.ratio() << ','
        << b.displacementError << ',' << b.stressError << ','
        << b.seconds << endl;
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption
    (
        "beam", "entries", "only solve for one beam (see beam.H), print a csv"
    );
    argList args(argc, argv);
    petscSession petsc;
    const untrapped scope;
    if (args.found("beam"))
    {
        printStudy(args["beam"]);
        return 0;
    }

    checks c;
    const testMeshes meshes(cube);
    for (const word& kind : testMeshes::kinds())
    {
        checkLinear(c, meshes, kind);
        checkRotation(c, meshes, kind);
    }
    autoPtr<fvMesh> mesh(meshes.mesh("tetrahedra", 3));
    for
    (
        const word law :
        {
            "StVenantKirchhoff", "neoHookean", "MooneyRivlin",
            "corotationalElastic"
        }
    )
    {
        for (const bool mixed : {false, true})
        {
            const string entries
            (
                "type " + law + "; E 1; nu 0.4; viscosity 0.3;"
            );
            for
            (
                const auto form :
                {
                    formulation::totalLagrangian,
                    formulation::updatedLagrangian,
                    formulation::slowProcess,
                    formulation::slowProcessTotalStrain
                }
            )
            {
                checkTangent(c, mesh(), entries, form, mixed);
            }
        }
    }
    checkTangent
    (
        c, mesh(), "type linearElastic; E 1; nu 0.4; viscosity 0.3;",
        formulation::totalLagrangian, true
    );
    checkSkin(c, mesh());
    checkDefinitions(c, mesh(), false);
    checkDefinitions(c, mesh(), true);
    checkRotationSteps(c, meshes, formulation::updatedLagrangian);
    checkRotationSteps(c, meshes, formulation::slowProcess);
    checkBending(c);
    checkMethods(c);
    return c.finish();
}
