/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "modeFit.H"
#include "localSolutionGram.H"
#include "simplexRules.H"
#include <Eigen/Eigenvalues>

namespace Foam
{
namespace fsbi
{

//- Eigenvalue of S, over the modes' own squares, below which a combination of
//  modes is left to the polynomials
static const scalar polynomial = 1e-7;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::modeFit::modeFit
(
    const vertexFit& f,
    const wedge& w,
    const wedgeModes& modes,
    const UList<point>& ring,
    const UList<point>& onFacets,
    const UList<cellAtEdge>& cells
)
:
    f_(f),
    wedge_(w),
    modes_(modes),
    ring_(ring),
    onFacets_(onFacets),
    all_(identity(f.cells.size())),
    centres_(f.cells.size()),
    moments_(f.cells.size())
{
    forAll(all_, i)
    {
        centres_[i] = f.centres[f.cells[i]];
        moments_[i] = f.moments[f.cells[i]];
    }
    setValues(cells);
    setWeights();
    rest_ = values_;
    const auto atVertex(w.flowsAt(f.origin, modes_, f.perLength));
    for (label k = 0; k < nModes; ++k)
    {
        takeOffPolynomial(k, f.onWall ? atVertex[k].u : vector::zero);
    }
}


void Foam::fsbi::modeFit::setValues(const UList<cellAtEdge>& cells)
{
    const label nCells = all_.size();
    values_ = Eigen::MatrixXd::Zero(4*nCells + 3*ring_.size(), nModes);
    forAll(all_, i)
    {
        const cellAtEdge& cell = cells[f_.cells[i]];
        const weightedPoints rule(tetrahedronRule(cell.corners, cell.onEdge));
        forAll(rule.x, q)
        {
            const auto flows(wedge_.flowsAt(rule.x[q], modes_, f_.perLength));
            forAll(flows, k)
            {
                const vector& u = flows[k].u;
                values_.col(k).segment<4>(4*i) +=
                    rule.weights[q]
                   *Eigen::Vector4d(u.x(), u.y(), u.z(), flows[k].p);
            }
        }
    }
    forAll(ring_, j)
    {
        const auto flows(wedge_.flowsAt(onFacets_[j], modes_, f_.perLength));
        forAll(flows, k)
        {
            const vector& u = flows[k].u;
            values_.col(k).segment<3>(4*nCells + 3*j) << u.x(), u.y(), u.z();
        }
    }
}


void Foam::fsbi::modeFit::setWeights()
{
    const scalar s2 = sqr(f_.perLength);
    const label nCells = all_.size();
    weights_.resize(values_.rows());
    forAll(all_, i)
    {
        const scalar w = cellWeight(s2*magSqr(centres_[i] - f_.origin));
        weights_.segment<4>(4*i) << w, w, w, w/s2;
    }
    forAll(ring_, j)
    {
        const scalar w = pointWeight(s2*magSqr(ring_[j] - f_.origin));
        weights_.segment<3>(4*nCells + 3*j).setConstant(w);
    }
}


void Foam::fsbi::modeFit::takeOffPolynomial
(
    const label k, const vector& atVertex
)
{
    const label nCells = all_.size();
    const scalar* values = values_.col(k).data();
    const vertexFit fit
    {
        f_.solutions, f_.factor, f_.perLength, f_.origin, f_.onWall,
        {atVertex.x(), atVertex.y(), atVertex.z(), 0}, all_,
        centres_.cdata(), moments_.cdata(), values
    };
    scalarList rows(nCubic*(nCells + 3));
    scalar b[nCoefficients] = {};
    addCells(fit, rows.begin(), b);
    forAll(ring_, j)
    {
        const scalar* u = values + 4*nCells + 3*j;
        addPoint(fit, ring_[j], vector(u[0], u[1], u[2]), b);
    }
    scalar* c = coefficients_ + k*nCoefficients;
    solve(fit, b, c);
    setDefects(fit, rows.cdata(), c, all_, rest_.col(k).data());
    forAll(ring_, j)
    {
        const vector u(velocityOf(c, f_.perLength*(ring_[j] - f_.origin)));
        rest_.col(k).segment<3>(4*nCells + 3*j) -=
            Eigen::Vector3d(u.x(), u.y(), u.z());
    }
}


Eigen::MatrixXd Foam::fsbi::modeFit::toAmplitudes() const
{
    const Eigen::MatrixXd weighted(weights_.asDiagonal()*rest_);
    const Eigen::Vector3d scale
    (
        (values_.cwiseAbs2().transpose()*weights_)
       .cwiseMax(VSMALL).cwiseSqrt().cwiseInverse()
    );
    const Eigen::Matrix3d S
    (
        scale.asDiagonal()*(rest_.transpose()*weighted)*scale.asDiagonal()
    );
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(S);
    Eigen::Vector3d values(solver.eigenvalues());
    for (label k = 0; k < nModes; ++k)
    {
        values[k] = values[k] > polynomial ? 1/values[k] : 0;
    }
    const Eigen::Matrix3d V(solver.eigenvectors());
    return
        weighted*scale.asDiagonal()*V*values.asDiagonal()
       *V.transpose()*scale.asDiagonal();
}
