/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gapRefinement.H"
#include "redGreen.H"
#include "surfaceDistance.H"
#include "PtrList.H"

namespace Foam
{
namespace fsbi
{

//- Edges are looked at where the gap is at most as wide as this many of them
static const scalar reachOfEdges = 1.5;

//- Longest edges over the gap: cells across it would be too flat
static const scalar longestInGap = 3;


class bodyInGap
{
    const bodySurface& base_;
    const shapeInGap& shape_;
    autoPtr<surfaceDistance> facets_;
    autoPtr<redGreen> fine_;
    bool refined_;

    //- From a point near the surface to the one that its triangles stand for
    point smoothed(const point& p) const
    {
        point nearest;
        label triangle;
        facets_->find(p, GREAT, nearest, triangle);
        const triFace& t = base_.triangles()[triangle];
        const barycentric2D shares
        (
            t.tri(base_.points()).pointToBarycentric(nearest)
        );
        return shape_.smooth->position
        (
            {t, vector(shares.a(), shares.b(), shares.c())}, base_.points()
        );
    }

    point onto(const point& p) const
    {
        return shape_.smooth ? smoothed(p) : shape_.onto(p);
    }

public:

    bodyInGap(const bodySurface& base, const shapeInGap& shape)
    :
        base_(base),
        shape_(shape),
        refined_(false)
    {
        if (!shape.known())
        {
            return;
        }
        if (shape.smooth)
        {
            facets_.reset(new surfaceDistance(base.points(), base.triangles()));
        }
        pointField points(base.points());
        for (point& p : points)
        {
            p = onto(p);
        }
        fine_.reset
        (
            new redGreen
            (
                points, base.triangles(), [this](const point& p)
                {
                    return onto(p);
                }
            )
        );
    }

    //- Of the shape
    surfaceDistance* distance() const
    {
        return new surfaceDistance
        (
            pointField(fine_->points()), fine_->conforming()
        );
    }

    //- Does any triangle change by this? gap: true and the distance, unless
    //  further than the reach
    bool refine
    (
        const std::function
        <
            bool(const point& p, const scalar reach, scalar& distance)
        >& gap,
        const scalar gapSag
    )
    {
        if (!fine_)
        {
            return false;
        }
        const auto sags = [&](const label a, const label b)
        {
            const point& x = fine_->points()[a];
            const point& y = fine_->points()[b];
            const scalar reach = reachOfEdges*mag(x - y);
            scalar atX, atY, between;
            return
                gap(x, reach, atX) && gap(y, reach, atY)
             && gap(onto(0.5*(x + y)), reach, between)
             && (
                    mag(between - 0.5*(atX + atY)) > gapSag*between
                 || mag(x - y) > longestInGap*between
                );
        };
        boolList marked(fine_->triangles().size(), false);
        bool any = false;
        forAll(marked, i)
        {
            const triFace& t = fine_->triangles()[i];
            marked[i] = sags(t[0], t[1]) || sags(t[1], t[2]) || sags(t[2], t[0]);
            any = any || marked[i];
        }
        if (any)
        {
            fine_->split(marked);
            refined_ = true;
        }
        return any;
    }

    surfaceInGaps surface() const
    {
        if (!refined_)
        {
            return {base_, {}};
        }
        if (!shape_.smooth)
        {
            return {withVolume(), {}};
        }
        const cutTriangles cut(onFacets());
        return {surfaceCut(cut, *shape_.smooth).surface(base_), cut};
    }

private:

    cutTriangles onFacets() const
    {
        cutTriangles cut;
        cut.triangles = fine_->conforming(&cut.parents);
        cut.places.setSize(fine_->points().size());
        forAll(cut.places, p)
        {
            const edge& parents = fine_->parents()[p];
            cut.places[p] =
                p < base_.points().size()
              ? facetPlace::at(p)
              : facetPlace::between
                (
                    cut.places[parents[0]], cut.places[parents[1]]
                );
        }
        return cut;
    }

    //- Points out of the shape as far as is right for their edges
    bodySurface withVolume() const
    {
        pointField points(fine_->points());
        const List<triFace> triangles(fine_->conforming());
        const scalarField edges(bodySurface(points, triangles).pointEdges());
        vectorField out(base_.points());
        const label nBase = out.size();
        const pointField basePoints(SubList<point>(points, nBase));
        scalarField baseEdges
        (
            bodySurface(basePoints, base_.triangles()).pointEdges()
        );
        baseEdges.resize(points.size());
        out.resize(points.size());
        forAll(points, p)
        {
            const edge& parents = fine_->parents()[p];
            if (p < nBase)
            {
                out[p] -= points[p];
            }
            else
            {
                out[p] = 0.5*(out[parents[0]] + out[parents[1]]);
                baseEdges[p] =
                    0.5*(baseEdges[parents[0]] + baseEdges[parents[1]]);
            }
            points[p] += min(sqr(edges[p]/baseEdges[p]), 1)*out[p];
        }
        return bodySurface(points, triangles);
    }
};

//- To the distance of a point from a surface's images, if that is less
static void approach
(
    const surfaceDistance& surface,
    const UList<vector>& images,
    const point& p,
    scalar& distance
)
{
    for (const vector& image : images)
    {
        scalar there;
        label triangle;
        if (surface.find(p - image, distance, there, triangle))
        {
            distance = there;
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::narrowestGap(const scalar edge)
{
    return edge/(1 << redGreen::mostCuts)/longestInGap;
}


Foam::List<Foam::fsbi::bodySurface> Foam::fsbi::surfacesOf
(
    const UList<surfaceInGaps>& bodies
)
{
    List<bodySurface> surfaces(bodies.size());
    forAll(surfaces, b)
    {
        surfaces[b] = bodies[b].surface;
    }
    return surfaces;
}


bool Foam::fsbi::anyCut(const UList<surfaceInGaps>& bodies)
{
    return std::any_of
    (
        bodies.begin(), bodies.end(), [](const surfaceInGaps& body)
        {
            return !body.cut.empty();
        }
    );
}


Foam::List<Foam::fsbi::surfaceInGaps> Foam::fsbi::refinedInGaps
(
    const UList<bodySurface>& bodies,
    const UList<shapeInGap>& shapes,
    const surfaceDistance& walls,
    const UList<vector>& images,
    const scalar gapSag
)
{
    DynamicList<vector> ways(images);
    ways.append(Zero);
    PtrList<bodyInGap> fine(bodies.size());
    forAll(bodies, b)
    {
        fine.set(b, new bodyInGap(bodies[b], shapes[b]));
    }
    bool again = gapSag > 0;
    for (label cuts = 0; again && cuts < redGreen::mostCuts; ++cuts)
    {
        PtrList<surfaceDistance> distances(bodies.size());
        forAll(fine, b)
        {
            if (shapes[b].known())
            {
                distances.set(b, fine[b].distance());
            }
        }
        again = false;
        forAll(fine, b)
        {
            const auto gap = [&](const point& p, const scalar reach, scalar& d)
            {
                d = reach;
                approach(walls, ways, p, d);
                forAll(distances, other)
                {
                    if (distances.set(other))
                    {
                        approach
                        (
                            distances[other], other == b ? images : ways, p, d
                        );
                    }
                }
                return d < reach;
            };
            again = fine[b].refine(gap, gapSag) || again;
        }
    }
    List<surfaceInGaps> surfaces(bodies.size());
    forAll(fine, b)
    {
        surfaces[b] = fine[b].surface();
    }
    return surfaces;
}
