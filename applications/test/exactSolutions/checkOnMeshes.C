/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactChecks.H"
#include "testMeshes.H"
#include "meshDistribution.H"
#include "tractionCondition.H"
#include "pointwiseValue.H"
#include "exactError.H"
#include "volFields.H"
#include "pointFields.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"

namespace Foam
{
namespace fsbi
{

//- A box with the files of a case
class scene
{
    const fileName folder_;

public:

    const testMeshes meshes;

    scene()
    :
        folder_(cwd()/"exactSolutions"),
        meshes(boundBox(point(-1, -1, 0), point(1, 1, 2)), folder_)
    {}

    ~scene()
    {
        if (Pstream::master())
        {
            rmDir(folder_);
        }
    }

    //- Write what constant/<region> holds
    void describe(const std::string& solution, const std::string& law) const
    {
        const fileName constant(folder_/"constant"/"fluid");
        if (Pstream::master())
        {
            mkDir(constant);
            write(constant/"exactSolution", solution);
            write(constant/"material", law);
        }
        bool done = true;
        reduce(done, andOp<bool>());
    }

    static void write(const fileName& file, const std::string& text)
    {
        OFstream os(file);
        os  << "FoamFile { version 2.0; format ascii; class dictionary; object "
            << file.name().c_str() << "; }" << nl << text.c_str() << endl;
    }

