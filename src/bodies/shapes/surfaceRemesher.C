/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRemesher.H"

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


void Foam::fsbi::surfaceRemesher::split()
{
    // longest first; a triangle is cut once, the next sweep cuts on
    boolList cut(triangles_.size(), false);
    DynamicList<label> order;
    forAll(edges_, i)
    {
        if (length(edges_[i]) > 4*size_/3)
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
        points_.append(project_(0.5*(points_[e.a] + points_[e.b])));
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
        }
    }
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
    return both.size() == 2 && roomAt(e);
}


bool Foam::fsbi::surfaceRemesher::roomAt(const sharedEdge& e) const
{
    const point middle(project_(0.5*(points_[e.a] + points_[e.b])));
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
                if (v != end && mag(points_[v] - middle) > 4*size_/3)
                {
                    return false;
                }
            }
            const vector after((p[1] - p[0]) ^ (p[2] - p[0]));
            const vector before(triangles_[t].areaNormal(points_));
            if ((after & before) < 0.5*mag(after)*mag(before))
            {
                return false;
            }
        }
    }
    return true;
}


void Foam::fsbi::surfaceRemesher::collapse()
{
    boolList touched(points_.size(), false);
    for (const sharedEdge& e : edges_)
    {
        if (length(e) >= 0.8*size_ || !collapsible(e, touched))
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
        points_[e.a] = project_(0.5*(points_[e.a] + points_[e.b]));
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
}


void Foam::fsbi::surfaceRemesher::compact()
{
    labelList number(points_.size(), -1);
    DynamicList<point> points;
    DynamicList<triFace> triangles;
    for (triFace t : triangles_)
    {
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
            }
            p = number[p];
        }
        triangles.append(t);
    }
    points_.transfer(points);
    triangles_.transfer(triangles);
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
        if (changed[e.left] || changed[e.right])
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
        if (gain <= 0 || joined)
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
    for (const triFace& t : triangles_)
    {
        const vector n(t.areaNormal(points_));
        const scalar area = mag(n);
        const point centre(t.centre(points_));
        for (const label p : t)
        {
            sum[p] += area*centre;
            weight[p] += area;
            normals[p] += n;
        }
    }
    forAll(points_, p)
    {
        const vector n(normals[p]/(mag(normals[p]) + VSMALL));
        const vector d(sum[p]/weight[p] - points_[p]);
        points_[p] = project_(points_[p] + d - (d & n)*n);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::surfaceRemesher::surfaceRemesher
(
    const bodySurface& start, const scalar size, const projection& project
)
:
    size_(size),
    project_(project),
    points_(start.points()),
    triangles_(start.triangles())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::surfaceRemesher::run()
{
    for (label sweep = 0; sweep < 10; ++sweep)
    {
        connect();
        split();
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
