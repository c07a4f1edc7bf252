/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Application
    fsbiTestMeshing

Description
    Checks of the meshes around and inside bodies, of mesh motion and, run on
    several processors (mpirun -np 2 fsbiTestMeshing -parallel), of the
    distribution.

\*---------------------------------------------------------------------------*/

#include "petscObjects.H"
#include "deforming.H"
#include "healing.H"
#include "filling.H"
#include "refining.H"
#include "periodic.H"
#include "meshDistribution.H"
#include "inverseDistanceMotion.H"
#include "argList.H"
#include "SubField.H"

using namespace Foam;
using namespace Foam::fsbi;

static void checkFar(checks& c)
{
    boxScene s;
    s.add(shape("type sphere; radius 1;", 0.2), point(0.1, 0, 3));
    const meshLists mesh(s.generate());
    checkMesh(c, "sphere", s, mesh);
    c.check
    (
        "patch names are kept",
        mesh.patchNames == wordList({"xMin", "xMax", "walls", "body0"})
    );
    autoPtr<fvMesh> fluid(s.fluid(mesh));
    c.check
    (
        "bodies are walls in the group bodies",
        fluid->boundaryMesh()[3].type() == "wall"
     && fluid->boundaryMesh()[3].inGroup("bodies")
    );
    c.check("cells in the middle of the box", mesh.nCells() > 5000);

    const meshLists again(s.generate());
    c.check
    (
        "the same mesh again",
        mesh.points == again.points && mesh.faces == again.faces
     && mesh.owner == again.owner && mesh.neighbour == again.neighbour
    );

    const meshLists coarse(s.generate("growth 0.5;"));
    c.check("growth coarsens", coarse.nCells() < mesh.nCells());
    const meshLists fine(s.generate("farSize 0.4;"));
    c.check("farSize refines", fine.nCells() > mesh.nCells());
    checkMesh(c, "HXT", s, s.generate("algorithm HXT;"));

    boxScene shifted;
    shifted.add(s.bodies[0], vector(10, 0, 0));
    const meshLists moved
    (
        conformalMesher(s.box(), dict("")).generate
        (
            shifted.names, shifted.bodies, vector(10, 0, 0)
        )
    );
    c.check("a shifted domain is meshed", moved.valid(), moved.failure);
    c.checkClose
    (
        "it is shifted", boundBox(moved.points, false).min().x(), 6, 1e-12
    );
}


static void checkUnits(checks& c)
{
    boxScene s(1e-6);
    s.add(shape("type sphere; radius 1e-6;", 0.2e-6), 1e-6*point(0.1, 0, 3));
    const meshLists mesh(s.generate());
    checkMesh(c, "micrometres in metres", s, mesh);

    boxScene none;
    const meshLists empty(none.generate());
    checkMesh(c, "no bodies", none, empty);
}


//- Longest edge of a patch's triangles nearer to a point than this; GREAT: none is
static scalar longestEdge
(
    const meshLists& mesh, const label patchi, const point& p, const scalar near
)
{
    scalar longest = 0;
    const label start = mesh.patchStarts[patchi];
    for (label f = start; f < start + mesh.patchSizes[patchi]; ++f)
    {
        const face& tri = mesh.faces[f];
        if (mag(tri.centre(mesh.points) - p) < near)
        {
            for (const edge& e : tri.edges())
            {
                longest = max(longest, e.mag(mesh.points));
            }
        }
    }
    return longest > 0 ? longest : GREAT;
}


static void checkGaps(checks& c)
{
    boxScene wall;
    wall.add(shape("type sphere; radius 1;", 0.15), point(0, 0, 1.1));
    const meshLists mesh(wall.generate());
    checkMesh(c, "gap to the wall", wall, mesh);

    // the wall under the body is as fine as the gap asks for
    c.checkBelow
    (
        "gap to the wall: the wall is fine",
        longestEdge(mesh, 2, Zero, 0.2), 0.12
    );

    boxScene pair;
    const bodySurface sphere(shape("type sphere; radius 1;", 0.15));
    pair.add(sphere, point(-1.05, 0, 3));
    pair.add(sphere, point(1.05, 0, 3));
    checkMesh(c, "gap between spheres", pair, pair.generate());

    boxScene coil;
    coil.add
    (
        shape
        (
            "type helix; radius 1; pitch 1; filamentRadius 0.2; turns 2;", 0.12
        ),
        point(0, 0, 3)
    );
    checkMesh(c, "helix", coil, coil.generate());
}


static void checkSpot(checks& c)
{
    boxScene s("patch", {}, true);
    s.add(shape("type sphere; radius 1;", 0.25), point(0, 0, 1.4));
    const meshLists mesh(s.generate());
    checkMesh(c, "patch in a patch", s, mesh);
    autoPtr<fvMesh> fluid(s.fluid(mesh));
    c.checkClose
    (
        "patch in a patch: area", sum(mag(fluid->boundaryMesh()[3].faceAreas())),
        sum(mag(s.box->boundaryMesh()[3].faceAreas())), 1e-10
    );
}


