/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "healing.H"
#include "boxScene.H"
#include "inverseDistanceMotion.H"
#include "meshDistribution.H"
#include "meshHealing.H"
#include "meshRepair.H"
#include "regionMesh.H"
#include "cpuTime.H"

namespace Foam
{
namespace fsbi
{

// Two spheres, and their mesh when they have passed each other as far that it is
// degraded
struct passed
{
    boxScene s;
    meshLists fresh;
    meshLists worn;

    passed()
    {
        s.add(shape("type sphere; radius 1;", 0.25), point(-0.4, 0, 1.8));
        s.add(shape("type sphere; radius 1;", 0.25), point(0.4, 0, 4.2));
        fresh = s.generate();
        autoPtr<fvMesh> mesh(s.fluid(fresh));
        const inverseDistanceMotion motion
        (
            mesh(), s.names, s.bodies, s.placements, {}
        );
        worn = fresh;
        List<placement> now(s.placements);
        for (scalar way = 0.1; meshQuality(worn).maxNonOrthogonality < 70; )
        {
            now[0].centre = s.placements[0].centre + vector(way, 0, 0);
            now[1].centre = s.placements[1].centre - vector(way, 0, 0);
            worn.points = motion.move(now, Zero);
            way += 0.05;
        }
        forAll(s.bodies, b)
        {
            s.bodies[b] = s.bodies[b].transformed
            (
                tensor::I, now[b].centre - s.placements[b].centre
            );
        }
    }

