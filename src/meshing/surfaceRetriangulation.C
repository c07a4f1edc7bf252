/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRetriangulation.H"
#include "surfaceParts.H"
#include "surfaceRemesher.H"

namespace Foam
{
namespace fsbi
{

//- The parts of a surface that meet at one of its points
struct partsAtPoint
{
    struct part
    {
        label index;
        vector area = Zero;

        //- Times the area: how far the described surface lies outside
        scalar outside = 0;
    };

    DynamicList<part> parts;

    void add(const label index, const vector& area, const scalar distance)
    {
        label i = 0;
        while (i < parts.size() && parts[i].index != index)
        {
            ++i;
        }
        if (i == parts.size())
        {
            parts.append(part());
            parts[i].index = index;
        }
        parts[i].area += area;
        parts[i].outside += mag(area)*distance;
    }

    scalar distance(const label i) const
    {
        return parts[i].outside/mag(parts[i].area);
    }

    //- The way that takes each part where it belongs
    vector way() const
    {
        if (parts.size() == 1)
        {
            return distance(0)*normalised(parts[0].area);
        }
        if (parts.size() > 2)
        {
            return Zero;
        }
        const vector a(normalised(parts[0].area));
        const vector b(normalised(parts[1].area));
        const scalar c = a & b;
        return
        (
            (distance(0) - c*distance(1))*a + (distance(1) - c*distance(0))*b
        )/max(1 - sqr(c), SMALL);
    }
};


//- How far a part of the described surface lies outside of a facet, on average:
//  exact for one that is quadratic over it
static scalar outsideOf
(
    const pointField& p,
    const triFace& t,
    const label part,
    const surfaceParts& described
)
{
    const vector n(t.unitNormal(p));
    scalar sum = 0;
    for (label i = 0; i < 3; ++i)
    {
        const point middle(0.5*(p[t[i]] + p[t[(i + 1) % 3]]));
        sum +=
            (described.nearest(middle, labelPair(part, part)) - middle) & n;
    }
    return sum/3;
}


//- Points moved so that facets lie on the described surface on average
static void straddle
(
    pointField& points,
    const List<triFace>& triangles,
    const labelUList& parts,
    const surfaceParts& described
)
{
    List<partsAtPoint> at(points.size());
    forAll(triangles, i)
    {
        const triFace& t = triangles[i];
        const scalar distance = outsideOf(points, t, parts[i], described);
        for (const label p : t)
        {
            at[p].add(parts[i], t.areaNormal(points), distance);
        }
    }
    forAll(points, p)
    {
        points[p] += at[p].way();
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::retriangulated
(
    const bodySurface& given,
    const labelUList& patches,
    const scalar featureAngle,
    const sizeFunction& size,
    labelList& newPatches
)
{
    const label sweeps = 3;             // each leaves a small part of the rest
    const surfaceParts described(given, patches, featureAngle);
    surfaceRemesher remesher
    (
        given, described.parts(), described.corners(), size,
        [&](const point& x, const labelPair& parts)
        {
            return described.nearest(x, parts);
        }
    );
    const bodySurface even(remesher.run());
    pointField points(even.points());
    for (label sweep = 0; sweep < sweeps; ++sweep)
    {
        straddle(points, even.triangles(), remesher.parts(), described);
    }
    newPatches.setSize(remesher.parts().size());
    forAll(newPatches, i)
    {
        newPatches[i] = described.patch(remesher.parts()[i]);
    }
    return bodySurface(points, even.triangles());
}
