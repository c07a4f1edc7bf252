/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What cells have besides an elastic inside: a cortex, and a liquid

#include "secondOrderElastic.H"
#include "asVectors.H"

Foam::vector Foam::fsbi::secondOrderElastic::flowing(const label i) const
{
    const tensor F(stencil_.faceMean(i, state_.deformation()));
    return F & ((F.T() & unexplained_[i]) - jumpHistory_[i]);
}


Foam::vector Foam::fsbi::secondOrderElastic::flowingTangent
(
    const label i, const vector& change
) const
{
    const tensor F(stencil_.faceMean(i, state_.deformation()));
    const tensor dF(stencil_.faceMean(i, dGradient_));
    const vector& e = unexplained_[i];
    return
        (dF & ((F.T() & e) - jumpHistory_[i]))
      + (F & ((dF.T() & e) + (F.T() & change)));
}


void Foam::fsbi::secondOrderElastic::setMeanGrowth
(
    const scalar growth, scalarField& volume
) const
{
    if (!material_.flows() || !cortex_ || !cortex_->closed())
    {
        return;
    }
    vector2D sums(Zero);        // of volume, and stress-free
    for (const label v : ownedVertices_)
    {
        sums += stencil_.vertexVolume()[v]*vector2D(volume[v], 1);
    }
    reduce(sums, sumOp<vector2D>());
    volume += growth - sums.x()/sums.y();
}


Foam::scalar Foam::fsbi::secondOrderElastic::addCortex
(
    cortex::acting forces, scalar* r
) const
{
    vectorField cells(mesh_.nCells(), Zero);
    shareForces(forces.vertices, cells, forces.faces);
    vector* rows = asVectors(r);
    forAll(cells, i)
    {
        rows[i] -= cells[i];
    }
    boundary_.addLoad(forces.faces, r);
    return forces.growth;
}
