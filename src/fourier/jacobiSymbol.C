/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "jacobiSymbol.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"
#include "untrapped.H"

#include <Eigen/Eigenvalues>

Foam::vector Foam::fsbi::symmetricEigenvalues(const symmTensor& K)
{
    const untrapped scope;      // Eigen divides by what may underflow
    Eigen::Matrix3d matrix;
    matrix <<
        K.xx(), K.xy(), K.xz(),
        K.xy(), K.yy(), K.yz(),
        K.xz(), K.yz(), K.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver
    (
        matrix, Eigen::EigenvaluesOnly
    );
    const auto& values = solver.eigenvalues();
    return vector(values[0], values[1], values[2]);
}


Foam::vector Foam::fsbi::jacobiSymbol::eigenvalues(const vector& phi) const
{
    return symmetricEigenvalues(scaled(phi));
}


Foam::scalar Foam::fsbi::jacobiSymbol::spectralRadius
(
    const UList<scalar>& factors, const vector& phi
) const
{
    const vector kappa = eigenvalues(phi);
    scalar largest = 0;
    for (direction i = 0; i < 3; ++i)
    {
        largest = max(largest, mag(amplification(factors, kappa[i])));
    }
    return largest;
}


Foam::scalarList Foam::fsbi::jacobiSymbol::ofPeriodicBox
(
    const Vector<label>& n
) const
{
    const scalar turn = constant::mathematical::twoPi;
    DynamicList<scalar> all;
    // the other half of the waves are mirror images
    for (label i = 0; i <= n.x()/2; ++i)
    for (label j = 0; j <= n.y()/2; ++j)
    for (label k = 0; k <= n.z()/2; ++k)
    {
        if (i + j + k > 0)
        {
            const vector kappa = eigenvalues
            (
                turn*vector(i/scalar(n.x()), j/scalar(n.y()), k/scalar(n.z()))
            );
            for (direction d = 0; d < 3; ++d)
            {
                all.append(kappa[d]);
            }
        }
    }
    return scalarList(std::move(all));
}
