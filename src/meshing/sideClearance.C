/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideClearance.H"

namespace Foam
{
namespace fsbi
{

//- Distance wanted where there is room, in edges of the body
static const scalar wanted = 0.7;

//- Rounds in which points move, each by this part of what they lack, and rounds
//  before the last of them in which they go to the middle, by this part
static const label rounds = 30;
static const scalar part = 0.5;
static const label smoothed = 20;
static const scalar toTheMiddle = 0.2;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::sideClearance::sideClearance
(
    const UList<bodySurface>& bodies,
    const UList<vector>& images,
    const boundBox& cell
)
:
    edges_(bodies.size())
{
    DynamicList<vector> ways(images);
    ways.append(Zero);
    forAll(bodies, b)
    {
        const bodySurface& body = bodies[b];
        surfaces_.append(new surfaceDistance(body.points(), body.triangles()));
        edges_[b] = body.meanEdge();
        for (const vector& way : ways)
        {
            boundBox box(body.bounds());
            box.min() += way - 2*edges_[b]*vector::one;
            box.max() += way + 2*edges_[b]*vector::one;
            if (box.overlaps(cell))
            {
                standing_.append(standing{b, way, box});
            }
        }
    }
}


Foam::vector Foam::fsbi::sideClearance::away(const point& x) const
{
    scalar first = GREAT, second = GREAT, edge = 0;
    vector out(Zero);
    for (const standing& s : standing_)
    {
        point q;
        label triangle;
        const scalar reach = 2*edges_[s.surface];
        if
        (
            !s.box.contains(x)
         || !surfaces_[s.surface].find(x - s.off, GREAT, q, triangle)
        )
        {
            continue;
        }
        const vector r(x - s.off - q);
        const bool inside = surfaces_[s.surface].contains(x - s.off);
        const scalar d = (inside ? -1 : 1)*mag(r);
        if (d > reach)
        {
            continue;
        }
        second = min(second, max(first, d));
        if (d < first)
        {
            first = d;
            edge = edges_[s.surface];
            out = r/(mag(d) > VSMALL ? d : VSMALL);
        }
    }
    const scalar clear = min(wanted*edge, 0.5*(first + second));
    return first < clear ? (clear - first)*out : vector(Zero);
}


Foam::vectorField Foam::fsbi::sideClearance::toMiddle
(
    const UList<point>& points,
    const UList<edge>& lines,
    const labelUList& alike,
    const label n
)
{
    vectorField sum(n, Zero);
    scalarField count(n, Zero);
    for (const edge& line : lines)
    {
        const vector way(line.vec(points));
        sum[alike[line.start()]] += way;
        sum[alike[line.end()]] -= way;
        ++count[alike[line.start()]];
        ++count[alike[line.end()]];
    }
    forAll(sum, i)
    {
        sum[i] /= max(count[i], 1);
    }
    return sum;
}


void Foam::fsbi::sideClearance::apply
(
    pointField& points,
    const UList<edge>& lines,
    const labelUList& alike,
    const UList<DynamicList<vector>>& normals
) const
{
    const label n = max(label(0), max(alike) + 1);
    for (label round = 0; round < rounds; ++round)
    {
        vectorField moves(n, Zero);
        if (round < smoothed)
        {
            moves = toTheMiddle*toMiddle(points, lines, alike, n);
        }
        // the first of those alike stands for all
        boolList known(n, false);
        forAll(points, p)
        {
            const label i = alike[p];
            if (i >= 0 && !known[i])
            {
                known[i] = true;
                moves[i] += part*away(points[p] + moves[i]);
            }
        }
        forAll(points, p)
        {
            if (alike[p] >= 0)
            {
                vector& move = moves[alike[p]];
                for (const vector& normal : normals[p])
                {
                    move -= (move & normal)*normal;
                }
            }
        }
        forAll(points, p)
        {
            if (alike[p] >= 0)
            {
                points[p] += moves[alike[p]];
            }
        }
    }
}
