/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestElasticOrders

Description
    Orders of convergence of the elastic operator at large strain, through the
    solver, on every kind of cell (manufacturedCube). Without options: checks
    on small meshes, and of homogeneous states against closed forms.

Usage
    \code
    fsbiTestElasticOrders -study "hexahedra (8 16 32)" > orders.csv
    \endcode
    prints the errors of all laws and boundaries on these meshes;
    -where adds lines that say where in the cube the errors are.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "manufacturedCube.H"
#include "homogeneousCube.H"
#include "references.H"
#include "testMeshes.H"
#include "checks.H"
#include "argList.H"

using namespace Foam;
using namespace Foam::fsbi;

struct namedLaw
{
    const char* name;
    const char* entries;

    //- Of the amplitude: where nu is nearly 0.5, 0.03 is not solved
    scalar part;
};

static const namedLaw laws[] =
{
    {"StVenantKirchhoff", "type StVenantKirchhoff; E 1; nu 0.3;", 1},
    {"neoHookean", "type neoHookean; E 1; nu 0.3;", 1},
    {"nearlyIncompressible", "type neoHookean; E 1; nu 0.49;", 0.1}
};


// With tractions, 0.03 has more than one discrete solution
static scalar amplitude(const namedLaw& law, const bool tractions)
{
    return law.part*(tractions ? 0.01 : 0.03);
}


static void printRow
(
    const word& kind, const char* law, const bool tractions, const label level,
    const manufacturedCube& cube
)
{
    printf
    (
        "%s,%s,%s,%d,%d,%.5g,%.4e,%.4e,%.4e,%d,%d,%.2f,%d\n",
        kind.c_str(), law, tractions ? "tractions" : "displacements",
        int(level), int(cube.cells), cube.h(), cube.displacement,
        cube.cellStress, cube.vertexStress, int(cube.report.corrections),
        int(cube.report.iterations), cube.seconds, int(cube.report.converged)
    );
    fflush(stdout);
}


static void study
(
    const testMeshes& meshes, const word& kind, const labelList& levels,
    const label order, const bool where
)
{
    printf
    (
        "kind,law,boundary,level,cells,h,displacement,cellStress,vertexStress,"
        "newton,krylov,seconds,converged\n"
    );
    forAll(levels, i)
    {
        autoPtr<fvMesh> mesh(meshes.mesh(kind, levels[i]));
        for (const namedLaw& law : laws)
        {
            for (const bool tractions : {false, true})
            {
                const manufacturedCube cube
                (
                    mesh(), law.entries, tractions, amplitude(law, tractions),
                    order
                );
                printRow(kind, law.name, tractions, i + 1, cube);
                printf("%s", where ? cube.where.c_str() : "");
            }
        }
    }
}


//- Orders of displacement, stress of cells and of vertices on two meshes
static void checkOrders
(
    checks& c, const testMeshes& meshes, const word& kind,
    const labelPair& levels, const vector& lowest
)
{
    autoPtr<fvMesh> first(meshes.mesh(kind, levels.first()));
    autoPtr<fvMesh> second(meshes.mesh(kind, levels.second()));
    for (const bool tractions : {false, true})
    {
        const namedLaw& law = laws[tractions];
        const scalar A = amplitude(law, tractions);
        const manufacturedCube coarse(first(), law.entries, tractions, A);
        const manufacturedCube fine(second(), law.entries, tractions, A);
        const std::string is
        (
            kind + ", " + law.name + (tractions ? ", tractions: " : ": ")
        );
        const auto check = [&](const char* what, scalar a, scalar b, scalar bound)
        {
            const scalar order = std::log(a/b)/std::log(coarse.h()/fine.h());
            c.check(is + what, order >= bound, "order " + Foam::name(order));
        };
        c.check
        (
            is + "converged", coarse.report.converged && fine.report.converged
        );
        check("displacement", coarse.displacement, fine.displacement, lowest[0]);
        check("stress of cells", coarse.cellStress, fine.cellStress, lowest[1]);
        check
        (
            "stress of vertices", coarse.vertexStress, fine.vertexStress,
            lowest[2]
        );
    }
}


static void checkHomogeneous
(
    checks& c, const std::string& name, const homogeneousCube& cube,
    const vector& force
)
{
    c.check(name + "converged", cube.converged);
    c.checkClose(name + "displacement", cube.displacement, 0, 1e-8);
    c.checkClose(name + "stress", cube.stress, 0, 1e-8);
    c.checkClose(name + "force", mag(cube.force - force), 0, 1e-8);
}


static void checkClosedForms
(
    checks& c, const testMeshes& meshes, const word& kind
)
{
    autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
    for (const references::bar& r : references::bars)
    {
        // at a stretch of 0.577 nothing resists: the slope is zero
        if (r.slope < 0.1)
        {
            continue;
        }
        const scalar lateral = Foam::sqrt(1 - r.nu*(sqr(r.stretch) - 1));
        const tensor F(r.stretch, 0, 0, 0, lateral, 0, 0, 0, lateral);
        const tensor P(r.P, 0, 0, 0, 0, 0, 0, 0, 0);
        checkHomogeneous
        (
            c,
            kind + ", bar, nu " + Foam::name(r.nu) + ", stretch " + Foam::name(r.stretch)
          + ": ",
            homogeneousCube(mesh(), r.nu, F, P, vector::X), P & vector(1, 0, 0)
        );
    }
    for (const references::shear& r : references::shears)
    {
        const tensor F(1, r.k, 0, 0, 1, 0, 0, 0, 1);
        const tensor P(r.P11, r.P12, 0, r.P21, r.P22, 0, 0, 0, r.P33);
        checkHomogeneous
        (
            c, kind + ", shear, nu " + Foam::name(r.nu) + ", " + Foam::name(r.k) + ": ",
            homogeneousCube(mesh(), r.nu, F, P, vector::Y), P & vector(0, 1, 0)
        );
    }
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption("study", "\"kind (levels)\"", "print a table of errors");
    argList::addOption("order", "label", "2 (default) or 4");
    argList::addBoolOption("where", "with the errors by region");
    argList args(argc, argv);
    petscSession petsc;
    const untrapped scope;

    const testMeshes meshes(boundBox(point::zero, point::one));
    if (args.found("study"))
    {
        IStringStream entries(args["study"]);
        const word kind(entries);
        study
        (
            meshes, kind, labelList(entries),
            args.getOrDefault<label>("order", 2), args.found("where")
        );
        return 0;
    }
    checks c;
    checkOrders(c, meshes, "hexahedra", {6, 12}, {1.9, 1.9, 1.9});
    checkOrders(c, meshes, "perturbed", {6, 12}, {1.9, 1.5, 1});
    checkOrders(c, meshes, "tetrahedra", {5, 8}, {1.9, 1.5, 1.5});
    checkOrders(c, meshes, "polyhedra", {4, 6}, {1.9, 1, 1});
    checkClosedForms(c, meshes, "tetrahedra");
    checkClosedForms(c, meshes, "perturbed");
    return c.finish();
}