static void checkCurved(checks& c)
{
    boxScene s
    (
        "patch",
        [](const point& p)
        {
            const scalar r = 10 + p.z(), angle = p.x()/12;
            return point(r*Foam::sin(angle), p.y(), r*Foam::cos(angle) - 10);
        }
    );
    const scalar volume = 0.5*(sqr(16.0) - sqr(10.0))*(8.0/12)*8;
    // bound: chords would cut off a^2/6 of angles a of 1/15, 7e-4; of that a quarter, as
    // two of ten lie at the ends, where normals are one facet's
    const scalar ofFacets = sqr(1.0/15)/24;

    s.add(shape("type sphere; radius 1;", 0.25), point(0, 0, 3));
    // nothing small is wanted at the walls
    const meshLists mesh(s.generate("growth 0.5; cellsPerGap 1;"));
    checkMesh(c, "curved walls", s, mesh, volume, ofFacets);
    c.check
    (
        "curved walls: the given faces are kept",
        mesh.valid() && mesh.patchSizes[2] == 4*(10*8 + 10*10)
    );

    s.bodies.clear();
    s.names.clear();
    s.add(shape("type sphere; radius 1;", 0.15), point(0, 0, 1.1));
    const meshLists near(s.generate());
    checkMesh(c, "gap to a curved wall", s, near, volume, ofFacets);
    // bound: 1.5 times the smallest size, 0.4 of the body's edges
    c.checkBelow
    (
        "gap to a curved wall: it is fine there",
        longestEdge(near, 2, Zero, 0.2), 1.5*0.4*0.15
    );
    c.checkClose
    (
        "gap to a curved wall: not elsewhere",
        longestEdge(near, 2, point(-4, -4, 3), 1),
        longestEdge(mesh, 2, point(-4, -4, 3), 1), 1e-10
    );
    autoPtr<fvMesh> fine(s.fluid(near)), coarse(s.fluid(mesh));
    for (label patchi = 0; patchi < 3; ++patchi)
    {
        c.checkClose
        (
            "gap to a curved wall: area of a patch",
            sum(mag(fine->boundaryMesh()[patchi].faceAreas())),
            sum(mag(coarse->boundaryMesh()[patchi].faceAreas())), 1e-10
        );
    }
}


static void checkMotion(checks& c)
{
    boxScene s;
    s.add(shape("type sphere; radius 1;", 0.2), point(0.1, 0, 3));
    const meshLists lists(s.generate());
    autoPtr<fvMesh> mesh(s.fluid(lists));
    const inverseDistanceMotion motion
    (
        mesh(), s.names, s.bodies, s.placements, {}
    );
    const scalarField volumes(mesh->cellVolumes());

    c.checkBelow
    (
        "no motion moves nothing",
        max(mag(motion.move(s.placements, Zero) - mesh->points())), 1e-14
    );
    List<placement> now(s.placements);
    now[0].orientation = quaternion(vector(1, 2, 2)/3, 0.4);
    now[0].centre += vector(0.3, 0.1, -0.2);
    const pointField points(motion.move(now, Zero));
    scalar error = 0, wall = 0;
    forAll(lists.bodyPoints[0], p)
    {
        const label pointi = lists.bodyPoints[0][p];
        const vector r(mesh->points()[pointi] - s.placements[0].centre);
        error = max(error, mag(points[pointi] - now[0].transform(r)));
    }
    for (label patchi = 0; patchi < 3; ++patchi)
    {
        for (const label p : mesh->boundaryMesh()[patchi].meshPoints())
        {
            wall = max(wall, mag(points[p] - lists.points[p]));
        }
    }
    c.checkBelow("the body moves rigidly", error, 1e-12);
    c.checkBelow("the walls stay", wall, 1e-14);
    c.checkClose("the twist is known", motion.twist(now), 0.4, 1e-10);

    mesh->polyMesh::movePoints(points);
    const meshQuality q(mesh(), volumes);
    Info<< "    turned by 0.4: non-orthogonality " << q.maxNonOrthogonality
        << ", volume ratio " << q.minVolumeRatio << endl;
    c.check("volumes stay positive", q.minVolume > 0);
    const remeshControls limits(dict("maxNonOrthogonality 80;"));
    c.check("not yet degraded", !q.degraded(limits, motion.twist(now)));
    c.check("a large twist degrades", q.degraded(limits, 0.6));

    mesh->polyMesh::movePoints(motion.move(s.placements, vector(0.1, 0, 0)));
    c.checkClose
    (
        "the frame moves the walls", mesh->bounds().min().x(), -3.9, 1e-12
    );
}


