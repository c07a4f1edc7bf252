/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourGradient.H"
#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Directions of which a cell's neighbours show less than this part are open
static const scalar openDirection = 1e-9;

//- Inverse in the directions that the matrix has
static tensor pseudoInverse(const tensor& M)
{
    typedef Eigen::Matrix<scalar, 3, 3, Eigen::RowMajor> matrix;
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> parts
    (
        Eigen::Map<const matrix>(M.cdata())
    );
    parts.setThreshold(openDirection);
    tensor result;
    Eigen::Map<matrix>(result.data()) = parts.pseudoInverse();
    return result;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::neighbourGradient::neighbourGradient
(
    const meshStencil& stencil, const bool leastSquares
)
:
    stencil_(stencil),
    leastSquares_(leastSquares)
{}


void Foam::fsbi::neighbourGradient::addFace
(
    const label celli, const vector& S, const vector& d,
    const scalar part, vector& coefficient, tensorField& M
) const
{
    if (leastSquares_)
    {
        coefficient = d/magSqr(d);
        M[celli] += d*coefficient;
    }
    else
    {
        coefficient = part*S/stencil_.mesh().cellVolumes()[celli];
    }
}


void Foam::fsbi::neighbourGradient::update(const boolList& given)
{
    const fvMesh& mesh = stencil_.mesh();
    const label nCells = mesh.nCells();
    const label nInner = stencil_.owner().size();
    tensorField M(nCells, leastSquares_ ? tensor::zero : tensor::I);
    ofOwner_ = vectorField(nInner, Zero);
    ofNeighbour_ = vectorField(nInner, Zero);
    ofBoundary_ = vectorField(given.size(), Zero);

    for (label i = 0; i < nInner; ++i)
    {
        const vector& S = stencil_.area()[i];
        const vector& rP = stencil_.fromOwner()[i];
        const vector& rN = stencil_.fromNeighbour()[i];
        const scalar k = mag(rP)/(mag(rP) + mag(rN));
        const label N = stencil_.neighbour()[i];
        addFace(stencil_.owner()[i], S, rP - rN, k, ofOwner_[i], M);
        if (N < nCells)
        {
            addFace(N, -S, rN - rP, 1 - k, ofNeighbour_[i], M);
        }
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const label start = pp.start() - mesh.nInternalFaces();
        for (label i = 0; !pp.coupled() && i < pp.size(); ++i)
        {
            const label P = pp.faceCells()[i];
            const vector& S = mesh.faceAreas()[pp.start() + i];
            const vector d(mesh.faceCentres()[pp.start() + i] - mesh.cellCentres()[P]);
            if (given[start + i])
            {
                addFace(P, S, d, 1, ofBoundary_[start + i], M);
            }
            else if (!leastSquares_)
            {
                M[P] -= S*d/mesh.cellVolumes()[P];
            }
        }
    }

    for (tensor& m : M)
    {
        m = pseudoInverse(m);
    }
    for (label i = 0; i < nInner; ++i)
    {
        const label N = stencil_.neighbour()[i];
        ofOwner_[i] = M[stencil_.owner()[i]] & ofOwner_[i];
        ofNeighbour_[i] = N < nCells ? M[N] & ofNeighbour_[i] : vector(Zero);
    }
    forAll(ofBoundary_, i)
    {
        const label P = mesh.faceOwner()[mesh.nInternalFaces() + i];
        ofBoundary_[i] = M[P] & ofBoundary_[i];
    }
}


void Foam::fsbi::neighbourGradient::set
(
    const scalar* values,
    const label first,
    const label n,
    const UList<vector>& given,
    scalar* gradients
) const
{
    const fvMesh& mesh = stencil_.mesh();
    const label nCells = mesh.nCells();
    for (label celli = 0; celli < nCells; ++celli)
    {
        std::fill_n(gradients + 12*celli + 3*first, 3*n, scalar(0));
    }
    const auto add = [&](const label celli, const label k, const vector& g)
    {
        for (direction j = 0; j < 3; ++j)
        {
            gradients[12*celli + 3*k + j] += g[j];
        }
    };
    for (label k = first; k < first + n; ++k)
    {
        forAll(ofOwner_, i)
        {
            const label P = stencil_.owner()[i];
            const label N = stencil_.neighbour()[i];
            const scalar jump = values[4*N + k] - values[4*P + k];
            add(P, k, jump*ofOwner_[i]);
            if (N < nCells)
            {
                add(N, k, -jump*ofNeighbour_[i]);
            }
        }
        for (label i = 0; i < given.size(); ++i)
        {
            const label P = mesh.faceOwner()[mesh.nInternalFaces() + i];
            add(P, k, (given[i][k - first] - values[4*P + k])*ofBoundary_[i]);
        }
    }
}
