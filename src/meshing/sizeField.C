/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sizeField.H"
#include "polyMesh.H"

namespace Foam
{
namespace fsbi
{

//- Part by which sizes may differ and be the same
static const scalar roundOff = 1e-6;

//- What gmsh is to be asked for to get cells like those of the background: the
//  edges of hexahedra; of tetrahedra those of regular ones, over what gmsh's are
//  longer than asked for (see bodyMesher)
static scalarField cellSizes(const polyMesh& domain)
{
    const scalar ofTetrahedron = Foam::cbrt(6*Foam::sqrt(2.0))/1.4;
    scalarField sizes(Foam::cbrt(domain.cellVolumes()));
    forAll(sizes, c)
    {
        sizes[c] *= domain.cells()[c].size() == 4 ? ofTetrahedron : 1;
    }
    return sizes;
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::sizeField::addSurface(const bodySurface& surface)
{
    surfaces_.append
    (
        new surfaceDistance(surface.points(), surface.triangles())
    );
    sizes_.append(triangleSizes(surface));
}


Foam::scalar Foam::fsbi::sizeField::farSize(const point& p) const
{
    if (farSize_ > 0)
    {
        return farSize_;
    }
    const pointIndexHit hit(cells_->findNearest(p, GREAT));
    return cellSizes_[hit.index()];
}


void Foam::fsbi::sizeField::addImages
(
    const UList<vector>& images, const boundBox& box
)
{
    const label nBodies = surfaces_.size() - 1;
    scalar far = farSize_;
    if (far <= 0)
    {
        far = max(cellSizes_);
    }
    for (label b = 0; b < nBodies; ++b)
    {
        standing_.append(standing{b, Zero});
        for (const vector& image : images)
        {
            boundBox reached(surfaces_[b].box());
            reached.min() += image - reach(far)*vector::one;
            reached.max() += image + reach(far)*vector::one;
            if (reached.overlaps(box))
            {
                standing_.append(standing{b, image});
            }
        }
    }
    standing_.append(standing{nBodies, Zero});
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::sizeField::sizeField
(
    const polyMesh& domain,
    const vector& shift,
    const bodySurface& boundary,
    const UList<bodySurface>& bodies,
    const UList<vector>& images,
    const remeshControls& controls
)
:
    growth_(controls.growth),
    cellsPerGap_(controls.cellsPerGap),
    minSize_(controls.minSize),
    coarsening_(1),
    farSize_(controls.farSize),
    smallest_(GREAT)
{
    scalar bodySize = GREAT;
    for (const bodySurface& body : bodies)
    {
        addSurface(body);
        bodySize = min(bodySize, body.meanEdge());
        smallest_ = min(smallest_, min(sizes_.last()));
    }
    addSurface(boundary);
    if (minSize_ <= 0 && bodies.size())
    {
        minSize_ = remeshControls::finestPart*bodySize;
    }

    if (farSize_ <= 0)
    {
        cellCentres_ = domain.cellCentres() + shift;
        cellSizes_ = cellSizes(domain);
        cells_.reset
        (
            new indexedOctree<treeDataPoint>
            (
                treeDataPoint(cellCentres_),
                // not of the centres: there may be only one
                treeBoundBox(domain.points() + shift), 8, 10, 3
            )
        );
    }
    boundBox cell(domain.bounds());
    cell.min() += shift;
    cell.max() += shift;
    addImages(images, cell);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::sizeField::besideBodies(const point& p) const
{
    const scalar h = operator()(p);
    return h < (1 - roundOff)*farSize(p) ? h : GREAT;
}


Foam::scalarField Foam::fsbi::sizeField::triangleSizes
(
    const bodySurface& surface
)
{
    const List<triFace>& triangles = surface.triangles();
    const scalarField ofPoints(surface.pointEdges());
    scalarField sizes(triangles.size());
    forAll(triangles, i)
    {
        const triFace& t = triangles[i];
        sizes[i] = (ofPoints[t[0]] + ofPoints[t[1]] + ofPoints[t[2]])/3;
    }
    return sizes;
}


// * * * * * * * * * * * * * * * Member Operators  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::sizeField::operator()(const point& p) const
{
    scalar h = farSize(p);
    scalar first = reach(h), second = first;
    const auto visit = [&](const label i)
    {
        const standing& s = standing_[i];
        scalar d;
        label triangle;
        if (surfaces_[s.surface].find(p - s.off, reach(h), d, triangle))
        {
            second = min(second, max(first, d));
            first = min(first, d);
            if (s.surface < surfaces_.size() - 1)
            {
                h = min(h, sizes_[s.surface][triangle] + growth_*d);
            }
        }
    };

    // the nearest goes first: what it leaves of the reach spares the others
    label nearest = 0;
    scalar bound = GREAT;
    forAll(standing_, i)
    {
        const standing& s = standing_[i];
        const scalar d = surfaces_[s.surface].atLeast(p - s.off);
        if (d < bound)
        {
            bound = d;
            nearest = i;
        }
    }
    visit(nearest);
    forAll(standing_, i)
    {
        if (i != nearest)
        {
            visit(i);
        }
    }
    return min(h, max(coarsening_*minSize_, (first + second)/cellsPerGap_));
}
