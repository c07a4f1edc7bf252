/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshStencil.H"
#include "syncTools.H"

Foam::symmTensorField Foam::fsbi::meshStencil::covariances() const
{
    symmTensorField result(mesh_.nCells() + halo_.size(), Zero);
    const pointField& x = mesh_.points();
    forAll(mesh_.cells(), celli)
    {
        // tetrahedra from the centre: sum of (vertex - centre)^2, V/20 each
        const point& C = mesh_.cellCentres()[celli];
        symmTensor sum(Zero);
        scalar volume = 0;
        for (const label facei : mesh_.cells()[celli])
        {
            const face& f = mesh_.faces()[facei];
            const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            for (label i = 1; i < f.size() - 1; ++i)
            {
                const vector a(x[f[0]] - C), b(x[f[i]] - C), c(x[f[i + 1]] - C);
                const scalar V = sign*(a & (b ^ c))/6;
                volume += V;
                sum += V/20*(sqr(a) + sqr(b) + sqr(c) + sqr(a + b + c));
            }
        }
        result[celli] = sum/volume;
    }
    halo_.fill(result.begin()->v_, 6);
    return result;
}


Foam::symmTensorField Foam::fsbi::meshStencil::vertexSpreads() const
{
    const pointField& x = mesh_.points();
    const vectorField C(centres());
    const symmTensorField covariance(covariances());
    symmTensorField spread(x.size(), Zero);
    forAll(x, v)
    {
        for (label i = vertexStart_[v]; i < vertexStart_[v + 1]; ++i)
        {
            const label celli = vertexCell_[i];
            spread[v] +=
                vertexWeight_[i]*(sqr(C[celli] - x[v]) + covariance[celli]);
        }
    }
    syncTools::syncPointList
    (
        mesh_, spread, plusEqOp<symmTensor>(), symmTensor::zero
    );
    return spread;
}


void Foam::fsbi::meshStencil::setWalls()
{
    const label nInternal = mesh_.nInternalFaces();
    const pointField& x = mesh_.points();
    const symmTensorField covariance(covariances());
    const symmTensorField spread(vertexSpreads());

    wallWeight_.setSize(mesh_.nFaces() - nInternal);
    forAll(wallWeight_, i)
    {
        const label facei = nInternal + i;
        const label celli = mesh_.faceOwner()[facei];
        const point& Cf = mesh_.faceCentres()[facei];
        const vector n(normalised(mesh_.faceAreas()[facei]));
        const scalar h = n & (Cf - mesh_.cellCentres()[celli]);

        // what the cell mean and the cell gradient make of y^2, y from the
        // wall inwards; wall vertices keep their value, zero
        const scalar mean = (h*h + (n & (covariance[celli] & n)))/h;
        scalar gradient = 0;
        for (label j = cellStart_[celli]; j < cellStart_[celli + 1]; ++j)
        {
            const label v = cellVertex_[j];
            if (!mesh_.faces()[facei].found(v))
            {
                const scalar y = n & (Cf - x[v]);
                gradient -=
                    (cellCoeff_[j] & n)*(y*y + (n & (spread[v] & n)));
            }
        }
        wallWeight_[i] = min(max(gradient/max(gradient - mean, SMALL*h), 1.2), 3);
    }
}
