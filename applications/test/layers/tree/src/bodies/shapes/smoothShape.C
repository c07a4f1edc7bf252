/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "smoothShape.H"
#include "surfaceRemesher.H"
#include "edgeHashes.H"

namespace Foam
{
namespace fsbi
{

static const scalar golden = (1 + Foam::sqrt(scalar(5)))/2;

// The 12 corners and 20 outward triangles of the icosahedron
static bodySurface icosahedron()
{
    const scalar g = golden;
    pointField corners
    ({
        {-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
        {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
        {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}
    });
    const label faces[20][3] =
    {
        {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11},
        {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9},
        {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}
    };
    List<triFace> triangles(20);
    forAll(triangles, i)
    {
        triangles[i] = triFace(faces[i][0], faces[i][1], faces[i][2]);
    }
    return bodySurface(std::move(corners), std::move(triangles));
}


// Each triangle split in n*n; points shared between triangles are made once
class subdivision
{
    const bodySurface& base_;
    const label n_;
    EdgeMap<labelList> edgePoints_;

public:

    DynamicList<point> points;
    DynamicList<triFace> triangles;

    subdivision(const bodySurface& base, const label n)
    :
        base_(base),
        n_(n),
        points(base.points())
    {
        for (const triFace& t : base_.triangles())
        {
            split(t);
        }
    }

private:

    // Inner points of the edge, from a to b
    labelList between(const label a, const label b)
    {
        const edge e(min(a, b), max(a, b));
        labelList& inner = edgePoints_(e);
        if (inner.empty())
        {
            const pointField& p = base_.points();
            for (label i = 1; i < n_; ++i)
            {
                inner.append(points.size());
                points.append(p[e[0]] + scalar(i)/n_*(p[e[1]] - p[e[0]]));
            }
        }
        labelList result(inner);
        if (a > b)
        {
            reverse(result);
        }
        return result;
    }

    // Row i runs from edge ab to edge ac at i/n of the way from corner a
    labelList row(const triFace& t, const label i, const labelListList& sides)
    {
        labelList line(i + 1);
        line[0] = i == 0 ? t[0] : i == n_ ? t[1] : sides[0][i - 1];
        line[i] = i == 0 ? t[0] : i == n_ ? t[2] : sides[1][i - 1];
        for (label j = 1; j < i; ++j)
        {
            if (i == n_)
            {
                line[j] = sides[2][j - 1];
                continue;
            }
            const scalar f = scalar(j)/i;
            line[j] = points.size();
            points.append((1 - f)*points[line[0]] + f*points[line[i]]);
        }
        return line;
    }

    void split(const triFace& t)
    {
        const labelListList sides
        ({
            between(t[0], t[1]), between(t[0], t[2]), between(t[1], t[2])
        });
        labelList above(row(t, 0, sides));
        for (label i = 1; i <= n_; ++i)
        {
            const labelList line(row(t, i, sides));
            for (label j = 0; j < i; ++j)
            {
                triangles.append(triFace(above[j], line[j], line[j + 1]));
                if (j + 1 < i)
                {
                    triangles.append
                    (
                        triFace(above[j], line[j + 1], above[j + 1])
                    );
                }
            }
            above = line;
        }
    }
};


// Move the points to the mean of their neighbours, back onto the unit sphere
static void smoothOnSphere
(
    pointField& points, const List<triFace>& triangles, const label sweeps
)
{
    for (label sweep = 0; sweep < sweeps; ++sweep)
    {
        vectorField sum(points.size(), Zero);
        for (const triFace& t : triangles)
        {
            const vector centre(t.centre(points));
            const scalar area = t.mag(points);
            for (const label p : t)
            {
                sum[p] += area*centre;
            }
        }
        points = sum/mag(sum);
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::smoothShape::geodesicSphere(const label n)
{
    const bodySurface base(icosahedron());
    subdivision fine(base, n);
    pointField points(fine.points);
    points /= mag(points);
    // equalises the areas, 2:1 before, without moving the symmetry planes
    smoothOnSphere(points, fine.triangles, 10*n);
    return bodySurface(std::move(points), List<triFace>(fine.triangles));
}


Foam::fsbi::bodySurface Foam::fsbi::smoothShape::imageOf
(
    const bodySurface& unitSphere
) const
{
    pointField points(unitSphere.points());
    for (point& p : points)
    {
        p = image(p);
    }
    return bodySurface(points, unitSphere.triangles());
}


Foam::fsbi::bodySurface Foam::fsbi::smoothShape::make(const scalar size) const
{
    // frequency: 20 n^2 equilateral triangles of that edge cover the area
    const scalar area = imageOf(geodesicSphere(8)).area();
    checkNumber(area, size);
    const scalar wanted = area/(Foam::sqrt(3.0)/4*sqr(size));
    const label n = max(1, label(Foam::sqrt(wanted/20) + 0.5));

    bodySurface surface(imageOf(geodesicSphere(n)));
    if (stretches())
    {
        surface = surfaceRemesher
        (
            surface, size, [this](const point& p){ return project(p); }
        ).run();
    }
    const scalar exact = exactVolume();
    return
        exact > 0
      ? surface.scaled(Foam::cbrt(exact/surface.volume()))
      : surface;
}
