/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equivalentEllipsoid.H"

Foam::fsbi::equivalentEllipsoid::equivalentEllipsoid
(
    const bodySurface& surface
)
:
    volume(surface.volume())
{
    const symmTensor inertia(surface.inertia());
    const symmTensor moments
    (
        (0.5*tr(inertia)*symmTensor::I - inertia)/volume
    );
    const vector values(eigenValues(moments));          // ascending
    const tensor vectors(eigenVectors(moments, values));
    for (direction i = 0; i < 3; ++i)
    {
        axes[i] = sqrt(5*max(values[2 - i], scalar(0)));
    }
    directions = tensor(vectors.z(), vectors.y(), vectors.x());
}
