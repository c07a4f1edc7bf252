/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "straddling.H"
#include "surfaceParts.H"

namespace Foam
{
namespace fsbi
{

//- Cosine between normals of parts that only their patches tell apart
static const scalar smooth = 0.9;


//- The parts of a surface that meet at one of its points
struct partsAtPoint
{
    struct part
    {
        label index;
        vector normals = Zero;

        //- Sums by angle: how far the described surface lies outside
        scalar angle = 0;
        scalar outside = 0;
    };

    DynamicList<part> parts;

    void add
    (
        const label index,
        const vector& normal,
        const scalar angle,
        const scalar distance
    )
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
        parts[i].normals += angle*normal;
        parts[i].angle += angle;
        parts[i].outside += angle*distance;
    }

    scalar distance(const label i) const
    {
        return parts[i].outside/parts[i].angle;
    }

    //- The way that takes each part where it belongs
    vector way() const
    {
        if (parts.size() == 1)
        {
            return distance(0)*normalised(parts[0].normals);
        }
        if (parts.size() > 2)
        {
            return Zero;
        }
        const vector a(normalised(parts[0].normals));
        const vector b(normalised(parts[1].normals));
        const scalar c = a & b;
        if (c > smooth)
        {
            return
                (parts[0].outside + parts[1].outside)
               /(parts[0].angle + parts[1].angle)
               *normalised(parts[0].normals + parts[1].normals);
        }
        return
        (
            (distance(0) - c*distance(1))*a + (distance(1) - c*distance(0))*b
        )/(1 - sqr(c));
    }
};

//- Of a triangle, at its corner. By angles, it does not matter to a point how the
//  faces around it are cut into triangles
static scalar angleAt
(
    const pointField& points, const triFace& t, const label corner
)
{
    const vector a(points[t[(corner + 1) % 3]] - points[t[corner]]);
    const vector b(points[t[(corner + 2) % 3]] - points[t[corner]]);
    return std::atan2(mag(a ^ b), a & b);
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::straddle
(
    pointField& points,
    const List<triFace>& triangles,
    const labelUList& parts,
    const std::function<scalar(const label)>& outside
)
{
    List<partsAtPoint> at(points.size());
    forAll(triangles, i)
    {
        const triFace& t = triangles[i];
        const vector normal(t.unitNormal(points));
        const scalar distance = outside(i);
        for (label k = 0; k < 3; ++k)
        {
            at[t[k]].add(parts[i], normal, angleAt(points, t, k), distance);
        }
    }
    forAll(points, p)
    {
        points[p] += at[p].way();
    }
}


Foam::fsbi::bodySurface Foam::fsbi::straddling
(
    const bodySurface& surface,
    const labelUList& patches,
    const scalar featureAngle
)
{
    const pointField& points = surface.points();
    const List<triFace>& triangles = surface.triangles();
    const surfaceParts described(surface, patches, featureAngle);
    const labelList& parts = described.parts();

    std::map<labelPair, vector> normals;        // by point and part
    forAll(triangles, i)
    {
        const triFace& t = triangles[i];
        for (label k = 0; k < 3; ++k)
        {
            normals.emplace(labelPair(t[k], parts[i]), Zero).first->second +=
                angleAt(points, t, k)*t.unitNormal(points);
        }
    }
    for (auto& n : normals)
    {
        n.second.normalise();
    }
    const auto outside = [&](const label i)
    {
        const triFace& t = triangles[i];
        scalar sum = 0;
        for (label k = 0; k < 3; ++k)
        {
            const label a = t[k], b = t[(k + 1) % 3];
            sum +=
                (points[b] - points[a])
              & (
                    normals[labelPair(b, parts[i])]
                  - normals[labelPair(a, parts[i])]
                );
        }
        // an eighth in the middle of an edge, of which the mean is a third
        return sum/24;
    };
    pointField moved(points);
    straddle(moved, triangles, parts, outside);
    return bodySurface(moved, triangles);
}
