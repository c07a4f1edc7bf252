/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curvedWall.H"
#include "EdgeMap.H"
#include "noTurn.H"
#include "symmetryPlanePolyPatch.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Cosine of the angle between a facet's normal and the mean around its vertex
//  from which on the surface has an edge there: 35 degrees, twice that between
//  facets. A sphere of 60 facets has 21 degrees
static const scalar sharpCosine = 0.82;

//- Of points that several processors have, the lowest number
struct joinRings
{
    void operator()(wallRing& a, const wallRing& b) const
    {
        for (const auto& entry : b)
        {
            label i = 0;
            while
            (
                i < a.size() && (a[i][0] != entry[0] || a[i][1] != entry[1])
            )
            {
                ++i;
            }
            if (i == a.size())
            {
                a.append(entry);
            }
            else
            {
                a[i][2] = min(a[i][2], entry[2]);
            }
        }
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::curvedWall::curvedWall
(
    const fvMesh& mesh, const boolList& faces, const labelList& vertices,
    const surface& onSurface
)
:
    mesh_(mesh),
    faces_(faces),
    vertices_(vertices),
    vertexNumber_(mesh.nPoints(), -1),
    sharp_(mesh, faces_),
    onSurface_(onSurface)
{
    forAll(vertices_, i)
    {
        vertexNumber_[vertices_[i]] = i;
    }
    setEdges();
    setAround();
    update();
}


void Foam::fsbi::curvedWall::setEdges()
{
    DynamicList<edge> edges;
    DynamicList<label> patches;
    forAll(faces_, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const face& f = mesh_.faces()[facei];
        for (label k = 0; faces_[i] && k < f.size(); ++k)
        {
            const label patchi = mesh_.boundaryMesh().whichPatch(facei);
            const edge e(f.faceEdge(k));
            if (edgeNumber_.insert(e, edges.size()))
            {
                edges.append(e);
                patches.append(patchi);
            }
            else if (patches[edgeNumber_[e]] != patchi)
            {
                patches[edgeNumber_[e]] = -1;
            }
        }
    }
    edges_.transfer(edges);
    edgePatch_.transfer(patches);
}


void Foam::fsbi::curvedWall::addFacets
(
    const globalIndex& number,
    const labelUList& vertex,
    List<wallRing>& rings
) const
{
    forAll(faces_, i)
    {
        const face& f = mesh_.faces()[mesh_.nInternalFaces() + i];
        wallRing points;
        for (label k = 0; faces_[i] && k < f.size(); ++k)
        {
            const edge e(f.faceEdge(k));
            const label a = vertex[e.start()], b = vertex[e.end()];
            points.append(FixedList<label, 3>({a, a, a}));
            points.append
            (
                FixedList<label, 3>
                ({
                    min(a, b), max(a, b),
                    number.toGlobal(vertices_.size() + edgeNumber_[e])
                })
            );
        }
        for (label k = 0; faces_[i] && k < f.size(); ++k)
        {
            joinRings()(rings[f[k]], points);
        }
    }
}


void Foam::fsbi::curvedWall::addAcrossCells
(
    const labelUList& vertex, List<wallRing>& rings
) const
{
    for (const labelList& points : mesh_.cellPoints())
    {
        wallRing onWall;
        for (const label v : points)
        {
            const label a = vertex[v];
            if (a < labelMax)
            {
                onWall.append(FixedList<label, 3>({a, a, a}));
            }
        }
        for (const label v : points)
        {
            joinRings()(rings[v], onWall);
        }
    }
}


void Foam::fsbi::curvedWall::setAround()
{
    const globalIndex number(nOwn());
    labelList& vertex = globalVertex_;
    vertex = labelList(mesh_.nPoints(), labelMax);
    forAll(vertices_, i)
    {
        vertex[vertices_[i]] = number.toGlobal(i);
    }
    syncTools::syncPointList(mesh_, vertex, minEqOp<label>(), labelMax);
    List<wallRing> rings(mesh_.nPoints());
    addFacets(number, vertex, rings);
    addAcrossCells(vertex, rings);
    syncTools::syncPointList(mesh_, rings, joinRings(), wallRing(), noTurn());

    around_.setSize(vertices_.size());
    forAll(vertices_, i)
    {
        const label v = vertices_[i];
        sort(rings[v]);
        around_[i].setSize(1, vertex[v]);
        for (const auto& entry : rings[v])
        {
            if (entry[2] != vertex[v])
            {
                around_[i].append(entry[2]);
            }
        }
    }
    if (UPstream::parRun())
    {
        List<Map<label>> compact;
        map_.reset(new mapDistribute(number, around_, compact));
    }
}


void Foam::fsbi::curvedWall::mirror
(
    const label patchi, vectorField& normal
) const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.index() == patchi || !isA<symmetryPlanePolyPatch>(pp))
        {
            continue;
        }
        const vector n(refCast<const symmetryPlanePolyPatch>(pp).n());
        boolList onPlane(mesh_.nPoints(), false);
        UIndirectList<bool>(onPlane, pp.meshPoints()) = true;
        syncTools::syncPointList(mesh_, onPlane, orEqOp<bool>(), false);
        forAll(onPlane, v)
        {
            if (onPlane[v])
            {
                normal[v] -= n*(n & normal[v]);
            }
        }
    }
}


