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
    const bool described,
    neighbour& n
)
{
    const scalar more = described ? now.standsOut(other) : 0;
    currentSurfaces::nearestPoint c;
    if (!now.findSide(body, other, way, n.centre, reach + more, c))
    {
        return false;
    }
    if (described)
    {
        now.takeOut(other, n.centre, c);
    }
    n.gap = c.gap;
    n.normal = c.normal;
    n.nearest = c.nearest;
    n.way = way;
    n.otherTriangle = c.triangle;
    return n.gap < reach;
}


//- Calls visit(n) with place and centre set, for a triangle or its parts
template<class Visitor>
static void visitPlaces
(
    const currentSurfaces& now,
    const label body,
    const label triangle,
    const label divisions,
    const Visitor& visit
)
{
    neighbour n;
    n.place = materialPoint::centroid(triangle);
    n.centre = now.centroid(body, triangle);
    if (divisions == 0)
    {
        visit(n);
        return;
    }
    materialPoint::visitParts
    (
        divisions, [&](const scalar i, const scalar j, const scalar side)
        {
            n.place.b = (i + side/3)/divisions;
            n.place.c = (j + side/3)/divisions;
            n.centre = now.position(body, n.place);
            visit(n);
        }
    );
}

} // End namespace fsbi
} // End namespace Foam


Foam::DynamicList<Foam::fsbi::neighbour> Foam::fsbi::neighbours
(
    const currentSurfaces& now,
    const label body,
    const label other,
    const scalar reach,
    const label divisions
)
{
    DynamicList<neighbour> found;
    if (!now.present(body) || !now.present(other))
    {
        return found;
    }
    // no part of a triangle is farther from its centre, nor what it stands for
    const label n = now.surface(body).triangles().size();
    scalar around = 0;
    for (label t = 0; divisions > 0 && t < n; ++t)
    {
        around = max(around, now.longestEdge(body, t) + now.standsOut(body));
    }
    if (now.isPlane(other))
    {
        const domainWall& wall = now.wall(other);
        const auto look = [&](neighbour& at)
        {
            if (nearPlane(wall, reach, at))
            {
                found.append(at);
            }
        };
        for (label t = 0; t < n; ++t)
        {
            if (wall.distance(now.centroid(body, t)) < reach + around)
            {
                visitPlaces(now, body, t, divisions, look);
            }
        }
        return found;
    }
    for (const vector& way : now.ways(body == other))
    {
        const scalar within = reach + now.depth(body, other) + around
          + (divisions ? now.standsOut(other) : 0);
        const boundBox box(now.bounds(other, way, within));
        if (!box.overlaps(now.surface(body).bounds()))
        {
            continue;
        }
        const auto look = [&](neighbour& at)
        {
            if (nearImage(now, body, other, way, reach, divisions > 0, at))
            {
                found.append(at);
            }
        };
        for (label t = 0; t < n; ++t)
        {
            if (box.contains(now.centroid(body, t)))
            {
                visitPlaces(now, body, t, divisions, look);
            }
        }
    }
    return found;
}


Foam::label Foam::fsbi::partsPerEdge
(
    const immersedBody& body,
    const scalar range,
    const scalar part,
    const label most
)
{
    const scalar zone = Foam::sqrt(2*min(body.radius(), GREAT)*range);
    const scalar parts = body.stressFree().meanEdge()/(part*zone);
    return max(1, min(most, label(std::ceil(parts))));
}
