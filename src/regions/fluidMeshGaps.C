/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// How near bodies and walls are, and what to say of it

#include "fluidMesh.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"
#include "ListOps.H"

Foam::scalar Foam::fsbi::fluidMesh::resolvedGap() const
{
    const remeshControls controls(remeshDict_);
    scalar edge = GREAT;
    forAll(bodies_, b)
    {
        edge = min(edge, bodies_[b].meshedSurface().meanEdge());
    }
    return
        controls.cellsPerGap
       *(
            controls.minSize > 0
          ? controls.minSize
          : remeshControls::finestPart*edge
        );
}


Foam::string Foam::fsbi::fluidMesh::narrowGap() const
{
    const scalar gap = smallestGap();
    if (gap >= resolvedGap())
    {
        return string();
    }
    const string leaving(bodyThatLeaves(gap));
    if (leaving.size())
    {
        return leaving;
    }
    return
        " (bodies and walls are as near as " + Foam::name(gap)
      + ": that needs a smaller 'size' of the shapes in constant/bodies, or an"
        " effect 'repulsion' that keeps them apart)";
}


Foam::string Foam::fsbi::fluidMesh::bodyThatLeaves(const scalar gap) const
{
    if (!mesh_)
    {
        return string();
    }
    const wordList patches(mesh().boundaryMesh().names());
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if
        (
            isA<processorPolyPatch>(patch) || isA<wallPolyPatch>(patch)
         || isBody(patch.name())
        )
        {
            continue;
        }
        wordList others(patches);
        inplaceSubsetList
        (
            others, [&](const word& name) { return name != patch.name(); }
        );
        const bodySurface open
        (
            inverseDistanceMotion::domainBoundary(mesh(), others)
        );
        const surfaceDistance surface(open.points(), open.triangles());
        for (const immersedBody& body : bodies_)
        {
            const bodySurface meshed(body.meshedSurface());
            for (const point& p : meshed.points())
            {
                scalar distance;
                label triangle;
                if (surface.find(p, 1.01*gap + SMALL, distance, triangle))
                {
                    return
                        " (body '" + body.name() + "' has come to the patch '"
                      + patch.name() + "', which is no wall, and cannot leave"
                        " the domain: end the run before, make the domain longer"
                        " in system/blockMeshDict, or let it follow the body with"
                        " `follow` in system/remeshDict)";
                }
            }
        }
    }
    return string();
}


Foam::scalar Foam::fsbi::fluidMesh::smallestGap() const
{
    const vector moved(shift() - referenceShift_);
    scalar gap = GREAT;
    const auto approach =
        [&](const surfaceDistance& surface, const pointField& x, const vector& by)
        {
            label triangle;
            for (const point& p : x)
            {
                scalar distance;
                if (surface.find(p - by, gap, distance, triangle))
                {
                    gap = min(gap, distance);
                }
            }
        };
    forAll(bodies_, b)
    {
        const bodySurface surface(bodies_[b].meshedSurface());
        if (walls_)         // known with the first mesh
        {
            approach(walls_(), surface.points(), moved);
        }
        if (bodies_.size() > 1)
        {
            const surfaceDistance tree(surface.points(), surface.triangles());
            for (label other = 0; other < b; ++other)
            {
                approach
                (
                    tree, bodies_[other].meshedSurface().points(), Zero
                );
            }
        }
    }
    return gap;
}