Foam::vectorField Foam::fsbi::curvedWall::normals(const label patchi)
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const pointField& x = mesh_.points();
    vectorField normal(x.size(), Zero);
    const vectorField facet(pp.faceAreas()/mag(pp.faceAreas()));
    forAll(pp, i)
    {
        const face& f = pp[i];
        forAll(f, k)
        {
            const point& v = x[f[k]];
            normal[f[k]] +=
                wallFacet::angle(x[f.nextLabel(k)] - v, x[f.prevLabel(k)] - v)
               *facet[i];
        }
    }
    syncTools::syncPointList(mesh_, normal, plusEqOp<vector>(), vector::zero);
    mirror(patchi, normal);
    normal /= mag(normal) + VSMALL;
    forAll(pp, i)
    {
        for (const label v : pp[i])
        {
            smooth_[v] = smooth_[v] && (normal[v] & facet[i]) > sharpCosine;
        }
    }
    syncTools::syncPointList(mesh_, smooth_, andEqOp<bool>(), true);
    return normal;
}


void Foam::fsbi::curvedWall::bend
(
    const label patchi, const vectorField& normal
)
{
    forAll(edges_, i)
    {
        if (edgePatch_[i] == patchi)
        {
            const vector e(edges_[i].vec(mesh_.points()));
            const auto lift = [&](const label v)
            {
                const auto sharp = sharp_.vertices().cfind(v);
                if (sharp.found())
                {
                    const label other = globalVertex_[edges_[i].otherVertex(v)];
                    return sharp.val().lift(other, e);
                }
                return smooth_[v] ? (e & normal[v])*normal[v] : vector::zero;
            };
            points_[vertices_.size() + i] +=
                (lift(edges_[i].end()) - lift(edges_[i].start()))/8;
        }
    }
}


void Foam::fsbi::curvedWall::moveBack
(
    const label patchi, const vectorField& normal
)
{
    for (const label v : mesh_.boundaryMesh()[patchi].meshPoints())
    {
        if (vertexNumber_[v] >= 0)
        {
            point& x = points_[vertexNumber_[v]];
            x = onSurface_(patchi, x, normal[v]);
        }
    }
    forAll(edges_, i)
    {
        if (edgePatch_[i] == patchi)
        {
            const edge& e = edges_[i];
            point& x = points_[vertices_.size() + i];
            x = onSurface_
            (
                patchi, x, normalised(normal[e.start()] + normal[e.end()])
            );
        }
    }
}