static void checkErrors(checks& c)
{
    const bodySurface sphere(shape("type sphere; radius 1;", 0.3));
    const auto refused = [&]
    (
        const std::string& name, const point& a, const point& b,
        const std::string& text
    )
    {
        boxScene s;
        s.add(sphere, a);
        s.add(sphere, b);
        const meshLists mesh(s.generate());
        c.check
        (
            name,
            !mesh.valid() && mesh.failure.find(text) != std::string::npos,
            mesh.failure
        );
    };
    const point good(-2, -2, 2);
    refused("a body outside is refused", point(20, 0, 3), good, "outside");
    refused("a body in the wall is refused", good, point(1, 1, 0.5), "'body1'");
    refused("overlapping bodies are refused", good, point(-1, -2, 2), "overlaps");

    boxScene nested;
    nested.add(shape("type sphere; radius 2;", 0.5), point(0, 0, 3));
    nested.add(sphere, point(0, 0, 3));
    c.check
    (
        "a body inside another is refused",
        nested.generate().failure.find("inside") != std::string::npos
    );
    c.checkFatal
    (
        "an unknown keyword is refused",
        [&]{ conformalMesher(nested.box(), dict("grwth 1;")); }, "grwth"
    );

    // failure without a fatal error: no mesh is that good
    boxScene s;
    s.add(sphere, good);
    const meshLists none(s.generate("maxSkewness 1e-3;"));
    c.check("an impossible limit returns the failure", !none.valid());
    c.check
    (
        "of meshes that are too skew to their faces the best is taken",
        s.generate("maxNonOrthogonality 10;").valid()
    );
}


static void checkDistribution(checks& c)
{
    boxScene s;
    s.add(shape("type sphere; radius 1;", 0.25), point(0.1, 0, 3));
    meshLists whole;
    labelList ranks;
    if (Pstream::master())
    {
        const bool parallel = Pstream::parRun();
        Pstream::parRun() = false;
        whole = s.generate();
        ranks = meshDistribution::bisect(whole, Pstream::nProcs());
        Pstream::parRun() = parallel;
    }
    const meshDistribution part(whole, ranks);
    autoPtr<fvMesh> mesh(s.fluid(part.mesh));

    c.check("distributed: topology", !mesh->checkTopology(false));
    c.check("distributed: geometry", !mesh->checkGeometry(false));
    c.checkClose
    (
        "distributed: volume", gSum(mesh->cellVolumes()),
        8*8*6 - s.bodies[0].volume(), 1e-10
    );
    const label total = returnReduce(mesh->nCells(), sumOp<label>());
    const label largest = returnReduce(mesh->nCells(), maxOp<label>());
    c.checkBelow
    (
        "distributed: balanced", scalar(largest)*Pstream::nProcs()/total, 1.01
    );

    // global numbers: the body's triangles are found again
    const label patchi = mesh->boundaryMesh().findPatchID("body0");
    const polyPatch& body = mesh->boundaryMesh()[patchi];
    scalar error = 0;
    forAll(body, f)
    {
        const label triangle =
            part.faces[body.start() + f] - part.wholePatchStarts[patchi];
        const point centre
        (
            s.bodies[0].triangles()[triangle].centre(s.bodies[0].points())
        );
        error = max(error, mag(centre - body.faceCentres()[f]));
    }
    c.checkBelow
    (
        "distributed: triangles found", returnReduce(error, maxOp<scalar>()),
        1e-12
    );
    c.check
    (
        "distributed: every triangle once",
        returnReduce(body.size(), sumOp<label>())
     == s.bodies[0].triangles().size()
    );

    const inverseDistanceMotion motion
    (
        mesh(), s.names, s.bodies, s.placements, {}
    );
    List<placement> now(s.placements);
    now[0].orientation = quaternion(vector(0, 1, 0), 0.3);
    mesh->polyMesh::movePoints(motion.move(now, Zero));
    const meshQuality q(mesh());
    c.check("distributed: moves", q.minVolume > 0);
    Info<< "    moved: non-orthogonality " << q.maxNonOrthogonality << endl;
}


int main(int argc, char* argv[])
{
    argList::noBanner();
    argList::noCheckProcessorDirectories();
    argList args(argc, argv, false, false, true);

    petscSession petsc;

    checks c;
    if (!Pstream::parRun())
    {
        checkFar(c);
        checkUnits(c);
        checkGaps(c);
        checkRefining(c);
        checkSpot(c);
        checkCurved(c);
        checkPeriodic(c);
        checkMotion(c);
        checkErrors(c);
        checkFilling(c);
        checkFit(c);
        checkMapping(c);
        checkFluidMesh(c);
        checkHealing(c);
    }
    checkDistribution(c);
    checkMasterAlone(c);
    checkDeforming(c);
    return c.finish();
}
