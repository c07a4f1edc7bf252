/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticStencil.H"
#include "sharedVertices.H"

namespace Foam
{
namespace fsbi
{

//- Smallest over mean variance of the points around a vertex, below which
//  they do not determine a plane
static const scalar planeBelow = 1e-6;

//- Weight, its first and its second moments
static const int nMoments = 10;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::elasticStencil::elasticStencil
(
    const fvMesh& mesh,
    const UList<solidBoundary::kind>& kinds
)
:
    mesh_(mesh),
    halo_(mesh),
    ghostOf_(kinds.size(), -1)
{
    DynamicList<label> ghosts;
    forAll(kinds, i)
    {
        if (kinds[i] != solidBoundary::coupled)
        {
            ghostOf_[i] = ghosts.size();
            ghosts.append(i);
        }
    }
    ghostFaces_.transfer(ghosts);
    setFaces();
    setColumns();
    update();
}


void Foam::fsbi::elasticStencil::addFace
(
    const label facei, const label neighbour
)
{
    face_.append(facei);
    owner_.append(mesh_.faceOwner()[facei]);
    neighbour_.append(neighbour);
    faceVertex_.append(mesh_.faces()[facei]);
    faceStart_.append(faceVertex_.size());
}


void Foam::fsbi::elasticStencil::setFaces()
{
    const label nInternal = mesh_.nInternalFaces();
    faceStart_.append(0);
    for (label facei = 0; facei < nInternal; ++facei)
    {
        addFace(facei, mesh_.faceNeighbour()[facei]);
    }
    label halo = mesh_.nCells();
    for (const label patchi : halo_.patches())
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        forAll(pp, i)
        {
            addFace(pp.start() + i, halo++);
        }
    }
    forAll(ghostFaces_, g)
    {
        addFace(nInternal + ghostFaces_[g], firstGhost() + g);
    }
}


void Foam::fsbi::elasticStencil::setColumns()
{
    List<DynamicList<label>> columns(mesh_.nPoints());
    forAll(columns, v)
    {
        columns[v] = mesh_.pointCells()[v];
    }
    forAll(ghostFaces_, g)
    {
        for (const label v : mesh_.faces()[face_[firstBoundary() + g]])
        {
            columns[v].append(firstGhost() + g);
        }
    }
    vertexStart_.setSize(columns.size() + 1);
    vertexStart_[0] = 0;
    forAll(columns, v)
    {
        vertexStart_[v + 1] = vertexStart_[v] + columns[v].size();
    }
    vertexColumn_.setSize(vertexStart_.last());
    forAll(columns, v)
    {
        std::copy
        (
            columns[v].begin(), columns[v].end(),
            vertexColumn_.begin() + vertexStart_[v]
        );
    }
}


Foam::vectorField Foam::fsbi::elasticStencil::centres() const
{
    vectorField result(nColumns());
    std::copy
    (
        mesh_.cellCentres().begin(), mesh_.cellCentres().end(), result.begin()
    );
    for (label i = mesh_.nInternalFaces(); i < nFaces(); ++i)
    {
        result[neighbour_[i]] = result[owner_[i]] + delta_[i];
    }
    return result;
}


void Foam::fsbi::elasticStencil::update()
{
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& Sf = mesh_.faceAreas();
    const label nInternal = mesh_.nInternalFaces();

    area_.setSize(nFaces());
    delta_.setSize(nFaces());
    compact_.setSize(nFaces());
    label i = nInternal;
    for (const label patchi : halo_.patches())
    {
        const vectorField delta(mesh_.boundary()[patchi].delta());
        for (const vector& d : delta)
        {
            delta_[i++] = d;
        }
    }
    forAll(face_, i)
    {
        const label facei = face_[i];
        area_[i] = Sf[facei];
        if (i < nInternal)
        {
            delta_[i] = C[neighbour_[i]] - C[owner_[i]];
        }
        else if (i >= firstBoundary())
        {
            const vector n(normalised(Sf[facei]));
            delta_[i] = 2*(n & (Cf[facei] - C[owner_[i]]))*n;
        }
        compact_[i] = magSqr(area_[i])/(area_[i] & delta_[i]);
    }
    setVolumes();
    setWeights();
}


Foam::scalarField Foam::fsbi::elasticStencil::moments
(
    const vectorField& C
) const
{
    const pointField& x = mesh_.points();
    scalarField result(nMoments*x.size(), Zero);
    forAll(x, v)
    {
        scalar* m = result.begin() + nMoments*v;
        for (label j = vertexStart_[v]; j < vertexStart_[v + 1]; ++j)
        {
            const vector d(C[vertexColumn_[j]] - x[v]);
            const scalar w = 1/magSqr(d);
            const symmTensor second(w*sqr(d));
            m[0] += w;
            for (direction k = 0; k < 3; ++k)
            {
                m[1 + k] += w*d[k];
            }
            for (direction k = 0; k < 6; ++k)
            {
                m[4 + k] += second[k];
            }
        }
    }
    sharedVertices::sum<nMoments>(mesh_, result.begin(), halo_.size());
    return result;
}


void Foam::fsbi::elasticStencil::setVolumes()
{
    vertexVolume_.setSize(mesh_.nPoints());
    vertexVolume_ = Zero;
    forAll(mesh_.cells(), celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        for (const label v : points)
        {
            vertexVolume_[v] += mesh_.cellVolumes()[celli]/points.size();
        }
    }
    sharedVertices::sum<1>(mesh_, vertexVolume_.begin(), halo_.size());
}


void Foam::fsbi::elasticStencil::setWeights()
{
    const pointField& x = mesh_.points();
    const vectorField C(centres());
    const scalarField sums(moments(C));
    valueWeight_.setSize(vertexColumn_.size());
    gradientWeight_.setSize(vertexColumn_.size());
    forAll(x, v)
    {
        const scalar* m = sums.begin() + nMoments*v;
        const vector mean(vector(m[1], m[2], m[3])/m[0]);
        const symmTensor covariance
        (
            symmTensor(m[4], m[5], m[6], m[7], m[8], m[9])/m[0] - sqr(mean)
        );
        if (det(covariance) < planeBelow*pow3(tr(covariance)))
        {
            FatalErrorInFunction
                << "The cells around the point " << x[v] << " of region "
                << mesh_.name() << " lie in a plane: the gradient there is not"
                << " determined. Refine the mesh there: a body needs two cells"
                << " in every direction" << exit(FatalError);
        }
        const symmTensor inverse(inv(covariance));
        for (label j = vertexStart_[v]; j < vertexStart_[v + 1]; ++j)
        {
            const vector d(C[vertexColumn_[j]] - x[v]);
            const scalar w = 1/(magSqr(d)*m[0]);
            gradientWeight_[j] = w*(inverse & (d - mean));
            valueWeight_[j] = w - (gradientWeight_[j] & mean);
        }
    }
}


Foam::tensor Foam::fsbi::elasticStencil::cellMean
(
    const label celli, const tensorField& vertices
) const
{
    const labelList& points = mesh_.cellPoints()[celli];
    tensor sum(Zero);
    for (const label v : points)
    {
        sum += vertices[v];
    }
    return sum/points.size();
}
