/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "identification.H"
#include "untrapped.H"

#include <Eigen/Dense>

namespace Foam
{
namespace fsbi
{

//- Neighbours for the roughness, of a surface with six coefficients
static const label neighbours = 14;

//- Of normal errors, over the median of their magnitude
static const scalar deviationOverMedian = 1.4826;

} // End namespace fsbi
} // End namespace Foam


bool Foam::fsbi::identification::limited(const label k) const
{
    const scalar part =
        (at_[k] - constants_[k].coordinate(constants_[k].lowest))
       /constants_[k].width();
    return part < 1e-3 || part > 1 - 1e-3;
}


Foam::label Foam::fsbi::identification::degreesOfFreedom() const
{
    return 3*data_.size() - nConstants() - rigid_.size();
}


Foam::scalar Foam::fsbi::identification::displacementError() const
{
    return Foam::sqrt(sum(magSqr(residual_))/degreesOfFreedom());
}


Foam::scalar Foam::fsbi::identification::roughness
(
    const vectorField& values
) const
{
    DynamicList<scalar> off;
    forAll(data_.x, i)
    {
        const labelList near
        (
            surfaceTransfer::nearest(data_.x, data_.x[i], neighbours + 1)
        );
        const labelList others(SubList<label>(near, near.size() - 1, 1));
        const scalarList weights
        (
            surfaceTransfer::fit(data_.x, others, data_.x[i], true)
        );
        vector e(values[i]);
        scalar square = 1;
        forAll(others, j)
        {
            e -= weights[j]*values[others[j]];
            square += sqr(weights[j]);
        }
        for (direction k = 0; k < 3 && std::isfinite(mag(e)); ++k)
        {
            off.append(mag(e[k])/Foam::sqrt(square));
        }
    }
    if (off.empty())
    {
        return 0;
    }
    sort(off);
    return deviationOverMedian*off[off.size()/2];
}


Foam::scalar Foam::fsbi::identification::misfit() const
{
    vectorField u(data_.u);
    removeRigid(u);
    return Foam::sqrt(sum(magSqr(residual_))/sum(magSqr(u)));
}


Foam::scalar Foam::fsbi::identification::noise() const
{
    vectorField u(data_.u);
    removeRigid(u);
    return min
    (
        misfit(),
        roughness(data_.u)*Foam::sqrt(scalar(degreesOfFreedom())/sum(magSqr(u)))
    );
}


Foam::List<Foam::scalarList> Foam::fsbi::identification::inverse() const
{
    const label p = nConstants();
    Eigen::MatrixXd JJ(p, p);
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            JJ(k, l) = sum(jacobian_[k] & jacobian_[l]);
        }
    }
    const untrapped scope;          // Eigen computes with what it discards
    const Eigen::MatrixXd inverse(JJ.inverse());
    List<scalarList> result(p, scalarList(p));
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            result[k][l] = inverse(k, l);
        }
    }
    return result;
}


Foam::List<Foam::scalarList> Foam::fsbi::identification::covariance
(
    const scalar tractionError
)
{
    const label p = nConstants();
    const List<scalarList> weights(inverse());
    const surfaceTransfer& transfer = body_.transfer();
    List<vectorField> byU(p), byT(p);
    for (label k = 0; k < p; ++k)
    {
        byU[k].setSize(data_.size(), Zero);
        for (label l = 0; l < p; ++l)
        {
            byU[k] += weights[k][l]*jacobian_[l];
        }
        vectorField response, reaction;
        if (!body_.respond(transfer.fromPoints(byU[k]), response, reaction))
        {
            return List<scalarList>(p, scalarList(p, GREAT));
        }
        byT[k] = transfer.fromFaces(body_.areas()*response);
        byU[k] += transfer.fromFaces(reaction) - body_.stiffness()*byT[k];
    }
    List<scalarList> result(p, scalarList(p));
    for (label k = 0; k < p; ++k)
    {
        for (label l = 0; l < p; ++l)
        {
            result[k][l] =
                sqr(displacementError())*sum(byU[k] & byU[l])
              + sqr(tractionError)*sum(byT[k] & byT[l]);
        }
    }
    return result;
}
