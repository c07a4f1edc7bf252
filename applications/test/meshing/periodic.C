/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodic.H"
#include "boxScene.H"
#include "bentCell.H"
#include "imageChoice.H"
#include "inverseDistanceMotion.H"

namespace Foam
{
namespace fsbi
{

static const vector eight(8, 0, 0);

//- Faces and points of the second patch are those of the first, a period further
static scalar mismatch(const polyMesh& mesh)
{
    const polyPatch& one = mesh.boundaryMesh()[0];
    const polyPatch& other = mesh.boundaryMesh()[1];
    const vectorField apart(other.faceCentres() - one.faceCentres() - eight);
    scalar error = max(mag(apart));
    forAll(one, f)
    {
        const vector ofPoints
        (
            mesh.points()[other[f][0]] - mesh.points()[one[f][0]] - eight
        );
        error = max(error, mag(ofPoints));
    }
    return error;
}


static void checkInside(checks& c)
{
    boxScene s("cyclic");
    s.add(shape("type sphere; radius 1;", 0.25), point(2.6, 0.5, 3));
    const meshLists mesh(s.generate());
    checkMesh(c, "cyclic", s, mesh);
    c.checkBelow("cyclic: faces match", mismatch(s.fluid(mesh)()), 1e-8);
}


//- Where all sides are cyclic points between bodies go with all of them
static void checkWithoutWalls
(
    checks& c, const boxScene& s, const polyMesh& fluid
)
{
    const inverseDistanceMotion motion
    (
        fluid, fluid.boundaryMesh().names(), s.bodies, s.placements,
        List<vector>({-eight, eight})
    );
    List<placement> now(s.placements);
    const vector way(0.05, 0, 0);
    now[0].centre += way;
    now[1].centre -= way;
    scalar farthest = 0;
    const vectorField moves(motion.move(now, Zero) - fluid.points());
    for (const vector& move : moves)
    {
        farthest = max(farthest, min(mag(move - way), mag(move + way)));
    }
    // bound: in the middle they do not go at all
    c.checkClose
    (
        "without walls: between bodies that part nothing moves",
        farthest/mag(way), 1, 0.05
    );
}


static void checkAcross(checks& c)
{
    boxScene s("cyclic");
    const bodySurface sphere(shape("type sphere; radius 1;", 0.25));
    s.add(sphere, point(3.9, 0.5, 3));
    s.add(sphere, point(-3.2, -1.8, 3.5));
    const meshLists mesh(s.generate());
    checkMesh(c, "across", s, mesh);
    autoPtr<fvMesh> fluid(s.fluid(mesh));
    c.checkBelow("across: faces match", mismatch(fluid()), 1e-8);

    // both move and turn as far as meshes go with them
    const List<vector> images({-eight, eight});
    const inverseDistanceMotion motion
    (
        fluid(), s.names, s.bodies, s.placements, images
    );
    List<placement> now(s.placements);
    now[0].centre += vector(0.05, 0.02, 0);
    now[0].orientation = quaternion(vector(0, 1, 0), 0.1);
    now[1].centre -= vector(0.05, 0.02, 0);
    const pointField before(fluid->points());
    fluid->polyMesh::movePoints(motion.move(now, Zero));
    c.checkBelow("across: faces match when moved", mismatch(fluid()), 1e-8);
    c.check("across: volumes stay positive", meshQuality(fluid()).minVolume > 0);
    const labelList& onSide = fluid->boundaryMesh()[0].meshPoints();
    c.check
    (
        "across: cyclic patches move",
        max(mag(pointField(fluid->points(), onSide) - pointField(before, onSide)))
      > 0.01
    );
    c.checkClose
    (
        "across: volume stays", sum(fluid->cellVolumes()),
        sum(s.box->cellVolumes()) - 2*sphere.volume(), 1e-10
    );

    checkWithoutWalls(c, s, fluid());

    s.bodies.resize(1);
    s.names.resize(1);
    s.add(sphere, point(-3, 0.5, 3));
    const string reason(s.generate().failure);
    c.check
    (
        "an overlap across a cyclic patch is refused",
        reason.find("a period further") != string::npos,
        reason
    );
}


static List<boundBox> boxesOf(const UList<point>& centres)
{
    List<boundBox> boxes(centres.size());
    forAll(boxes, i)
    {
        boxes[i] = boundBox(centres[i] - vector::one, centres[i] + vector::one);
    }
    return boxes;
}


//- Two bodies side by side, a plane between their centres; none across it
static void checkChoice(checks& c)
{
    period x;
    x.side = pointField({point(-4, 0, 0), point(-4, 1, 0), point(-4, 0, 1)});
    x.translation = eight;
    const List<period> one(1, x);
    const pointField centres({point(3.9, 0, 0), point(12.05, 2.1, 0)});
    const vectorField ways
    (
        imageChoice(one, centres, scalarField(2, 1.0), boxesOf(centres), Zero)
    );
    c.checkClose
    (
        "images side by side go together",
        ((centres[0] + ways[0]) - (centres[1] + ways[1])) & vector(1, 0, 0),
        -0.15, 1e-10
    );
    const pointField within({point(-2, 0, 0), point(2.9, 1, 0)});
    c.checkBelow
    (
        "a cell that no body leaves is taken as it is",
        max
        (
            mag(imageChoice(one, within, scalarField(2, 1.0), boxesOf(within), Zero))
        ), 0
    );
    c.checkBelow
    (
        "ways are periods",
        mag(ways[0].x()/8 - std::round(ways[0].x()/8))
      + mag(ways[1].x()/8 - std::round(ways[1].x()/8)), 1e-14
    );
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::checkPeriodic(checks& c)
{
    checkInside(c);
    checkAcross(c);
    checkChoice(c);
}
