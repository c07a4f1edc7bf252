/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallFacets.H"
#include "materialPoint.H"
#include "mergePoints.H"

#include <algorithm>

namespace Foam
{
namespace fsbi
{

//- Of the surface's size: corners nearer than that are one
static const scalar roundOff = 1e-9;

//- Weight of a corner below which a point of a triangle is on the edge opposite
static const scalar onEdge = 1e-9;

static bodySurface merged(const bodySurface& surface)
{
    labelList number;
    pointField points;
    mergePoints
    (
        surface.points(), roundOff*surface.bounds().mag(), false, number, points
    );
    List<triFace> triangles(surface.triangles());
    for (triFace& t : triangles)
    {
        t = triFace(number[t[0]], number[t[1]], number[t[2]]);
    }
    return bodySurface::open(points, triangles);
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::wallFacets::wallFacets(const bodySurface& surface)
:
    surface_(merged(surface)),
    search_(surface_.points(), surface_.triangles()),
    triangles_(surface_.points().size())
{
    List<DynamicList<label>> at(surface_.points().size());
    forAll(surface_.triangles(), t)
    {
        for (const label p : surface_.triangles()[t])
        {
            at[p].append(t);
        }
    }
    forAll(at, p)
    {
        triangles_[p] = at[p];
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::DynamicList<Foam::label> Foam::fsbi::wallFacets::around
(
    const label a, const label b
) const
{
    DynamicList<label> found;
    for (const label t : triangles_[a])
    {
        if (surface_.triangles()[t].found(b))
        {
            found.append(t);
        }
    }
    return found;
}


bool Foam::fsbi::wallFacets::onBorder(const label a, const label b) const
{
    if (a != b)
    {
        return around(a, b).size() == 1;
    }
    for (const label t : triangles_[a])
    {
        for (const label other : surface_.triangles()[t])
        {
            if (other != a && onBorder(a, other))
            {
                return true;
            }
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsbi::wallFacets::behind(const point& p, const label triangle) const
{
    const List<triFace>& all = surface_.triangles();
    const materialPoint nearest
    (
        materialPoint::nearest(triangle, p, surface_.points(), all)
    );
    const vector towards(p - nearest.on(surface_.points(), all));
    const auto isBehind = [&](const label t)
    {
        return (towards & all[t].areaNormal(surface_.points())) < 0;
    };
    DynamicList<label> corners;
    forAll(all[triangle], i)
    {
        if (nearest.weights()[i] > onEdge)
        {
            corners.append(all[triangle][i]);
        }
    }
    if (corners.size() == 3)
    {
        return isBehind(triangle);
    }
    const DynamicList<label> at(around(corners[0], corners.last()));
    return
        !onBorder(corners[0], corners.last())
     && std::all_of(at.begin(), at.end(), isBehind);
}
