/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestFourthOrderElastic

Description
    Checks of the elastic operator of fourth order: cubic displacements are
    exact on cells of every kind, whatever is given of them, also where two
    cells across are all there are; the derivative is that of the residual,
    forces turn with the body; a sphere under pressure is strained alike
    everywhere, whatever its facets are, and has the volume of a sphere.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "elasticCase.H"
#include "bodyMesher.H"
#include "bodyShape.H"
#include "checks.H"
#include "meanValues.H"
#include "testMeshes.H"
#include "argList.H"
#include "mathematicalConstants.H"
#include "quaternion.H"

using namespace Foam;
using namespace Foam::fsbi;

typedef constitutiveState::formulation formulation;

static const boundBox cube(point(-1, -1, -1), point(1, 1, 1));


static solidBoundary::kind allGiven(const point&)
{
    return solidBoundary::displacement;
}

static solidBoundary::kind allFree(const point&)
{
    return solidBoundary::traction;
}


static scalar largest(const scalarList& r)
{
    scalar most = 0;
    for (const scalar x : r)
    {
        most = max(most, mag(x));
    }
    return most;
}


static elasticCase fourth
(
    const fvMesh& mesh, const string& law, const elasticCase::kindFunction& kind
)
{
    return elasticCase
    (
        mesh, law, kind, formulation::totalLagrangian, false, 4
    );
}


// A cubic displacement, its gradient, and the force per volume that it needs
// of a body with mu 1/2 and lambda 0

    static vector u(const point& p)
    {
        const scalar x = p.x(), y = p.y(), z = p.z();
        return vector
        (
            0.1*x*y*z + 0.2*pow3(x) - 0.1*y*y + z,
            0.3*x*x*y + 0.1*z*z*z - 0.2*x,
            0.1*y*y*z - 0.2*x*z + 0.05*x*x*x + 1
        );
    }

    static tensor gradient(const point& p)
    {
        const scalar x = p.x(), y = p.y(), z = p.z();
        return tensor
        (
            0.1*y*z + 0.6*x*x, 0.1*x*z - 0.2*y, 0.1*x*y + 1,
            0.6*x*y - 0.2, 0.3*x*x, 0.3*z*z,
            -0.2*z + 0.15*x*x, 0.2*y*z, 0.1*y*y - 0.2*x
        );
    }

    static tensor stress(const point& p)
    {
        return tensor(symm(gradient(p)));
    }

    // -div(grad u + (grad u)^T)/2
    static vector force(const point& p)
    {
        const scalar x = p.x(), y = p.y(), z = p.z();
        const vector laplacian
        (
            1.2*x - 0.2, 0.6*y + 0.6*z, 0.2*z + 0.3*x
        );
        // of div u = 0.1 y z + 0.9 x^2 + 0.1 y^2 - 0.2 x
        const vector ofDivergence(1.8*x - 0.2, 0.1*z + 0.2*y, 0.1*y);
        return -(laplacian + ofDivergence)/2;
    }

static const string hooke("type linearElastic; E 1; nu 0;");


static void checkCubic
(
    checks& c, const fvMesh& mesh, const std::string& name, const bool free
)
{
    elasticCase body(fourth(mesh, hooke, free ? allFree : allGiven));
    forAll(body.given.faces, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const vector n(normalised(mesh.faceAreas()[facei]));
        body.given.faces[i] =
            free
          ? faceMean
            (
                mesh, facei, [&](const point& p){ return vector(stress(p) & n); }
            )
          : u(mesh.faceCentres()[facei]);
    }
    body.elastic->set(u, body.x.begin());
    scalarList r(body.x.size());
    body.elastic->residual(body.x.cdata(), body.given, r.begin());
    forAll(mesh.cells(), celli)
    {
        const vector f(mesh.cellVolumes()[celli]*cellMean(mesh, celli, force));
        for (direction i = 0; i < 3; ++i)
        {
            r[3*celli + i] -= f[i];
        }
    }
    c.checkClose
    (
        name + ": cubic displacement, " + (free ? "tractions" : "displacements")
      + " given, residual", largest(r), 0, 1e-9
    );
    scalar most = 0;
    const vectorField atVertices(body.elastic->vertexDisplacement());
    const vectorField atFaces(body.elastic->boundaryDisplacement());
    const tensorField& F = body.elastic->state().deformation();
    forAll(atVertices, v)
    {
        const point& p = mesh.points()[v];
        most = max(most, mag(atVertices[v] - u(p)));
        most = max(most, mag(F[v] - tensor::I - gradient(p)));
    }
    forAll(atFaces, i)
    {
        const point& p = mesh.faceCentres()[mesh.nInternalFaces() + i];
        most = max(most, mag(atFaces[i] - u(p)));
    }
    c.checkClose
    (
        name + ": its vertices, with gradients, and faces", most, 0, 1e-9
    );
}


