/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestSolidConditions

Description
    Checks of the boundary conditions of solids: forces and their sums, on one
    processor and (mpirun -np 2 fsbiTestSolidConditions -parallel) on several,
    rigid rotation, entries in time, writing and reading, refusal of mistakes.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "testMeshes.H"
#include "meshDistribution.H"
#include "tractionCondition.H"
#include "pointwiseValue.H"
#include "volFields.H"
#include "surfaceFields.H"
#include "argList.H"
#include "OStringStream.H"
#include "mathematicalConstants.H"

using namespace Foam;
using namespace Foam::fsbi;
using constant::mathematical::pi;

//- A displacement field whose patch xMax has a condition, the others none
static autoPtr<volVectorField> displacement
(
    const fvMesh& mesh, const std::string& condition
)
{
    const dictionary dict
    {
        IStringStream
        (
            "dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0);"
            "boundaryField { \".*\" { type zeroGradient; }"
            "\"proc.*\" { type processor; } xMax { " + condition + " } }"
        )()
    };
    const IOobject io
    (
        "D", mesh.time().timeName(), mesh, IOobject::NO_READ,
        IOobject::NO_WRITE, false
    );
    return autoPtr<volVectorField>::New(io, mesh, dict);
}


static const fvPatchVectorField& xMax(const volVectorField& D)
{
    return D.boundaryField()[D.mesh().boundary().findPatchID("xMax")];
}


static const tractionCondition& load(const volVectorField& D)
{
    return refCast<const tractionCondition>(xMax(D));
}


static vector total(const volVectorField& D)
{
    return gSum(load(D).dead()*load(D).patch().magSf());
}


static void checkTraction(checks& c, const fvMesh& mesh)
{
    const auto free = displacement(mesh, "type traction;");
    c.checkBelow
    (
        "a traction without entries is a free surface",
        gMax(mag(load(*free).dead())) + gMax(mag(load(*free).pressure()))
      + gMax(mag(load(*free).follower())), 0
    );

    const auto D = displacement
    (
        mesh, "type traction; traction (1 2 3); pressure 5; follower (0 7 0);"
    );
    const tractionCondition& t = load(*D);
    const auto differs = [](const vectorField& f, const vector& v)
    {
        return gMax(mag(f - v));
    };
    c.checkBelow("traction: dead", differs(t.dead(), vector(1, 2, 3)), 0);
    c.checkBelow("traction: pressure", gMax(mag(t.pressure() - 5.0)), 0);
    c.checkBelow("traction: follower", differs(t.follower(), vector(0, 7, 0)), 0);
    // on the end x = max the normal is (1 0 0)
    c.checkBelow
    (
        "traction: all of them, on a fluid's surface",
        differs(t.traction(), vector(1 - 5, 2 + 7, 3)), 1e-14
    );
}


static void checkTime(checks& c, const fvMesh& mesh)
{
    Time& clock = const_cast<Time&>(mesh.time());
    const auto D = displacement
    (
        mesh,
        "type traction; traction table ((0 (0 0 0)) (4 (8 0 0)));"
        "pressure sine; pressureCoeffs { frequency 0.125; amplitude 3;"
        "scale 1; level 0; }"
    );
    clock.setTime(2.0, 2);
    c.checkClose("a table in time", gMax(load(*D).dead()().component(0)), 4, 1e-14);
    c.checkClose("a sine in time", gMax(load(*D).pressure()), 3, 1e-12);
    clock.setTime(0.0, 0);
}


static void checkForce(checks& c, const word& name, const fvMesh& mesh)
{
    const vector force(1, -2, 90);
    const auto whole = displacement(mesh, "type patchForce; force (1 -2 90);");
    c.checkBelow
    (
        name + ": force on the whole patch", mag(total(*whole) - force), 1e-12
    );
    const vectorField t(load(*whole).dead());
    c.checkBelow(name + ": it is even", gMax(mag(t - gMax(t))), 1e-12);

    const auto spot = displacement
    (
        mesh,
        "type patchForce; force (1 -2 90); centre (1 0.2 0.1); radius 0.7;"
    );
    c.checkBelow
    (
        name + ": force around a point", mag(total(*spot) - force), 1e-12
    );
    const vectorField local(load(*spot).dead());
    const vectorField& x = load(*spot).patch().Cf();
    scalar outside = 0;
    forAll(x, i)
    {
        if (mag(x[i] - point(1, 0.2, 0.1)) > 0.7)
        {
            outside = max(outside, mag(local[i]));
        }
    }
    c.checkBelow
    (
        name + ": none outside the radius", returnReduce(outside, maxOp<scalar>()),
        0
    );
    const point centre
    (
        gSum((local & force)*load(*spot).patch().magSf()*x)/magSqr(force)
    );
    c.checkBelow
    (
        name + ": it acts near the point", mag(centre - point(1, 0.2, 0.1)), 0.1
    );
}


