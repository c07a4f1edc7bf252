/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Patches of the domain: distances from them, and what effects see of walls that
// are not plane

#include "fluidMesh.H"
#include "wallFacets.H"
#include "ListOps.H"
#include "mergePoints.H"

namespace Foam
{
namespace fsbi
{

//- Of a surface's size: corners nearer than that are one
static const scalar sameCorner = 1e-9;

static bodySurface connected(const bodySurface& surface)
{
    labelList number;
    pointField points;
    mergePoints
    (
        surface.points(), sameCorner*surface.bounds().mag(), false, number, points
    );
    List<triFace> triangles(surface.triangles());
    for (triFace& t : triangles)
    {
        inplaceRenumber(number, t);
    }
    return bodySurface::open(points, triangles);
}

} // End namespace fsbi
} // End namespace Foam


const Foam::fsbi::triangleTree* Foam::fsbi::fluidMesh::patchTree
(
    const word& patch
) const
{
    if (patches_.find(patch) == patches_.end())
    {
        const bodySurface now(patchSurface(patch));
        std::unique_ptr<triangleTree>& tree = patches_[patch];
        if (now.triangles().size())
        {
            tree.reset
            (
                new triangleTree
                (
                    now.transformed(tensor::I, referenceShift_ - shift())
                )
            );
        }
    }
    return patches_[patch].get();
}


Foam::fsbi::bodySurface Foam::fsbi::fluidMesh::patchSurface
(
    const word& patch
) const
{
    wordList others(mesh().boundaryMesh().names());
    inplaceSubsetList
    (
        others, [&](const word& name) { return name != patch; }
    );
    return inverseDistanceMotion::domainBoundary(mesh(), others);
}


Foam::fsbi::bodySurface Foam::fsbi::fluidMesh::describedSurface
(
    const word& patch
) const
{
    bodySurface found;
    if (Pstream::master() && wholeMesh::exists(time_, polyMesh::defaultRegion))
    {
        // known to the mesher, but for a run that goes on
        autoPtr<wholeMesh> read;
        if (!mesher_)
        {
            read.reset(new wholeMesh(time_, polyMesh::defaultRegion));
        }
        const polyMesh& domain = mesher_ ? (*domain_)() : (*read)();
        const label patchi = domain.boundaryMesh().findPatchID(patch);
        if (patchi >= 0)
        {
            const auto isIt = [=](const label i) { return i == patchi; };
            found =
                mesher_
              ? mesher_->boundary().part(isIt)
              : domainOutline(domain).triangulation().part(isIt);
        }
    }
    Pstream::scatter(found);
    return found;
}


std::shared_ptr<const Foam::fsbi::wallFacets> Foam::fsbi::fluidMesh::facets
(
    const word& patch
) const
{
    std::shared_ptr<const wallFacets>& wall = facets_[patch];
    if (!wall)
    {
        bodySurface surface(describedSurface(patch));
        if (surface.triangles().empty())
        {
            surface = connected
            (
                patchSurface(patch).transformed(tensor::I, -shift())
            );
        }
        List<triFace> inwards(surface.triangles());
        for (triFace& t : inwards)
        {
            t.flip();
        }
        wall = std::make_shared<const wallFacets>
        (
            bodySurface::open(surface.points(), inwards)
        );
    }
    return wall;
}