//- The derivative against central differences of the residual
static void checkTangent(checks& c, const fvMesh& mesh, const word& law)
{
    elasticCase body
    (
        fourth
        (
            mesh, "type " + law + "; E 1; nu 0.4; density 1;",
            elasticCase::heldAndLoaded
        )
    );
    body.giveLoads();
    c.checkClose
    (
        "derivative of " + law, body.derivativeError(0.005, 1e-6), 0, 1e-7
    );
    c.check(law + ": the law holds", body.elastic->valid());
    // what short waves are damped by, with a past of its own
    body.elastic->beginStep(0.1, 0, true);
    body.elastic->jumpHistory() = vector(0.001, 0.002, -0.001);
    c.checkClose
    (
        "derivative of " + law + " with inertia",
        body.derivativeError(0.005, 1e-6), 0, 1e-7
    );
}


//- What the fits do not explain, x - smooth, is damped where it is new; r: in,
//  forces without inertia, out: after a step that changed nothing
static void checkDamping
(
    checks& c, elasticCase& body, const scalarList& smooth, scalarList& r
)
{
    const scalarList undamped(r);
    const auto power = [&]()
    {
        body.elastic->residual(body.x.cdata(), body.given, r.begin());
        scalar sum = 0;
        for (label i = 0; i < 3*body.mesh.nCells(); ++i)
        {
            sum += (r[i] - undamped[i])*(body.x[i] - smooth[i]);
        }
        return sum;
    };
    body.elastic->beginStep(0.1, 0, true);
    const scalar fresh = power();
    c.check("what the fits do not explain is damped where it is new", fresh > 0);
    body.elastic->endStep();
    c.checkClose("and not where it was before", power()/fresh, 0, 1e-12);
}


//- Forces turn with the body, whatever its deformation; in a body with inertia
//  what is not in the space of the fits is damped, which turns nothing
static void checkObjective(checks& c, const fvMesh& mesh, const bool inertia)
{
    elasticCase body
    (
        fourth(mesh, "type neoHookean; E 1; nu 0.45; density 1;", allFree)
    );
    const std::string name(inertia ? ", with inertia" : "");
    const auto deformed = [](const point& p){ return vector(p + 0.1*u(p)); };
    const quaternion q
    (
        normalised(vector(1, 2, 3)), constant::mathematical::piByTwo
    );
    // not in the space of the fits
    const auto disturb = [&](const tensor& turn)
    {
        for (label i = 0; i < body.x.size()/3; ++i)
        {
            const vector noisy
            (
                turn & (0.01*vector(noise(3*i), noise(3*i + 1), noise(3*i + 2)))
            );
            for (direction k = 0; k < 3; ++k)
            {
                body.x[3*i + k] += noisy[k];
            }
        }
    };
    const label n = 3*mesh.nCells();
    scalarList r(body.x.size()), turned(body.x.size());
    body.elastic->set
    (
        [&](const point& p){ return deformed(p) - p; }, body.x.begin()
    );
    const scalarList smooth(body.x);
    disturb(tensor::I);
    body.elastic->residual(body.x.cdata(), body.given, r.begin());
    if (inertia)
    {
        checkDamping(c, body, smooth, r);
    }
    body.elastic->set
    (
        [&](const point& p){ return q.transform(deformed(p)) - p; },
        body.x.begin()
    );
    disturb(q.R());
    body.elastic->residual(body.x.cdata(), body.given, turned.begin());
    scalar most = 0;
    for (label i = 0; i < n; i += 3)
    {
        const vector f(r[i], r[i + 1], r[i + 2]);
        const vector g(turned[i], turned[i + 1], turned[i + 2]);
        most = max(most, mag(q.transform(f) - g));
    }
    c.checkClose
    (
        "forces of a body turned by 90 degrees, less those turned" + name,
        most/largest(r), 0, 1e-11
    );
}