    //- First number below a heading of errors.csv; -1 if there is none
    scalar written(const std::string& heading) const
    {
        IFstream file(folder_/"postProcessing"/"errors"/"0"/"errors.csv");
        std::string headings, values;
        std::getline(file.stdStream(), headings);
        std::getline(file.stdStream(), values);
        std::istringstream names(headings), numbers(values);
        std::string name, number;
        while (std::getline(names, name, ','))
        {
            std::getline(numbers, number, ',');
            if (name == heading)
            {
                return std::stod(number);
            }
        }
        return -1;
    }
};


static const std::string bar("type beamSelfWeight; length 2; bodyForce 3;");

static const std::string beam
(
    "type beamFlexure; width 2; height 2; length 2; force 5;"
);

static const std::string waves
(
    "type manufactured; amplitude 0.05; length 2; origin (-1 -1 0);"
);

static const std::string elastic("type linearElastic; E 2; nu 0.3;");
static const std::string rubber("type neoHookean; E 2; nu 0.3;");


//- All patches of one condition
static autoPtr<volVectorField> displacement
(
    const fvMesh& mesh, const word& condition
)
{
    const IOobject io
    (
        "D", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE
    );
    return autoPtr<volVectorField>::New
    (
        io, mesh,
        entries
        (
            "dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0);"
            "boundaryField { \".*\" { type " + condition
          + "; } \"proc.*\" { type processor; } }"
        )
    );
}


//- Force of all patches but processors'
static vector total(const volVectorField& D)
{
    vector sum(Zero);
    for (const fvPatchVectorField& pf : D.boundaryField())
    {
        if (isA<tractionCondition>(pf))
        {
            sum += gSum
            (
                refCast<const tractionCondition>(pf).dead()*pf.patch().magSf()
            );
        }
    }
    return sum;
}


static vector bodyForce(const fvMesh& mesh)
{
    const auto s = exactSolution::New(mesh);
    vector sum(Zero);
    forAll(mesh.cellCentres(), i)
    {
        sum += mesh.V()[i]*s->bodyForce(mesh.cellCentres()[i], 0);
    }
    return returnReduce(sum, sumOp<vector>());
}


static void checkTraction
(
    checks& c, const scene& scene, const word& name, const fvMesh& mesh
)
{
    // the stress is linear: the rule is exact, on warped faces too
    scene.describe(bar, elastic);
    c.checkBelow
    (
        name + ": tractions of the bar balance its weight",
        mag(total(displacement(mesh, "exactTraction")()) + bodyForce(mesh)),
        1e-11
    );
}


//- How the force on the end of the beam converges
static void checkQuadrature(checks& c, const scene& scene)
{
    scene.describe(beam, elastic);
    scalar error[2];
    for (label i = 0; i < 2; ++i)
    {
        const auto mesh = scene.meshes.mesh("hexahedra", i ? 8 : 4);
        const auto D = displacement(mesh(), "exactTraction");
        vector force(Zero);
        for (const fvPatchVectorField& pf : D->boundaryField())
        {
            const vectorField t(refCast<const tractionCondition>(pf).dead());
            forAll(t, facei)
            {
                if (pf.patch().Cf()[facei].z() > 2 - 1e-6)
                {
                    force += t[facei]*pf.patch().magSf()[facei];
                }
            }
        }
        error[i] = mag(force - vector(0, 5, 0))/5;
    }
    c.checkBelow("the end of the beam carries its force", error[1], 2e-4);
    // the corners are not smooth enough for fourth order
    c.checkBelow
    (
        "the force on faces converges with third order", error[1]/error[0],
        1.0/7
    );
}


static void checkDisplacement(checks& c, const scene& scene)
{
    scene.describe(waves, rubber);
    const auto mesh = scene.meshes.mesh("tetrahedra", 6);
    const auto D = displacement(mesh(), "exactDisplacement");
    const auto s = exactSolution::New(mesh());
    scalar faces = 0, vertices = 0;
    for (const fvPatchVectorField& pf : D->boundaryField())
    {
        const auto& points = pf.patch().patch().localPoints();
        const vectorField u
        (
            dynamic_cast<const pointwiseValue&>(pf).valueAt(points, 0)
        );
        forAll(u, i)
        {
            vertices = max(vertices, mag(u[i] - s->displacement(points[i], 0)));
        }
        forAll(pf, i)
        {
            faces = max
            (
                faces, mag(pf[i] - s->displacement(pf.patch().Cf()[i], 0))
            );
        }
    }
    c.checkBelow("exactDisplacement: faces", faces, 0);
    c.checkBelow("exactDisplacement: vertices", vertices, 0);
}


//- Fields with known errors, and what the function object says of them
static void checkErrorNorms
(
    checks& c, const scene& scene, const word& name, const fvMesh& mesh
)
{
    scene.describe(waves, rubber);
    const auto s = exactSolution::New(mesh);
    autoPtr<volVectorField> D(displacement(mesh, "exactDisplacement"));
    volSymmTensorField sigma
    (
        IOobject("sigma", "0", mesh), mesh,
        dimensionedSymmTensor("0", dimPressure, Zero)
    );
    pointSymmTensorField pointSigma
    (
        IOobject("pointSigma", "0", mesh), pointMesh::New(mesh),
        dimensionedSymmTensor("0", dimPressure, Zero)
    );
    pointVectorField pointD
    (
        IOobject("pointD", "0", mesh), pointMesh::New(mesh),
        dimensionedVector("0", dimLength, Zero)
    );
    const vector shift(0, 0.003, 0);
    scalar square = 0;
    forAll(sigma, i)
    {
        const point& X = mesh.cellCentres()[i];
        const vector u(s->displacement(X, 0));
        D()[i] = u + shift;
        square += mesh.V()[i]*magSqr(u);
        sigma[i] = 1.01*s->CauchyStress(X, 0);
    }
    forAll(pointSigma, i)
    {
        pointSigma[i] = 0.98*s->CauchyStress(mesh.points()[i], 0);
        pointD[i] = 1.03*s->displacement(mesh.points()[i], 0);
    }
    reduce(square, sumOp<scalar>());

    exactError errors("errors", mesh.time(), entries("region fluid;"));
    errors.write();
    if (!Pstream::master())
    {
        return;
    }
    c.checkClose
    (
        name + ": l2 of D", scene.written("D_l2"),
        Foam::sqrt(8*magSqr(shift)/square), 1e-8
    );
    c.checkClose
    (
        name + ": max of D", scene.written("D_max"), 0.003/0.05, 0.2
    );
    for (const std::string norm : {"_l2", "_max"})
    {
        const auto close = [&](const std::string& field, const scalar error)
        {
            c.checkClose
            (
                name + ": " + field + norm, scene.written(field + norm), error,
                1e-8
            );
        };
        close("sigma", 0.01);
        close("sigmazz", 0.01);
        close("pointSigma", 0.02);
        close("pointD", 0.03);
    }
    const scalar cells = scene.written("cells");
    c.checkClose(name + ": h", scene.written("h"), Foam::cbrt(8/cells), 1e-8);
}


static void checkFiles(checks& c, const scene& scene)
{
    const auto mesh = scene.meshes.mesh("hexahedra", 3);
    const auto refused = [&](const std::string& what, const std::string& text)
    {
        c.checkFatal
        (
            what, [&]{ displacement(mesh(), "exactTraction"); }, text
        );
    };
    refused("no exactSolution", "exactSolution");
    scene.describe("type beamFlexure;", elastic);
    refused("an incomplete exactSolution", "width");
    scene.describe(beam, "type linearElastic; E 1;");
    refused("an incomplete material", "nu");
    scene.describe(bar, elastic);
    c.checkFatal
    (
        "an entry of exactTraction",
        [&]{ displacement(mesh(), "exactTraction; traction (0 0 1)"); },
        "traction"
    );
}


void checkOnMeshes(checks& c)
{
    const scene scene;
    checkFiles(c, scene);
    checkQuadrature(c, scene);
    checkDisplacement(c, scene);
    for (const word& kind : testMeshes::kinds())
    {
        checkTraction(c, scene, kind, scene.meshes.mesh(kind, 5)());
    }
    checkErrorNorms
    (
        c, scene, "tetrahedra", scene.meshes.mesh("tetrahedra", 6)()
    );
}


void checkInParallel(checks& c)
{
    const scene scene;
    meshLists whole;
    labelList ranks;
    if (Pstream::master())
    {
        Pstream::parRun() = false;
        whole = scene.meshes.lists("tetrahedra", 6);
        ranks = meshDistribution::bisect(whole, 2);
        Pstream::parRun() = true;
    }
    const meshDistribution part(whole, ranks);
    const autoPtr<fvMesh> mesh(scene.meshes.scaled(part.mesh, 1));
    checkTraction(c, scene, "in parallel", mesh());
    checkErrorNorms(c, scene, "in parallel", mesh());
}

} // End namespace fsbi
} // End namespace Foam
