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
    const label body,
    const label other,
    const vector& way,
    const scalar reach,
    neighbour& n
)
{
    currentSurfaces::nearestPoint c;
    if (!now.findSide(body, other, way, n.centre, reach, c))
    {
        return false;
    }
    n.gap = c.gap;
    n.normal = c.normal;
    n.nearest = c.nearest;
    n.way = way;
    n.otherTriangle = c.triangle;
    return true;
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
        const boundBox box
        (
            now.bounds(other, way, reach + now.depth(body, other))
        );
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
             && nearImage(now, body, other, way, reach, n)
            )
            {
                found.append(n);
            }
        }
    }
    return found;
}
