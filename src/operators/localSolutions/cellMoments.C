/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellMoments.H"

namespace Foam
{
namespace fsbi
{

//- Call add(a, b) for all edges of a triangle that its face consists of, in
//  order: the face itself, or those to its centre
template<class Add>
static void forTriangles(const face& f, const Add& add)
{
    if (f.size() == 3)
    {
        add(f[0], f[1], f[2]);
        return;
    }
    forAll(f, i)
    {
        add(f[i], f.nextLabel(i), -1);
    }
}


static void addTriangle
(
    const point& a, const point& b, const point& c,
    DynamicList<point>& points, DynamicList<vector>& areas
)
{
    const vector third(((b - a) ^ (c - a))/6);
    const point middle((a + b + c)/6);
    for (const point& corner : {a, b, c})
    {
        points.append(middle + corner/2);
        areas.append(third);
    }
}


static void addQuadrangle
(
    const point& a, const point& b, const point& c, const point& d,
    DynamicList<point>& points, DynamicList<vector>& areas
)
{
    const scalar g = 0.5/Foam::sqrt(3.0);
    for (const scalar s : {0.5 - g, 0.5 + g})
    {
        for (const scalar t : {0.5 - g, 0.5 + g})
        {
            points.append
            (
                (1 - s)*(1 - t)*a + s*(1 - t)*b + s*t*c + (1 - s)*t*d
            );
            const vector along((1 - t)*(b - a) + t*(c - d));
            const vector across((1 - s)*(d - a) + s*(c - b));
            areas.append((along ^ across)/4);
        }
    }
}

//- Add the integrals of the monomials about a point
static void addTetrahedron
(
    const FixedList<point, 4>& corners, const point& about, const scalar sign,
    scalar* sum
)
{
    const point middle((corners[0] + corners[1] + corners[2] + corners[3])/4);
    const scalar V =
        sign
       *(
            ((corners[1] - corners[0]) ^ (corners[2] - corners[0]))
          & (corners[3] - corners[0])
        )/6;
    scalar a[nCubic];
    setMonomialMeans
    (
        middle - about, simplexMoments(corners, middle), 1, a
    );
    for (label m = 0; m < nCubic; ++m)
    {
        sum[m] += V*a[m];
    }
}


//- From the means of the monomials about a point to the moments about the
//  centre, which is at d
static void shift(const vector& d, const scalar* means, centralMoments& m)
{
    // the means of products are those about the centre and what d adds
    scalar none[nCubic], about[nCubic];
    m = centralMoments(scalar(0));
    setMonomialMeans(d, m, 1, none);
    for (label k = 4; k < nQuadratic; ++k)
    {
        m[k - 4] = means[k] - none[k];
    }
    setMonomialMeans(d, m, 1, about);
    for (label k = nQuadratic; k < nCubic; ++k)
    {
        m[k - 4] = means[k] - about[k];
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::cellShape::cellShape(const fvMesh& mesh, const label celli)
:
    centre(mesh.cellCentres()[celli])
{
    const pointField& x = mesh.points();
    const labelList& vertices = mesh.cellPoints()[celli];
    if (vertices.size() == 4 && mesh.cells()[celli].size() == 4)
    {
        const FixedList<point, 4> corners
        ({
            x[vertices[0]], x[vertices[1]], x[vertices[2]], x[vertices[3]]
        });
        moments = simplexMoments(corners, centre);
        return;
    }
    // about any point, then about the centre
    const point apex(centre);
    scalar sum[nCubic] = {};
    for (const label facei : mesh.cells()[celli])
    {
        const point& Cf = mesh.faceCentres()[facei];
        const scalar sign = mesh.faceOwner()[facei] == celli ? 1 : -1;
        forTriangles(mesh.faces()[facei], [&](label i, label j, label k)
        {
            const FixedList<point, 4> corners
            ({
                apex, x[i], x[j], k < 0 ? Cf : x[k]
            });
            addTetrahedron(corners, apex, sign, sum);
        });
    }
    for (label m = 1; m < nCubic; ++m)
    {
        sum[m] /= sum[0];
    }
    const vector d(sum[1], sum[2], sum[3]);
    centre += d;
    shift(d, sum, moments);
}


void Foam::fsbi::setFacePoints
(
    const pointField& x,
    const face& f,
    const point& centre,
    DynamicList<point>& points,
    DynamicList<vector>& areas
)
{
    if (f.size() == 4)
    {
        addQuadrangle(x[f[0]], x[f[1]], x[f[2]], x[f[3]], points, areas);
        return;
    }
    forTriangles(f, [&](label i, label j, label k)
    {
        addTriangle(x[i], x[j], k < 0 ? centre : x[k], points, areas);
    });
}
