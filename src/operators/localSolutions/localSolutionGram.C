/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSolutionGram.H"

Foam::fsbi::localSolutionGram::solutionMatrix
Foam::fsbi::localSolutionGram::normal() const
{
    const monomialMatrix ofCells(pressure_.selfadjointView<Eigen::Lower>());
    const monomialMatrix ofVelocity
    (
        monomialMatrix(velocity_.selfadjointView<Eigen::Lower>()) + ofCells
    );
    const label* start = solutions_.start().cdata();
    const label* coefficient = solutions_.coefficient().cdata();
    const scalar* value = solutions_.value().cdata();

    solutionMatrix N;
    for (label j = 0; j < n; ++j)
    {
        Eigen::Matrix<scalar, 4, nCubic> product
        (
            Eigen::Matrix<scalar, 4, nCubic>::Zero()
        );
        for (label i = start[j]; i < start[j + 1]; ++i)
        {
            const label k = coefficient[i]/4, component = coefficient[i] % 4;
            product.row(component) +=
                value[i]*(component < 3 ? ofVelocity : ofCells).col(k);
        }
        for (label row = j; row < n; ++row)
        {
            scalar sum = 0;
            for (label i = start[row]; i < start[row + 1]; ++i)
            {
                sum += value[i]*product.data()[coefficient[i]];
            }
            N(row, j) = sum;
        }
    }
    return N;
}


bool Foam::fsbi::localSolutionGram::factorise
(
    const bool onWall, const bool lowDegree, const scalar least
)
{
    solutionMatrix N(normal());
    if (lowDegree)
    {
        nUsed_ = stokesPolynomials::nQuadraticSolutions;
        N.bottomRows(n - nUsed_).setZero();
        N.diagonal().tail(n - nUsed_).setOnes();
    }
    if (onWall)
    {
        N.leftCols<3>().setZero();
        N.diagonal().head<3>().setOnes();
    }
    factor_.compute(N);
    if (factor_.info() == Eigen::Success && factor_.rcond() > least)
    {
        return true;
    }
    N.diagonal().array() += least*N.diagonal().maxCoeff();
    factor_.compute(N);
    return false;
}


void Foam::fsbi::localSolutionGram::inverseFactor(scalar* rows) const
{
    solutionMatrix inverse(solutionMatrix::Identity());
    factor_.matrixL().solveInPlace(inverse);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < 4*(i/4 + 1); ++j)
        {
            *rows++ = j <= i && i < nUsed_ ? inverse(i, j) : 0;
        }
    }
}
