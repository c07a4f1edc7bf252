/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceMap.H"
#include "polyMesh.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "HashSet.H"

namespace Foam
{
namespace fsbi
{

//- Accepted distance over the length of the edges at a point
static const scalar near = 1e-3;

static label firstOf(const triFace& t)
{
    return min(t[0], min(t[1], t[2]));
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::surfaceMap::surfaceMap
(
    const polyPatch& patch, const bodySurface& surface
)
:
    triangles_(patch.size(), -1),
    points_(patch.nPoints(), -1)
{
    matchPoints(patch, surface);
    matchFaces(patch, surface);
    check(patch, surface);
}


void Foam::fsbi::surfaceMap::matchPoints
(
    const polyPatch& patch, const bodySurface& surface
)
{
    const pointField& x = surface.points();
    const scalarField size(surface.pointEdges());
    treeBoundBox box(x);
    box.inflate(0.1);
    const indexedOctree<treeDataPoint> tree(treeDataPoint(x), box, 10, 10, 3);
    const scalar reach = sqr(near*gMax(size));
    forAll(points_, i)
    {
        const point& p = patch.localPoints()[i];
        const label found = tree.findNearest(p, reach).index();
        if (found >= 0 && mag(p - x[found]) <= near*size[found])
        {
            points_[i] = found;
        }
    }
}


void Foam::fsbi::surfaceMap::matchFaces
(
    const polyPatch& patch, const bodySurface& surface
)
{
    // triangles by their lowest point
    List<DynamicList<label>> lowest(surface.points().size());
    forAll(surface.triangles(), t)
    {
        lowest[firstOf(surface.triangles()[t])].append(t);
    }
    forAll(triangles_, facei)
    {
        const face& f = patch.localFaces()[facei];
        if (f.size() != 3)
        {
            continue;
        }
        const triFace corners(points_[f[0]], points_[f[1]], points_[f[2]]);
        if (firstOf(corners) < 0)
        {
            continue;
        }
        for (const label t : lowest[firstOf(corners)])
        {
            if (triFace::compare(corners, surface.triangles()[t]))
            {
                triangles_[facei] = t;
            }
        }
    }
}


void Foam::fsbi::surfaceMap::check
(
    const polyPatch& patch, const bodySurface& surface
) const
{
    labelList faces(surface.triangles().size(), 0);
    label lost = points_.size() - labelHashSet(points_).size();
    for (const label t : triangles_)
    {
        if (t < 0)
        {
            ++lost;
        }
        else
        {
            ++faces[t];
        }
    }
    Pstream::listCombineGather(faces, plusEqOp<label>());
    if (Pstream::master())
    {
        for (const label n : faces)
        {
            lost += n != 1;
        }
    }
    if (returnReduce(lost, sumOp<label>()))
    {
        FatalErrorInFunction
            << "Patch '" << patch.name() << "' does not have the triangles of"
            << " its body's surface, point for point: "
            << returnReduce(patch.size(), sumOp<label>()) << " faces, "
            << surface.triangles().size() << " triangles, "
            << returnReduce(lost, sumOp<label>())
            << " faces, points or triangles without a partner"
            << exit(FatalError);
    }
}
