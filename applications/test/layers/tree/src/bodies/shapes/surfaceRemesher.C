/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRemesher.H"

namespace Foam
{
namespace fsbi
{

//- Twice the area of a triangle that has none, as three points of a line make it,
//  over the size squared
static const scalar flat = 1e-3;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::surfaceRemesher::connect()
{
    std::unordered_map<uint64_t, label> known;
    edges_.clear();
    around_.clear();
    around_.setSize(points_.size());
    forAll(triangles_, i)
    {
        const triFace& t = triangles_[i];
        for (label j = 0; j < 3; ++j)
        {
            const label a = t[j], b = t[(j + 1) % 3];
            around_[a].append(i);
            const uint64_t key = (uint64_t(min(a, b)) << 32) | max(a, b);
            const auto found = known.find(key);
            if (found == known.end())
            {
                known[key] = edges_.size();
                edges_.append({a, b, i, -1});
            }
            else
            {
                edges_[found->second].right = i;
            }
        }
    }
    onLine_.clear();
    onLine_.setSize(points_.size());
    for (const sharedEdge& e : edges_)
    {
        if (onLine(e))
        {
            onLine_[e.a].append(e.b);
            onLine_[e.b].append(e.a);
        }
    }
}


Foam::point Foam::fsbi::surfaceRemesher::onSurface
(
    const point& x, const label p
) const
{
    labelPair parts(parts_[around_[p][0]], parts_[around_[p][0]]);
    for (const label t : around_[p])
    {
        if (parts_[t] != parts.first())
        {
            parts.second() = parts_[t];
        }
    }
    return project_(x, parts);
}


Foam::label Foam::fsbi::surfaceRemesher::opposite
(
    const label triangle, const sharedEdge& e
) const
{
    for (const label p : triangles_[triangle])
    {
        if (p != e.a && p != e.b)
        {
            return p;
        }
    }
    return -1;
}


Foam::label Foam::fsbi::surfaceRemesher::split()
{
    const label before = points_.size();
    // longest first; a triangle is cut once, the next sweep cuts on
    boolList cut(triangles_.size(), false);
    DynamicList<label> order;
    forAll(edges_, i)
    {
        if (length(edges_[i]) > 4*size(edges_[i])/3)
        {
            order.append(i);
        }
    }
    std::sort(order.begin(), order.end(), [&](const label i, const label j)
    {
        const scalar a = length(edges_[i]), b = length(edges_[j]);
        return a > b || (a == b && i < j);
    });
    for (const label i : order)
    {
        const sharedEdge& e = edges_[i];
        if (cut[e.left] || cut[e.right])
        {
            continue;
        }
        const label middle = points_.size();
        points_.append(project_(0.5*(points_[e.a] + points_[e.b]), sides(e)));
        corner_.append(false);
        for (const label t : {e.left, e.right})
        {
            cut[t] = true;
            triFace first(triangles_[t]), second(triangles_[t]);
            for (label j = 0; j < 3; ++j)
            {
                first[j] = first[j] == e.b ? middle : first[j];
                second[j] = second[j] == e.a ? middle : second[j];
            }
            triangles_[t] = first;
            triangles_.append(second);
            parts_.append(label(parts_[t]));
        }
    }
    return points_.size() - before;
}


bool Foam::fsbi::surfaceRemesher::mayJoin(const sharedEdge& e) const
{
    if (!onLine(e))
    {
        // or a line would leave its place
        return !fixity(e.a) || !fixity(e.b);
    }
    if (corner_[e.a] && corner_[e.b])
    {
        return false;
    }
    // a line that closes in itself has three points at least
    for (const label a : onLine_[e.a])
    {
        if (onLine_[e.b].found(a))
        {
            return false;
        }
    }
    return true;
}


Foam::point Foam::fsbi::surfaceRemesher::joined(const sharedEdge& e) const
{
    const label a = fixity(e.a), b = fixity(e.b);
    if (a != b)
    {
        return points_[a > b ? e.a : e.b];
    }
    return project_(0.5*(points_[e.a] + points_[e.b]), sides(e));
}


bool Foam::fsbi::surfaceRemesher::collapsible
(
    const sharedEdge& e, const boolList& touched
) const
{
    // only the two opposite points may neighbour both ends
    labelHashSet nearA, both;
    for (const label t : around_[e.a])
    {
        for (const label p : triangles_[t])
        {
            if (touched[p])
            {
                return false;
            }
            nearA.insert(p);
        }
    }
    for (const label t : around_[e.b])
    {
        for (const label p : triangles_[t])
        {
            if (touched[p])
            {
                return false;
            }
            if (nearA.found(p) && p != e.a && p != e.b)
            {
                both.insert(p);
            }
        }
    }
    return both.size() == 2 && mayJoin(e) && roomAt(e);
}


bool Foam::fsbi::surfaceRemesher::roomAt(const sharedEdge& e) const
{
    const point middle(joined(e));
    const scalar size = size_(middle);
    for (const label end : {e.a, e.b})
    {
        for (const label t : around_[end])
        {
            if (t == e.left || t == e.right)
            {
                continue;
            }
            point p[3];
            for (label j = 0; j < 3; ++j)
            {
                const label v = triangles_[t][j];
                p[j] = v == end ? middle : points_[v];
                const scalar most =
                    evening_ ? max(4*size/3, mag(points_[v] - points_[end]))
                  : 4*size/3;
                if (v != end && mag(points_[v] - middle) > most)
                {
                    return false;
                }
            }
            const vector after((p[1] - p[0]) ^ (p[2] - p[0]));
            const vector before(triangles_[t].areaNormal(points_));
            if
            (
                mag(after) < flat*sqr(size)
             || (after & before) < 0.5*mag(after)*mag(before)
            )
            {
                return false;
            }
        }
    }
    return true;
}


Foam::label Foam::fsbi::surfaceRemesher::collapse()
{
    label n = 0;
    boolList touched(points_.size(), false);
    for (const sharedEdge& e : edges_)
    {
        if (length(e) >= 0.8*size(e) || !collapsible(e, touched))
        {
            continue;
        }
        for (const label end : {e.a, e.b})
        {
            for (const label t : around_[end])
            {
                for (const label p : triangles_[t])
                {
                    touched[p] = true;
                }
            }
        }
        points_[e.a] = joined(e);
        corner_[e.a] = corner_[e.a] || corner_[e.b];
        ++n;
        for (const label t : around_[e.b])
        {
            for (label& p : triangles_[t])
            {
                p = p == e.b ? e.a : p;
            }
        }
        // degenerate: left out by compact()
        triangles_[e.left] = triangles_[e.right] = triFace(0, 0, 0);
    }
    compact();
    return n;
}


void Foam::fsbi::surfaceRemesher::compact()
{
    labelList number(points_.size(), -1);
    DynamicList<point> points;
    DynamicList<bool> corner;
    DynamicList<triFace> triangles;
    DynamicList<label> parts;
    forAll(triangles_, i)
    {
        triFace t(triangles_[i]);
        if (t[0] == t[1])
        {
            continue;
        }
        for (label& p : t)
        {
            if (number[p] < 0)
            {
                number[p] = points.size();
                points.append(points_[p]);
                corner.append(corner_[p]);
            }
            p = number[p];
        }
        triangles.append(t);
        parts.append(parts_[i]);
    }
    points_.transfer(points);
    corner_.transfer(corner);
    triangles_.transfer(triangles);
    parts_.transfer(parts);
}


void Foam::fsbi::surfaceRemesher::flip()
{
    labelList valence(points_.size());
    forAll(valence, p)
    {
        valence[p] = around_[p].size();
    }
    const auto excess = [&](const label p, const label change)
    {
        return sqr(scalar(valence[p] + change - 6));
    };
    boolList changed(triangles_.size(), false);
    for (const sharedEdge& e : edges_)
    {
        if (changed[e.left] || changed[e.right] || onLine(e))
        {
            continue;
        }
        const label c = opposite(e.left, e), d = opposite(e.right, e);
        const scalar gain =
            excess(e.a, 0) + excess(e.b, 0) + excess(c, 0) + excess(d, 0)
          - excess(e.a, -1) - excess(e.b, -1) - excess(c, 1) - excess(d, 1);
        bool joined = false;
        for (const label t : around_[c])
        {
            joined = joined || triangles_[t].found(d);
        }
        if (gain <= 0 || joined || (fixity(c) && fixity(d)))
        {
            continue;
        }
        // left is a, b, c; right is b, a, d
        const vector n(normal(e.a, e.b, c) + normal(e.b, e.a, d));
        const vector n1(normal(c, d, e.b)), n2(normal(d, c, e.a));
        if ((n1 & n) < 0.7*mag(n1)*mag(n) || (n2 & n) < 0.7*mag(n2)*mag(n))
        {
            continue;
        }
        triangles_[e.left] = triFace(c, d, e.b);
        triangles_[e.right] = triFace(d, c, e.a);
        changed[e.left] = changed[e.right] = true;
        --valence[e.a];
        --valence[e.b];
        ++valence[c];
        ++valence[d];
        around_[c].append(e.right);
        around_[d].append(e.left);
    }
}


void Foam::fsbi::surfaceRemesher::smooth()
{
    vectorField sum(points_.size(), Zero), normals(points_.size(), Zero);
    scalarField weight(points_.size(), Zero);
    const scalar anywhere = size_(points_[0]);
    for (const triFace& t : triangles_)
    {
        const vector n(t.areaNormal(points_));
        const point centre(t.centre(points_));
        // or points would leave where triangles are to be small
        const scalar area = mag(n)*sqr(anywhere/size_(centre));
        for (const label p : t)
        {
            sum[p] += area*centre;
            weight[p] += area;
            normals[p] += n;
        }
    }
    const pointField before(points_);
    forAll(points_, p)
    {
        const vector n(normals[p]/(mag(normals[p]) + VSMALL));
        const vector d(sum[p]/weight[p] - points_[p]);
        if (fixity(p) == 0)
        {
            points_[p] = onSurface(points_[p] + d - (d & n)*n, p);
        }
        else if (fixity(p) == 1 && onLine_[p].size() == 2)
        {
            const point middle
            (
                0.5*(before[onLine_[p][0]] + before[onLine_[p][1]])
            );
            points_[p] = onSurface(middle, p);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::surfaceRemesher::surfaceRemesher
(
    const bodySurface& start,
    const scalar size,
    const std::function<point(const point&)>& project
)
:
    surfaceRemesher
    (
        start, labelList(start.triangles().size(), Zero),
        boolList(start.points().size(), false),
        [size](const point&) { return size; },
        [project](const point& x, const labelPair&) { return project(x); }
    )
{
    evening_ = false;
}


Foam::fsbi::surfaceRemesher::surfaceRemesher
(
    const bodySurface& start,
    const labelUList& parts,
    const UList<bool>& corners,
    const sizeFunction& size,
    const projection& project
)
:
    size_(size),
    project_(project),
    evening_(true),
    points_(start.points()),
    triangles_(start.triangles()),
    parts_(parts),
    corner_(corners)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::surfaceRemesher::coarsen()
{
    // the sweeps that follow collapse, too
    const scalar few = 0.01;
    label collapsed = points_.size();
    while (collapsed > few*points_.size())
    {
        connect();
        collapsed = collapse();
        connect();
        flip();
    }
}


Foam::fsbi::bodySurface Foam::fsbi::surfaceRemesher::run()
{
    if (evening_)
    {
        coarsen();
    }
    label cut = 1;
    for (label sweep = 0; sweep < 10 || (evening_ && cut && sweep < 50); ++sweep)
    {
        connect();
        cut = split();
        connect();
        collapse();
        for (label i = 0; i < 3; ++i)
        {
            connect();
            flip();
            smooth();
        }
    }
    for (label i = 0; i < 10; ++i)
    {
        connect();
        flip();
        smooth();
    }
    return bodySurface
    (
        pointField(std::move(points_)), List<triFace>(std::move(triangles_))
    );
}
