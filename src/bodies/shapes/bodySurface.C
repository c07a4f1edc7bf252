/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodySurface.H"
#include "triangleCrossings.H"
#include "mathematicalConstants.H"
#include "error.H"
#include "OStringStream.H"

#include <algorithm>
#include <map>
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsbi::bodySurface::moments
(
    const point& p, vector& first
) const
{
    scalar V = 0;
    first = Zero;
    for (const triFace& t : triangles_)
    {
        const vector a(points_[t[0]] - p);
        const vector b(points_[t[1]] - p);
        const vector c(points_[t[2]] - p);
        const scalar v = (a & (b ^ c))/6;
        V += v;
        first += v*(a + b + c)/4;
    }
    return V;
}


Foam::fsbi::outcome Foam::fsbi::bodySurface::closed(const string& what) const
{
    // uses forward and backward of every undirected edge
    std::unordered_map<uint64_t, std::pair<int, int>> uses;
    uses.reserve(2*triangles_.size());
    for (const triFace& t : triangles_)
    {
        for (label i = 0; i < 3; ++i)
        {
            const uint64_t a = t[i], b = t[(i + 1) % 3];
            auto& use = uses[(min(a, b) << 32) | max(a, b)];
            ++(a < b ? use.first : use.second);
        }
    }

    label open = 0, nonManifold = 0, flipped = 0;
    for (const auto& edge : uses)
    {
        const label n = edge.second.first + edge.second.second;
        open += n == 1;
        nonManifold += n > 2;
        flipped += n == 2 && edge.second.first != 1;
    }
    if (open || nonManifold || flipped)
    {
        return outcome::failed
        (
            "The surface of " + what + " does not enclose a solid: "
          + Foam::name(open) + " edges with one triangle only (open), "
          + Foam::name(nonManifold)
          + " edges with more than two triangles (non-manifold), "
          + Foam::name(flipped)
          + " edges whose two triangles are oriented oppositely"
        );
    }
    return outcome();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bodySurface::bodySurface
(
    pointField&& points, List<triFace>&& triangles
)
:
    points_(std::move(points)),
    triangles_(std::move(triangles))
{
    if (volume() < 0)
    {
        for (triFace& t : triangles_)
        {
            Swap(t[1], t[2]);
        }
    }
}


Foam::fsbi::bodySurface::bodySurface
(
    const pointField& points, const List<triFace>& triangles
)
:
    bodySurface(pointField(points), List<triFace>(triangles))
{}


Foam::fsbi::bodySurface Foam::fsbi::bodySurface::open
(
    const pointField& points, const List<triFace>& triangles
)
{
    bodySurface result;
    result.points_ = points;
    result.triangles_ = triangles;
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::bodySurface::volume() const
{
    vector first;
    return points_.empty() ? 0 : moments(points_[0], first);
}


Foam::scalar Foam::fsbi::bodySurface::area() const
{
    scalar A = 0;
    for (const triFace& t : triangles_)
    {
        A += t.mag(points_);
    }
    return A;
}


Foam::point Foam::fsbi::bodySurface::centroid() const
{
    // from a nearby point: no cancellation for a small body far from the origin
    const point p(bounds().centre());
    vector first;
    const scalar V = moments(p, first);
    return p + first/V;
}


Foam::symmTensor Foam::fsbi::bodySurface::inertia() const
{
    const point p(centroid());
    symmTensor second(Zero);
    for (const triFace& t : triangles_)
    {
        const vector a(points_[t[0]] - p);
        const vector b(points_[t[1]] - p);
        const vector c(points_[t[2]] - p);
        second +=
            (a & (b ^ c))/120*(sqr(a) + sqr(b) + sqr(c) + sqr(a + b + c));
    }
    return tr(second)*symmTensor::I - second;
}


Foam::scalar Foam::fsbi::bodySurface::meanEdge() const
{
    scalar sum = 0;
    for (const triFace& t : triangles_)
    {
        for (label i = 0; i < 3; ++i)
        {
            sum += mag(points_[t[i]] - points_[t[(i + 1) % 3]]);
        }
    }
    return sum/max(3*triangles_.size(), 1);
}


Foam::scalarField Foam::fsbi::bodySurface::pointEdges() const
{
    scalarField sum(points_.size(), Zero);
    labelList n(points_.size(), Zero);
    for (const triFace& t : triangles_)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = t[i], b = t[(i + 1) % 3];
            const scalar length = mag(points_[a] - points_[b]);
            sum[a] += length;
            sum[b] += length;
            ++n[a];
            ++n[b];
        }
    }
    forAll(sum, i)
    {
        sum[i] /= max(n[i], 1);
    }
    return sum;
}