static void checkRotation(checks& c, const fvMesh& mesh, const word& kind)
{
    for (const label degrees : {10, 90, 179})
    {
        elasticCase body
        (
            fourth(mesh, "type StVenantKirchhoff; E 1; nu 0.3;", allFree)
        );
        const quaternion q
        (
            normalised(vector(1, 2, 3)),
            degrees*constant::mathematical::pi/180
        );
        body.elastic->set
        (
            [&](const point& p){ return q.transform(p) - p; }, body.x.begin()
        );
        scalarList r(body.x.size());
        body.elastic->residual(body.x.cdata(), body.given, r.begin());
        c.checkClose
        (
            kind + ": forces of a rotation by " + std::to_string(degrees),
            largest(r), 0, 1e-10
        );
    }
}


//- A sphere, its vertices on the surface
static autoPtr<fvMesh> sphere(const testMeshes& meshes, const scalar size)
{
    dictionary shape;
    shape.set("type", word("sphere"));
    shape.set("radius", 1);
    const bodySurface facets(bodyShape::New(shape)->triangulate(size));
    return bodyMesher(dictionary()).fill
    (
        "surface", facets.scaled(1/facets.scale()), 0
    ).makeMesh
    (
        IOobject
        (
            "cell", meshes.clock().timeName(), meshes.clock(), IOobject::NO_READ
        )
    );
}


static void checkBalance
(
    checks& c, const elasticCase& body, const std::string& name,
    const scalar bound
)
{
    vector sum(Zero);
    scalar size = 0;
    const vectorField loads(body.elastic->boundaryForce());
    forAll(loads, i)
    {
        sum += loads[i];
        size += mag(loads[i]);
    }
    c.checkBelow(name + ": loads in balance", mag(sum)/size, bound);
}


//- With a uniform strain the stress is uniform: pressure on the curved surface
//  holds it, for any facets
static void checkPressure(checks& c, const fvMesh& mesh)
{
    elasticCase body
    (
        fourth(mesh, "type neoHookean; E 1; nu 0.3;", allFree)
    );
    const scalar stretch = 0.9;
    body.elastic->set
    (
        [&](const point& p){ return vector((stretch - 1)*p); }, body.x.begin()
    );
    const tensor F(stretch*tensor::I);
    // P = -p cof F
    body.given.pressure = -body.material->stress(F).xx()/sqr(stretch);
    scalarList r(body.x.size());
    body.elastic->residual(body.x.cdata(), body.given, r.begin());
    c.checkBelow("sphere under pressure: residual", largest(r), 1e-12);
    checkBalance(c, body, "sphere under pressure", 1e-13);
}


//- Of the same sphere with a part held
static void checkHeldSphere(checks& c, const fvMesh& mesh)
{
    elasticCase body
    (
        fourth
        (
            mesh, "type neoHookean; E 1; nu 0.3;", [](const point& p)
            {
                return
                    p.z() < -0.5 ? solidBoundary::displacement
                  : solidBoundary::traction;
            }
        )
    );
    body.given.pressure = 0.05;
    body.solve("tolerance 1e-12;");
    checkBalance(c, body, "sphere held in part", 1e-11);
}


static scalar volumeError(const fvMesh& mesh)
{
    elasticCase body(fourth(mesh, hooke, allFree));
    return
        (sum(mesh.cellVolumes()) + sum(body.elastic->volumesOnFacets()()))
       /(4*constant::mathematical::pi/3)
      - 1;
}


static void checkSpheres(checks& c, const testMeshes& meshes)
{
    const scalarList sizes({0.4, 0.2});
    scalarList errors(2);
    forAll(sizes, i)
    {
        const autoPtr<fvMesh> mesh(sphere(meshes, sizes[i]));
        checkPressure(c, mesh());
        checkHeldSphere(c, mesh());
        errors[i] = mag(volumeError(mesh()));
    }
    // of facets it would be 9 % and of second order
    c.checkBelow("volume of a sphere", errors[1], 1e-3);
    const scalar order = std::log(errors[0]/errors[1])/std::log(2.0);
    // bound: fourth in theory, on meshes that are not similar
    c.check("its order", order > 3.5, Foam::name(order));
}


