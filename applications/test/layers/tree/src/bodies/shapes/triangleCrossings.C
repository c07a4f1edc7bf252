/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleCrossings.H"
#include "boundBox.H"

#include <algorithm>
#include <vector>

namespace Foam
{
namespace fsbi
{

// Does the open segment a-b pass through the triangle? (Moller & Trumbore)
static bool pierces
(
    const point& a, const point& b,
    const point& p, const point& q, const point& r
)
{
    const vector d(b - a), e(q - p), f(r - p);
    const vector h(d ^ f);
    const scalar det = e & h;
    if (mag(det) < 1e-14*mag(d)*mag(e)*mag(f))
    {
        return false;
    }
    const vector s(a - p);
    const scalar u = (s & h)/det;
    const vector w(s ^ e);
    const scalar v = (d & w)/det;
    const scalar t = (f & w)/det;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}


// The edges of one against the other, leaving out edges at a shared point
static bool edgesPierce
(
    const UList<point>& points, const triFace& one, const triFace& other
)
{
    for (label i = 0; i < 3; ++i)
    {
        const label a = one[i], b = one[(i + 1) % 3];
        if
        (
           !other.found(a) && !other.found(b)
         && pierces
            (
                points[a], points[b],
                points[other[0]], points[other[1]], points[other[2]]
            )
        )
        {
            return true;
        }
    }
    return false;
}


static bool cross
(
    const UList<point>& points, const triFace& a, const triFace& b
)
{
    label shared = 0;
    for (const label p : a)
    {
        shared += b.found(p);
    }
    return shared < 2 && (edgesPierce(points, a, b) || edgesPierce(points, b, a));
}


// Triangles by the grid cells their bounding boxes cover, sorted by cell
struct triangleGrid
{
    typedef std::pair<int64_t, label> item;

    std::vector<boundBox> boxes;
    std::vector<item> items;

    triangleGrid(const UList<point>& points, const UList<triFace>& triangles)
    {
        boundBox all;
        scalar size = 0;
        for (const triFace& t : triangles)
        {
            boundBox box;
            for (const label p : t)
            {
                box.add(points[p]);
            }
            boxes.push_back(box);
            all.add(box);
            size += box.mag()/triangles.size();
        }

        // large triangles among small ones: coarsen rather than fill memory
        while (!fill(all.min(), size, 40*triangles.size() + 1000))
        {
            size *= 2;
        }
        std::sort(items.begin(), items.end());
    }

    bool fill(const point& origin, const scalar size, const size_t limit)
    {
        items.clear();
        for (size_t i = 0; i < boxes.size(); ++i)
        {
            int64_t from[3], to[3];
            scalar count = 1;
            for (direction d = 0; d < 3; ++d)
            {
                from[d] = int64_t((boxes[i].min()[d] - origin[d])/size);
                to[d] = int64_t((boxes[i].max()[d] - origin[d])/size);
                count *= to[d] - from[d] + 1;
            }
            if (items.size() + count > limit)
            {
                return false;
            }
            for (int64_t x = from[0]; x <= to[0]; ++x)
            for (int64_t y = from[1]; y <= to[1]; ++y)
            for (int64_t z = from[2]; z <= to[2]; ++z)
            {
                items.push_back({(x << 42) + (y << 21) + z, label(i)});
            }
        }
        return true;
    }
};


labelPair triangleCrossing
(
    const UList<point>& points,
    const UList<triFace>& triangles,
    const labelUList& group,
    const label skippedGroup
)
{
    const triangleGrid grid(points, triangles);
    const auto& items = grid.items;
    const auto skipped = [&](const label i)
    {
        return i < group.size() && group[i] == skippedGroup;
    };

    for (size_t i = 0; i < items.size(); ++i)
    {
        const label a = items[i].second;
        for
        (
            size_t j = i + 1;
            j < items.size() && items[j].first == items[i].first;
            ++j
        )
        {
            const label b = items[j].second;
            if
            (
                grid.boxes[a].overlaps(grid.boxes[b])
            && !(skipped(a) && skipped(b))
             && cross(points, triangles[a], triangles[b])
            )
            {
                return labelPair(a, b);
            }
        }
    }
    return labelPair(-1, -1);
}

} // End namespace fsbi
} // End namespace Foam
