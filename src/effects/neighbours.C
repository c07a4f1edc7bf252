/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbours.H"

namespace Foam
{
namespace fsbi
{

//- Near a plane wall; a point far behind it is near, too
static bool nearPlane
(
    const domainWall& wall, const scalar reach, neighbour& n
)
{
    n.gap = wall.distance(n.centre);
    n.normal = wall.normal;
    n.nearest = n.centre - n.gap*n.normal;
    n.otherTriangle = -1;
    n.way = Zero;
    return n.gap < reach;
}


//- Near an image of a body or of another wall
static bool nearImage
(
    const currentSurfaces& now,
    const label other,
    const vector& way,
    const scalar reach,
    neighbour& n
)
{
    currentSurfaces::nearestPoint c;
    if (!now.findImage(other, way, n.centre, now.behind(other, reach), c))
    {
        return false;
    }
    // which side: by the nearest triangle's own normal
    const bodySurface& s = now.surface(other);
    const vector outwards
    (
        s.triangles()[c.triangle].tri(s.points()).areaNormal()
    );
    const scalar side = (c.normal & outwards) < 0 ? -1 : 1;
    n.gap = side*c.gap;
    n.normal = side*c.normal;
    n.nearest = c.nearest;
    n.way = way;
    n.otherTriangle = c.triangle;
    return n.gap < reach;
}

} // End namespace fsbi
} // End namespace Foam


Foam::DynamicList<Foam::fsbi::neighbour> Foam::fsbi::neighbours
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const scalar reach
)
{
    DynamicList<neighbour> found;
    if (!now.present(body) || !now.present(other))
    {
        return found;
    }
    if (now.isPlane(other))
    {
        forAll(now.surface(body).triangles(), t)
        {
            neighbour n;
            n.triangle = t;
            n.centre = now.centroid(body, t);
            if (nearPlane(now.wall(other), reach, n))
            {
                found.append(n);
            }
        }
        return found;
    }
    for (const vector& way : now.ways(body == other))
    {
        const boundBox box(now.bounds(other, way, reach));
        if (!box.overlaps(now.surface(body).bounds()))
        {
            continue;
        }
        forAll(now.surface(body).triangles(), t)
        {
            neighbour n;
            n.triangle = t;
            n.centre = now.centroid(body, t);
            if
            (
                box.contains(n.centre)
             && nearImage(now, other, way, reach, n)
            )
            {
                found.append(n);
            }
        }
    }
    return found;
}