Foam::vectorField Foam::fsbi::bodySurface::pointAreas() const
{
    vectorField sum(points_.size(), Zero);
    for (const triFace& t : triangles_)
    {
        const vector S(t.areaNormal(points_));
        for (const label p : t)
        {
            sum[p] += S;
        }
    }
    return sum;
}


Foam::scalar Foam::fsbi::bodySurface::winding(const point& p) const
{
    // Van Oosterom & Strackee 1983
    scalar angle = 0;
    for (const triFace& t : triangles_)
    {
        const vector a(points_[t[0]] - p);
        const vector b(points_[t[1]] - p);
        const vector c(points_[t[2]] - p);
        const scalar la = mag(a), lb = mag(b), lc = mag(c);
        angle += 2*Foam::atan2
        (
            a & (b ^ c),
            la*lb*lc + (a & b)*lc + (b & c)*la + (c & a)*lb
        );
    }
    return angle/(4*constant::mathematical::pi);
}


Foam::fsbi::bodySurface Foam::fsbi::bodySurface::transformed
(
    const tensor& R, const point& centre
) const
{
    bodySurface result(*this);
    for (point& p : result.points_)
    {
        p = centre + (R & p);
    }
    return result;
}


Foam::fsbi::bodySurface Foam::fsbi::bodySurface::scaled
(
    const scalar factor
) const
{
    return transformed(factor*tensor::I, Zero).standingFor
    (
        factor*scale_, factor*offset_
    );
}


Foam::fsbi::bodySurface Foam::fsbi::bodySurface::described() const
{
    vectorField normal(points_.size(), Zero);
    for (const triFace& t : triangles_)
    {
        for (const label v : t)
        {
            normal[v] += t.areaNormal(points_);
        }
    }
    bodySurface result(standingFor(1, 0));
    forAll(points_, v)
    {
        result.points_[v] = described(points_[v], normalised(normal[v]));
    }
    return result;
}


Foam::fsbi::bodySurface Foam::fsbi::bodySurface::standingFor
(
    const scalar scale, const scalar offset
) const
{
    bodySurface result(*this);
    result.scale_ = scale;
    result.offset_ = offset;
    return result;
}


std::vector<Foam::fsbi::bodySurface::shell>
Foam::fsbi::bodySurface::shells() const
{
    // every point leads to the lowest of its shell
    labelList root(identity(points_.size()));
    const auto rootOf = [&](label p)
    {
        while (root[p] != p)
        {
            p = root[p] = root[root[p]];
        }
        return p;
    };
    for (const triFace& t : triangles_)
    {
        for (label i = 1; i < 3; ++i)
        {
            const label a = rootOf(t[0]), b = rootOf(t[i]);
            root[max(a, b)] = min(a, b);
        }
    }
    std::map<label, shell> found;
    forAll(points_, p)
    {
        found[rootOf(p)].points.append(p);
    }
    forAll(triangles_, i)
    {
        const triFace& t = triangles_[i];
        shell& s = found[rootOf(t[0])];
        s.triangles.append(i);
        s.volume += (points_[t[0]] & (points_[t[1]] ^ points_[t[2]]))/6;
    }
    std::vector<shell> sorted;
    for (const auto& s : found)
    {
        if (s.second.triangles.size())
        {
            sorted.push_back(s.second);
        }
    }
    std::stable_sort
    (
        sorted.begin(), sorted.end(),
        [](const shell& a, const shell& b) { return a.volume < b.volume; }
    );
    return sorted;
}


Foam::fsbi::outcome Foam::fsbi::bodySurface::solid(const string& what) const
{
    const outcome edges(closed(what));
    if (!edges)
    {
        return edges;
    }
    const labelPair crossing(triangleCrossing(points_, triangles_));
    if (crossing.first() >= 0)
    {
        OStringStream reason;
        reason
            << "The surface of " << what.c_str() << " intersects itself: "
            << "triangles " << crossing.first() << " and " << crossing.second()
            << " cross near "
            << triangles_[crossing.first()].centre(points_);
        return outcome::failed(reason.str());
    }
    return outcome();
}


void Foam::fsbi::bodySurface::check(const word& name) const
{
    const outcome found(solid("body '" + name + "'"));
    if (!found)
    {
        FatalErrorInFunction << found.reason.c_str() << exit(FatalError);
    }
}