static void checkRotation(checks& c, const fvMesh& mesh)
{
    auto D = displacement
    (
        mesh,
        "type prescribedRotation; axis (0 0 2); angle table ((0 0) (1 90));"
        "origin (1 1 5); translation table ((0 (0 0 0)) (1 (0 0 4)));"
    );
    const auto& rotation = dynamic_cast<const pointwiseValue&>(xMax(*D));
    const pointField x({point(1, 1, 5), point(3, 1, 0), point(1, 4, 2)});
    const vectorField quarter(rotation.valueAt(x, 1));
    c.checkBelow
    (
        "rotation: of the origin", mag(quarter[0] - vector(0, 0, 4)), 1e-14
    );
    c.checkBelow
    (
        "rotation: (2 0 0) by 90 degrees about z",
        mag(quarter[1] - vector(-2, 2, 4)), 1e-14
    );

    const scalar time = 0.37;
    const pointField moved(x + rotation.valueAt(x, time)());
    scalar worst = 0;
    forAll(x, i)
    {
        const label j = (i + 1) % x.size();
        worst = max
        (
            worst, mag(mag(moved[i] - moved[j]) - mag(x[i] - x[j]))
        );
    }
    c.checkBelow("rotation: keeps lengths", worst, 1e-14);
    const auto tiny = displacement
    (
        mesh, "type prescribedRotation; axis (0 0 1); angle 1e-9;"
    );
    c.checkClose
    (
        "rotation: a tiny angle loses no digits",
        dynamic_cast<const pointwiseValue&>(xMax(*tiny)).valueAt(x, 0)()[1].y(),
        3e-9*pi/180, 1e-11
    );
    c.checkBelow
    (
        "rotation: the patch has the value at its faces, at the start none",
        gMax(mag(xMax(*D))), 0
    );

    Time& clock = const_cast<Time&>(mesh.time());
    clock.setTime(1.0, 1);
    D->boundaryFieldRef().evaluate();
    c.checkBelow
    (
        "rotation: the patch follows the time",
        gMax(mag(xMax(*D) - rotation.valueAt(xMax(*D).patch().Cf(), 1)())), 1e-14
    );
    clock.setTime(0.0, 0);
}


//- What is written reads as the same condition
static void checkWritten
(
    checks& c, const fvMesh& mesh, const std::string& condition
)
{
    const auto written = [](const volVectorField& D)
    {
        OStringStream os;
        xMax(D).write(os);
        return std::string(os.str());
    };
    const std::string once = written(displacement(mesh, condition)());
    const std::string again = written(displacement(mesh, once)());
    c.check
    (
        xMax(displacement(mesh, condition)()).type() + ": written and read",
        once == again, once + " is not " + again
    );
    // a copy is what solvers keep of a field
    const volVectorField copy("copy", displacement(mesh, condition)());
    c.check
    (
        xMax(copy).type() + ": copied", written(copy) == once, written(copy)
    );
}


static void checkErrors(checks& c, const fvMesh& mesh)
{
    const auto refused = [&]
    (
        const std::string& what, const std::string& condition,
        const std::string& text
    )
    {
        c.checkFatal(what, [&]{ displacement(mesh, condition); }, text);
    };
    refused
    (
        "an unknown keyword of traction", "type traction; presure 1;", "presure"
    );
    refused("a force without a force", "type patchForce;", "force");
    refused
    (
        "a centre without radius",
        "type patchForce; force (1 0 0); centre (0 0 0);", "radius"
    );
    refused
    (
        "a radius without centre",
        "type patchForce; force (1 0 0); radius 1;", "centre"
    );
    refused
    (
        "a negative radius",
        "type patchForce; force (1 0 0); centre (0 0 0); radius -1;",
        "'radius' must be above zero"
    );
    c.checkFatal
    (
        "a radius that holds no face",
        [&]
        {
            load
            (
                displacement
                (
                    mesh,
                    "type patchForce; force (1 0 0); centre (9 0 0); radius 1;"
                )()
            ).dead();
        },
        "nearest face"
    );
    refused
    (
        "a rotation without axis", "type prescribedRotation; angle 3;", "axis"
    );
    refused
    (
        "an axis without length",
        "type prescribedRotation; angle 3; axis (0 0 0);", "no length"
    );
    refused
    (
        "a rotation without angle", "type prescribedRotation; axis (1 0 0);",
        "angle"
    );
}


static void checkSerial(checks& c, const testMeshes& cube)
{
    const auto mesh = cube.mesh("hexahedra", 8);
    checkTraction(c, mesh());
    checkTime(c, mesh());
    checkRotation(c, mesh());
    checkWritten
    (
        c, mesh(), "type traction; traction (1 2 3); pressure 5; follower (0 7 0);"
    );
    checkWritten
    (
        c, mesh(), "type patchForce; force (1 0 0); centre (1 0 0); radius 1;"
    );
    checkWritten
    (
        c, mesh(),
        "type prescribedRotation; axis (0 0 1); angle 30; origin (1 2 3);"
        "translation (0 0 2);"
    );
    checkErrors(c, mesh());
    for (const word& kind : testMeshes::kinds())
    {
        checkForce(c, kind, cube.mesh(kind, 6)());
    }
}


static void checkParallel(checks& c, const testMeshes& cube)
{
    for (const word kind : {"perturbed", "tetrahedra"})
    {
        meshLists whole;
        labelList ranks;
        if (Pstream::master())
        {
            Pstream::parRun() = false;
            whole = cube.lists(kind, 6);
            ranks = meshDistribution::bisect(whole, 2);
            // the loaded end belongs to both
            autoPtr<fvMesh> mesh(cube.scaled(whole, 1));
            forAll(ranks, i)
            {
                ranks[i] = mesh->C()[i].y() + 0.3*mesh->C()[i].x() > 0;
            }
            Pstream::parRun() = true;
        }
        const meshDistribution part(whole, ranks);
        autoPtr<fvMesh> mesh(cube.scaled(part.mesh, 1));
        const label own = mesh->boundary()["xMax"].size();
        c.check
        (
            kind + ": both processes hold faces",
            returnReduce(own, minOp<label>()) > 0
        );
        checkForce(c, kind + " in parallel", mesh());
    }
}


int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);
    checks c;
    const testMeshes cube(boundBox(point(-1, -1, -1), point(1, 1, 1)));
    if (Pstream::parRun())
    {
        checkParallel(c, cube);
    }
    else
    {
        checkSerial(c, cube);
    }
    return c.finish();
}