    sizeFunction sizes() const
    {
        return conformalMesher(s.box(), dictionary()).sizes(s.bodies, Zero, 0.2);
    }
};


static bool same(const meshLists& a, const meshLists& b)
{
    return
        a.points == b.points && a.faces == b.faces && a.owner == b.owner
     && a.neighbour == b.neighbour && a.patchStarts == b.patchStarts
     && a.patchSizes == b.patchSizes;
}


static scalar volume(const meshLists& mesh)
{
    scalar sum = 0;
    forAll(mesh.faces, f)
    {
        if (f >= mesh.neighbour.size())
        {
            const face& t = mesh.faces[f];
            sum += (t.centre(mesh.points) & t.areaNormal(mesh.points))/3;
        }
    }
    return sum;
}


// What must be so whatever the repair has done
static void checkRepaired
(
    checks& c, const meshLists& before, const meshLists& after, boxScene& s
)
{
    autoPtr<fvMesh> mesh(s.fluid(after, "repaired"));
    c.check("repaired: OpenFOAM's topology check", !mesh->checkTopology(false));
    c.check("repaired: OpenFOAM's geometry check", !mesh->checkGeometry(false));
    c.checkClose
    (
        "repaired: cells fill the box around the bodies",
        gSum(mesh->cellVolumes()), volume(before), 1e-12
    );
    bool boundary = after.patchSizes == before.patchSizes;
    scalar moved = 0, off = 0;
    forAll(before.patchNames, patchi)
    {
        const bool body = s.names.found(before.patchNames[patchi]);
        for (label i = 0; i < before.patchSizes[patchi]; ++i)
        {
            const face& f = before.faces[before.patchStarts[patchi] + i];
            boundary = boundary
             && after.faces[after.patchStarts[patchi] + i] == f;
            const vector n(f.unitNormal(before.points));
            for (const label p : f)
            {
                const vector by(after.points[p] - before.points[p]);
                (body ? moved : off) = max(body ? moved : off, body ? mag(by) : mag(n & by));
            }
        }
    }
    c.check("repaired: the boundary's faces stay, in order", boundary);
    c.checkBelow("repaired: the bodies' points stay", moved, 0);
    // bound: round-off of coordinates up to 6
    c.checkBelow("repaired: walls stay plane, edges where they are", off, 1e-14);
    c.checkBelow
    (
        "repaired: non-orthogonality by OpenFOAM",
        meshQuality(mesh()).maxNonOrthogonality, 60
    );
}


static void checkRepair(checks& c, passed& p)
{
    meshRepair untouched(p.worn, p.s.names);
    meshLists mesh(p.worn);
    untouched.putInto(mesh);
    c.check("cells put back without a change are the same", same(mesh, p.worn));

    const auto repaired = [&p, &mesh]()
    {
        meshRepair repair(p.worn, p.s.names);
        mesh = p.worn;
        repair.run(60);
        repair.putInto(mesh);
        return mesh;
    };
    const meshQuality before(p.worn);
    cpuTime clock;
    repaired();
    const scalar seconds = clock.elapsedCpuTime();
    const meshQuality after(mesh);
    Info<< "    " << before.nCells << " cells repaired in " << seconds
        << " s: non-orthogonality " << before.maxNonOrthogonality << " to "
        << after.maxNonOrthogonality << ", mean " << before.meanNonOrthogonality
        << " to " << after.meanNonOrthogonality << endl;
    checkRepaired(c, p.worn, mesh, p.s);
    const meshLists first(mesh);
    c.check("repaired again it is the same", same(first, repaired()));
    c.checkBelow
    (
        "repaired: mean non-orthogonality", after.meanNonOrthogonality,
        before.meanNonOrthogonality
    );

    // cells that neither of them touches are most, and keep their numbers
    label kept = 0;
    for (label f = 0; f < p.worn.neighbour.size(); ++f)
    {
        kept +=
            f < first.neighbour.size() && first.faces[f] == p.worn.faces[f];
    }
    Info<< "    " << kept << " of " << p.worn.neighbour.size()
        << " faces keep points and number" << endl;
}


// Round-off, as between different numbers of processors
static void checkRoundOff(checks& c, const passed& p)
{
    const auto faces = [&p](const meshLists& worn)
    {
        meshLists mesh(worn);
        meshRepair repair(worn, p.s.names);
        repair.run(60);
        repair.putInto(mesh);
        return mesh;
    };
    const meshLists exact(faces(p.worn));
    bool turned = false;
    scalar moved = 0;
    for (label i = 1; i <= 5; ++i)
    {
        meshLists disturbed(p.worn);
        forAll(disturbed.points, v)
        {
            const scalar by = 1e-13*((v*i*7919) % 201 - 100);
            disturbed.points[v] += vector(by, -by, by);
        }
        const meshLists other(faces(disturbed));
        turned = turned || other.faces != exact.faces;
        moved = max(moved, max(mag(other.points - exact.points)));
    }
    c.check("round-off turns no edge of a repaired mesh", !turned);
    // bound: the disturbance, a hundred times: positions are relative to others
    c.checkBelow("round-off moves no point of a repaired mesh", moved, 1e-9);
}


static void checkHealed(checks& c, passed& p)
{
    const sizeFunction sizes(p.sizes());
    const freshMesh fresh(p.fresh, sizes);
    const auto healed = [&](const meshLists& worn, const std::string& limits)
    {
        meshLists mesh(worn);
        return heal(mesh, remeshControls(dict(limits)), fresh, sizes, p.s.names);
    };
    const outcome well(healed(p.worn, ""));
    c.check("a degraded mesh is healed", well.ok, well.reason);
    c.check
    (
        "a limit that no mesh meets is not met by healing",
        !healed(p.worn, "maxNonOrthogonality 20;")
    );
    freshMesh better(fresh);
    better.mean -= 5;
    meshLists mesh(p.worn);
    c.check
    (
        "a mesh whose mean has drifted is not healed",
        heal(mesh, remeshControls(dictionary()), better, sizes, p.s.names).reason.find("mean")
     != string::npos
    );
    mesh = p.worn;
    c.check
    (
        "nor is one with other sizes than wanted",
        heal
        (
            mesh, remeshControls(dictionary()), fresh,
            [&](const point& x) { return 2*sizes(x); }, p.s.names
        ).reason.find("long") != string::npos
    );
    const meshLists box(wholeMesh::lists(p.s.box()));
    c.check
    (
        "nor is one of hexahedra",
        healed(box, "").reason.find("tetrahedra") != string::npos
    );
}


static void checkJoined(checks& c, const passed& p)
{
    const labelList rank(meshDistribution::bisect(p.worn, 3));
    PtrList<meshDistribution> parts;
    List<const meshPiece*> pieces;
    for (label r = 0; r < 3; ++r)
    {
        parts.append(new meshDistribution(p.worn, rank, r));
        pieces.append(&parts.last());
    }
    c.check("parts are joined to the same mesh", same(joined(pieces), p.worn));
    pieces.setSize(2);
    c.check("some of them to none", !joined(pieces).valid());
}


void checkHealing(checks& c)
{
    passed p;
    checkRepair(c, p);
    checkRoundOff(c, p);
    checkHealed(c, p);
    checkJoined(c, p);
}

} // End namespace fsbi
} // End namespace Foam
