/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "immersedBody.H"
#include "mathematicalConstants.H"
#include "symmTensor.H"

Foam::fsbi::sixVector Foam::fsbi::immersedBody::motion() const
{
    const vectorField v(pointVelocity());
    const vectorField x(placedSurface().points());
    const vector centre(average(x)), mean(average(v));
    vector momentum(Zero);
    symmTensor inertia(Zero);
    forAll(x, i)
    {
        const vector r(x[i] - centre);
        momentum += r ^ (v[i] - mean);
        inertia += magSqr(r)*symmTensor::I - sqr(r);
    }
    return join(mean, inv(inertia) & momentum);
}


Foam::scalar Foam::fsbi::immersedBody::radius() const
{
    return sqrt(placedSurface().area()/(4*constant::mathematical::pi));
}
