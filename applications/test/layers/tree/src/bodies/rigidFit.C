/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rigidFit.H"

#include <Eigen/Eigenvalues>

namespace Foam
{
namespace fsbi
{

static scalarField areaWeights(const bodySurface& surface)
{
    scalarField weights(surface.points().size(), Zero);
    for (const triFace& t : surface.triangles())
    {
        for (const label p : t)
        {
            weights[p] += t.mag(surface.points());
        }
    }
    return weights;
}


//- The rotation by which the sum of a_i (R b_i) is largest, S: sum of b_i a_i
static quaternion rotationOf(const tensor& S)
{
    Eigen::Matrix4d N;
    N << tr(S), S.yz() - S.zy(), S.zx() - S.xz(), S.xy() - S.yx(),
        0, 2*S.xx() - tr(S), S.xy() + S.yx(), S.zx() + S.xz(),
        0, 0, 2*S.yy() - tr(S), S.yz() + S.zy(),
        0, 0, 0, 2*S.zz() - tr(S);
    const Eigen::Matrix4d full(N.selfadjointView<Eigen::Upper>());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(full);
    const Eigen::Vector4d q(solver.eigenvectors().col(3));
    return quaternion(q[0], vector(q[1], q[2], q[3]));
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::rigidFit::rigidFit
(
    const pointField& reference, const scalarField& weights
)
:
    weights_(weights/sum(weights)),
    reference_(reference - sum(weights_*reference))
{}


Foam::fsbi::rigidFit::rigidFit(const bodySurface& reference)
:
    rigidFit(reference.points(), areaWeights(reference))
{}


Foam::fsbi::placement Foam::fsbi::rigidFit::operator()
(
    const pointField& now
) const
{
    placement where;
    where.centre = sum(weights_*now);
    tensor S(Zero);
    forAll(now, i)
    {
        S += weights_[i]*reference_[i]*(now[i] - where.centre);
    }
    where.orientation = rotationOf(S);
    return where;
}
