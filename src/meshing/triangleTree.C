/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleTree.H"
#include "triFace.H"

#include <algorithm>
#include <numeric>

namespace Foam
{
namespace fsbi
{

//- Most triangles of a leaf
static const label leafSize = 4;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::triangleTree::add
(
    const bodySurface& surface, const pointField& centres,
    std::vector<label>& order, const label first, const label n
)
{
    const label me = nodes_.size();
    nodes_.push_back({point::max, point::min, 0, n <= leafSize ? n : 0});
    for (label i = first; i < first + n; ++i)
    {
        for (const label p : surface.triangles()[order[i]])
        {
            nodes_[me].min = min(nodes_[me].min, surface.points()[p]);
            nodes_[me].max = max(nodes_[me].max, surface.points()[p]);
        }
    }
    if (n <= leafSize)
    {
        nodes_[me].next = corners_.size()/3;
        for (label i = first; i < first + n; ++i)
        {
            for (const label p : surface.triangles()[order[i]])
            {
                corners_.push_back(surface.points()[p]);
            }
        }
        return;
    }
    const vector span(nodes_[me].max - nodes_[me].min);
    const direction d =
        span.x() >= span.y() && span.x() >= span.z() ? 0
      : span.y() >= span.z() ? 1 : 2;
    std::nth_element
    (
        order.begin() + first, order.begin() + first + n/2,
        order.begin() + first + n,
        [&](const label a, const label b)
        {
            return centres[a][d] < centres[b][d]
                || (centres[a][d] == centres[b][d] && a < b);
        }
    );
    add(surface, centres, order, first, n/2);
    nodes_[me].next = nodes_.size();
    add(surface, centres, order, first + n/2, n - n/2);
}


inline Foam::scalar Foam::fsbi::triangleTree::sqrDistance
(
    const node& box, const point& p
)
{
    scalar sum = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar out = max(max(box.min[d] - p[d], p[d] - box.max[d]), 0);
        sum += sqr(out);
    }
    return sum;
}


// C. Ericson, Real-Time Collision Detection (2005), 5.1.5
inline Foam::scalar Foam::fsbi::triangleTree::sqrDistance
(
    const point* corners, const point& p
)
{
    const vector ab(corners[1] - corners[0]), ac(corners[2] - corners[0]);
    const vector ap(p - corners[0]);
    const scalar d1 = ab & ap, d2 = ac & ap;
    if (d1 <= 0 && d2 <= 0)
    {
        return magSqr(ap);
    }
    const vector bp(ap - ab);
    const scalar d3 = ab & bp, d4 = ac & bp;
    if (d3 >= 0 && d4 <= d3)
    {
        return magSqr(bp);
    }
    const scalar vc = d1*d4 - d3*d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
    {
        return magSqr(ap - d1/(d1 - d3)*ab);
    }
    const vector cp(ap - ac);
    const scalar d5 = ab & cp, d6 = ac & cp;
    if (d6 >= 0 && d5 <= d6)
    {
        return magSqr(cp);
    }
    const scalar vb = d5*d2 - d1*d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
    {
        return magSqr(ap - d2/(d2 - d6)*ac);
    }
    const scalar va = d3*d6 - d5*d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6)
    {
        return magSqr(bp - (d4 - d3)/((d4 - d3) + (d5 - d6))*(ac - ab));
    }
    return magSqr(ap - (vb*ab + vc*ac)/(va + vb + vc));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::triangleTree::triangleTree(const bodySurface& surface)
{
    const List<triFace>& triangles = surface.triangles();
    pointField centres(triangles.size());
    forAll(centres, i)
    {
        centres[i] = triangles[i].centre(surface.points());
    }
    std::vector<label> order(triangles.size());
    std::iota(order.begin(), order.end(), 0);
    if (order.size())
    {
        add(surface, centres, order, 0, order.size());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::triangleTree::atLeast(const point& p) const
{
    return nodes_.size() ? Foam::sqrt(sqrDistance(nodes_[0], p)) : GREAT;
}


bool Foam::fsbi::triangleTree::find
(
    const point& p, const scalar reach, scalar& distance
) const
{
    // halves the triangles with every level: never as deep
    label stack[64];
    label n = 0;
    scalar least = sqr(reach);
    bool found = false;
    if (nodes_.size())
    {
        stack[n++] = 0;
    }
    while (n)
    {
        const label i = stack[--n];
        const node& here = nodes_[i];
        if (sqrDistance(here, p) > least)
        {
            continue;
        }
        for (label k = 3*here.next; k < 3*(here.next + here.n); k += 3)
        {
            const scalar d = sqrDistance(&corners_[k], p);
            if (d < least || (!found && d <= least))
            {
                least = d;
                found = true;
            }
        }
        if (!here.n)
        {
            const label a = i + 1, b = here.next;
            const bool aFirst =
                sqrDistance(nodes_[a], p) < sqrDistance(nodes_[b], p);
            stack[n++] = aFirst ? b : a;
            stack[n++] = aFirst ? a : b;
        }
    }
    if (found)
    {
        distance = Foam::sqrt(least);
    }
    return found;
}


Foam::fsbi::bodySurface Foam::fsbi::triangleTree::surface() const
{
    pointField points(corners_.size());
    std::copy(corners_.begin(), corners_.end(), points.begin());
    List<triFace> triangles(points.size()/3);
    forAll(triangles, i)
    {
        triangles[i] = triFace(3*i, 3*i + 1, 3*i + 2);
    }
    return bodySurface(points, triangles);
}