// A quarter of a ring between planes of symmetry: the cube, bent

    static const scalar innerRadius = 0.5, outerRadius = 1.5;

    static point bend(const point& p)
    {
        const scalar radius =
            innerRadius + (outerRadius - innerRadius)*(p.x() + 1)/2;
        const scalar angle = constant::mathematical::pi/4*(p.y() + 1);
        return point
        (
            radius*Foam::cos(angle), radius*Foam::sin(angle), p.z()
        );
    }

    //- Of a face of the cube: 0 to 3 for those that become planes of symmetry
    static label sideOf(const vector& n)
    {
        const direction d = mag(n.y()) > 0.5 ? 1 : 2;
        return 2*(d - 1) + (n[d] > 0);
    }

    //- Cut the last patch of the cube, four sides, into one a side
    static void cutSides(meshLists& lists)
    {
        const label start = lists.patchStarts.last();
        const faceList faces(lists.faces);
        const labelList owner(lists.owner);
        lists.patchNames.last() = "side0";
        lists.patchDicts.last().set("type", "symmetryPlane");
        const dictionary side(lists.patchDicts.last());
        label place = start;
        for (label i = 0; i < 4; ++i)
        {
            const label first = place;
            for (label facei = start; facei < faces.size(); ++facei)
            {
                if (sideOf(faces[facei].unitNormal(lists.points)) == i)
                {
                    lists.faces[place] = faces[facei];
                    lists.owner[place++] = owner[facei];
                }
            }
            if (i)
            {
                lists.patchNames.append("side" + Foam::name(i));
                lists.patchDicts.append(side);
                lists.patchStarts.append(first);
                lists.patchSizes.append(0);
            }
            lists.patchSizes.last() = place - first;
        }
    }

    static autoPtr<fvMesh> ring(const testMeshes& meshes, const label n)
    {
        meshLists lists(meshes.lists("tetrahedra", n));
        cutSides(lists);
        for (point& p : lists.points)
        {
            p = bend(p);
        }
        return lists.makeMesh
        (
            IOobject
            (
                "ring", meshes.clock().timeName(), meshes.clock(),
                IOobject::NO_READ
            )
        );
    }

    static solidBoundary::kind onRing(const point& p)
    {
        const bool plane =
            min(mag(p.x()), mag(p.y())) < 1e-6 || mag(p.z()) > 1 - 1e-6;
        return plane ? solidBoundary::symmetry : solidBoundary::traction;
    }


static void checkRing(checks& c, const testMeshes& meshes)
{
    scalarList errors(2);
    forAll(errors, i)
    {
        const autoPtr<fvMesh> mesh(ring(meshes, i ? 8 : 4));
        elasticCase body(fourth(mesh(), hooke, onRing));
        const scalar exact =
            constant::mathematical::pi/2
           *(sqr(outerRadius) - sqr(innerRadius));
        const scalar volume =
            sum(mesh().cellVolumes()) + sum(body.elastic->volumesOnFacets()());
        errors[i] = mag(volume/exact - 1);
    }
    const scalar order = std::log(errors[0]/errors[1])/std::log(2.0);
    // bound: fourth in theory, on meshes that are not similar
    c.check
    (
        "volume of a ring between planes of symmetry, order",
        order > 3.5, Foam::name(order) + ", " + Foam::name(errors[1])
    );
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList args(argc, argv);
    petscSession petsc;
    const untrapped scope;

    checks c;
    const testMeshes meshes(cube);
    for (const word& kind : testMeshes::kinds())
    {
        autoPtr<fvMesh> mesh(meshes.mesh(kind, 4));
        // faces of perturbed cells are not plane
        for (const bool free : {false, true})
        {
            if (kind == "hexahedra" || kind == "tetrahedra")
            {
                checkCubic(c, mesh(), kind, free);
            }
        }
        checkRotation(c, mesh(), kind);
    }
    autoPtr<fvMesh> two(meshes.mesh("hexahedra", 2));
    checkCubic(c, two(), "two hexahedra across", false);
    checkCubic(c, two(), "two hexahedra across", true);
    autoPtr<fvMesh> mesh(meshes.mesh("tetrahedra", 3));
    for
    (
        const word law :
        {
            "StVenantKirchhoff", "neoHookean", "MooneyRivlin",
            "corotationalElastic", "linearElastic"
        }
    )
    {
        checkTangent(c, mesh(), law);
    }
    checkObjective(c, mesh(), false);
    checkObjective(c, mesh(), true);
    checkSpheres(c, meshes);
    checkRing(c, meshes);
    return c.finish();
}
