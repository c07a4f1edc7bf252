/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curvedWall.H"
#include "EdgeMap.H"
#include "HashSet.H"

namespace Foam
{
namespace fsbi
{

//- Cosine of the angle between a facet's normal and the mean around its vertex
//  from which on the surface has an edge there: 35 degrees, twice that between
//  facets. A sphere of 60 facets has 21 degrees
static const scalar sharp = 0.82;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::curvedWall::curvedWall
(
    const fvMesh& mesh, const boolList& faces, const labelList& vertices
)
:
    mesh_(mesh),
    faces_(faces),
    vertices_(vertices),
    vertexNumber_(mesh.nPoints(), -1)
{
    forAll(vertices_, i)
    {
        vertexNumber_[vertices_[i]] = i;
    }
    setTopology();
    update();
}


void Foam::fsbi::curvedWall::setTopology()
{
    EdgeMap<label> numbers;
    DynamicList<edge> edges;
    DynamicList<label> patches;
    List<DynamicList<label>> around(vertices_.size());
    List<labelHashSet> seen(vertices_.size());
    const auto add = [&](const label vertex, const label pointi)
    {
        if (seen[vertex].insert(pointi))
        {
            around[vertex].append(pointi);
        }
    };
    forAll(vertices_, i)
    {
        add(i, i);
    }
    forAll(faces_, i)
    {
        if (!faces_[i])
        {
            continue;
        }
        const label facei = mesh_.nInternalFaces() + i;
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        const face& f = mesh_.faces()[facei];
        labelList points;
        forAll(f, k)
        {
            const edge e(f.faceEdge(k));
            if (numbers.insert(e, edges.size()))
            {
                edges.append(e);
                patches.append(patchi);
            }
            else if (patches[numbers[e]] != patchi)
            {
                patches[numbers[e]] = -1;
            }
            points.append(vertexNumber_[f[k]]);
            points.append(vertices_.size() + numbers[e]);
        }
        for (const label v : f)
        {
            for (const label pointi : points)
            {
                add(vertexNumber_[v], pointi);
            }
        }
    }
    edges_.transfer(edges);
    edgePatch_.transfer(patches);
    start_.setSize(vertices_.size() + 1);
    start_[0] = 0;
    DynamicList<label> all;
    forAll(around, i)
    {
        all.append(around[i]);
        start_[i + 1] = all.size();
    }
    around_.transfer(all);
}


void Foam::fsbi::curvedWall::bend(const label patchi)
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const pointField& x = mesh_.points();
    vectorField normal(pp.nPoints(), Zero);
    const vectorField facet(pp.faceAreas()/mag(pp.faceAreas()));
    forAll(pp, i)
    {
        for (const label v : pp.localFaces()[i])
        {
            normal[v] += facet[i];
        }
    }
    normal /= mag(normal) + VSMALL;
    boolList smooth(pp.nPoints(), true);
    forAll(pp, i)
    {
        for (const label v : pp.localFaces()[i])
        {
            smooth[v] = smooth[v] && (normal[v] & facet[i]) > sharp;
        }
    }
    forAll(edges_, i)
    {
        if (edgePatch_[i] == patchi)
        {
            const vector e(edges_[i].vec(x));
            const auto lift = [&](const label v)
            {
                const label local = pp.meshPointMap()[v];
                const vector& n = normal[local];
                return smooth[local] ? vector((e & n)*n) : vector::zero;
            };
            points_[vertices_.size() + i] +=
                (lift(edges_[i].end()) - lift(edges_[i].start()))/8;
        }
    }
}


void Foam::fsbi::curvedWall::update()
{
    const pointField& x = mesh_.points();
    points_.setSize(vertices_.size() + edges_.size());
    forAll(vertices_, i)
    {
        points_[i] = x[vertices_[i]];
    }
    forAll(edges_, i)
    {
        points_[vertices_.size() + i] = edges_[i].centre(x);
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.size() && !pp.coupled())
        {
            bend(pp.index());
        }
    }
}