void Foam::fsbi::curvedWall::update()
{
    const pointField& x = mesh_.points();
    sharp_.update(globalVertex_);
    points_.setSize(nOwn());
    smooth_ = boolList(x.size(), true);
    forAll(vertices_, i)
    {
        points_[i] = x[vertices_[i]];
    }
    forAll(edges_, i)
    {
        points_[vertices_.size() + i] = edges_[i].centre(x);
    }
    onFacets_ = points_;
    fill(onFacets_);
    const label nPatches = mesh_.boundaryMesh().nNonProcessor();
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const vectorField normal(normals(patchi));
        bend(patchi, normal);
        if (onSurface_)
        {
            moveBack(patchi, normal);
        }
    }
    fill(points_);
}


void Foam::fsbi::curvedWall::setOnEdges
(
    const label patchi, vectorField& u
) const
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const pointField& x = pp.localPoints();
    const labelList& vertices = pp.meshPoints();
    const auto at = [&](const label v) -> const vector&
    {
        return u[vertexNumber_[v]];
    };
    tensorField gradient(x.size(), Zero);
    scalarField count(x.size(), Zero);
    forAll(pp, i)
    {
        const face& f = pp.localFaces()[i];
        const vector perArea(pp.faceAreas()[i]/(2*magSqr(pp.faceAreas()[i])));
        tensor g(Zero);
        forAll(f, k)
        {
            const label next = f[(k + 1) % 3], last = f[(k + 2) % 3];
            g += (perArea ^ (x[last] - x[next]))*at(vertices[f[k]]);
        }
        for (const label v : f)
        {
            gradient[v] += g;
            count[v] += 1;
        }
    }
    syncTools::syncPointList
    (
        mesh_, vertices, gradient, plusEqOp<tensor>(), tensor::zero
    );
    syncTools::syncPointList
    (
        mesh_, vertices, count, plusEqOp<scalar>(), scalar(0)
    );
    forAll(edges_, i)
    {
        if (edgePatch_[i] == patchi)
        {
            const label a = edges_[i].start(), b = edges_[i].end();
            const vector e(edges_[i].vec(mesh_.points()));
            const auto along = [&](const label v)
            {
                const label local = pp.whichPoint(v);
                return
                    smooth_[v]
                  ? (e & gradient[local])/count[local] : vector::zero;
            };
            u[vertices_.size() + i] =
                0.5*(at(a) + at(b)) + (along(a) - along(b))/8;
        }
    }
}


Foam::fsbi::wallStrip Foam::fsbi::curvedWall::strip
(
    const label a, const label b
) const
{
    const label i = vertices_.size() + edgeNumber_[edge(a, b)];
    const auto lift = [this](const label j)
    {
        return points_[j] - onFacets_[j];
    };
    // Simpson's rule, exact for the cubic
    const vector mean
    (
        (lift(vertexNumber_[a]) + 4*lift(i) + lift(vertexNumber_[b]))/6
    );
    return
    {
        onFacets_[i] + mean/2, (mesh_.points()[b] - mesh_.points()[a]) ^ mean
    };
}


Foam::vector Foam::fsbi::curvedWall::toSurface(const label facei) const
{
    // of the quadratic triangle through vertices and middles of edges
    vector sum(Zero);
    const face& f = mesh_.faces()[facei];
    forAll(f, k)
    {
        const label i = vertices_.size() + edgeNumber_[f.faceEdge(k)];
        sum += points_[i] - onFacets_[i];
    }
    return 4.0/9*sum;
}


Foam::scalar Foam::fsbi::curvedWall::volumeOnFacet(const label facei) const
{
    // by the rule of the three edges' middles, exact for quadratic functions
    const face& f = mesh_.faces()[facei];
    vector lift(Zero);
    forAll(f, k)
    {
        const label i = vertices_.size() + edgeNumber_[f.faceEdge(k)];
        lift += (points_[i] - onFacets_[i])/3;
    }
    return lift & mesh_.faceAreas()[facei];
}
