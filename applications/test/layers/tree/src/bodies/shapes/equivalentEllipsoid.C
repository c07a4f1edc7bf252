/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equivalentEllipsoid.H"
#include <Eigen/Eigenvalues>

Foam::fsbi::equivalentEllipsoid::equivalentEllipsoid
(
    const bodySurface& surface
)
:
    volume(surface.volume())
{
    const symmTensor inertia(surface.inertia());
    moments = (0.5*tr(inertia)*symmTensor::I - inertia)/volume;
    // OpenFOAM's eigenvectors of nearly equal eigenvalues, as a sphere has them, are
    // not orthogonal, and it warns of complex ones
    Eigen::Matrix3d M;
    M << moments.xx(), moments.xy(), moments.xz(),
         moments.xy(), moments.yy(), moments.yz(),
         moments.xz(), moments.yz(), moments.zz();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(M);
    for (direction i = 0; i < 3; ++i)
    {
        // theirs ascend
        axes[i] = sqrt(5*max(solver.eigenvalues()[2 - i], scalar(0)));
        for (direction k = 0; k < 3; ++k)
        {
            directions(i, k) = solver.eigenvectors()(k, 2 - i);
        }
    }
}
