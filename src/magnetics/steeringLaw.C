/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "steeringLaw.H"
#include "SVD.H"

Foam::scalar Foam::fsbi::steeringLaw::rate
(
    const scalar frequency, const scalar stepOut
)
{
    return
        frequency <= stepOut
      ? frequency
      : frequency - sqrt(sqr(frequency) - sqr(stepOut));
}


Foam::scalarRectangularMatrix Foam::fsbi::steeringLaw::scaled
(
    const labelUList& bodies, scalarList& largest
) const
{
    scalarRectangularMatrix V(bodies.size(), speeds_.n());
    largest = scalarList(bodies.size(), Zero);
    forAll(bodies, i)
    {
        for (label k = 0; k < V.n(); ++k)
        {
            largest[i] = max(largest[i], mag(speeds_(bodies[i], k)));
        }
        for (label k = 0; k < V.n(); ++k)
        {
            V(i, k) = speeds_(bodies[i], k)/largest[i];
        }
    }
    return V;
}


Foam::scalarRectangularMatrix Foam::fsbi::steeringLaw::products
(
    const scalarRectangularMatrix& V
)
{
    scalarRectangularMatrix G(V.m(), V.m(), Zero);
    for (label i = 0; i < V.m(); ++i)
    {
        for (label j = 0; j < V.m(); ++j)
        {
            for (label k = 0; k < V.n(); ++k)
            {
                G(i, j) += V(i, k)*V(j, k);
            }
        }
    }
    return G;
}


Foam::fsbi::steeringLaw::steeringLaw
(
    const UList<scalar>& frequencies,
    const UList<scalar>& advances,
    const UList<scalar>& stepOuts
)
:
    speeds_(advances.size(), frequencies.size()),
    distinction_(0)
{
    forAll(advances, i)
    {
        forAll(frequencies, k)
        {
            speeds_(i, k) = advances[i]*rate(frequencies[k], stepOuts[i]);
        }
    }
    scalarList largest;
    const SVD parts(products(scaled(identity(advances.size()), largest)));
    distinction_ = sqrt(max(min(parts.S())/max(parts.S()), scalar(0)));
}


Foam::vectorField Foam::fsbi::steeringLaw::times
(
    const vectorField& displacements, const labelUList& bodies
) const
{
    vectorField result(speeds_.n(), Zero);
    if (bodies.empty())
    {
        return result;
    }
    // the least squares by V^T (V V^T)^-1, bodies scaled to one
    scalarList largest;
    const scalarRectangularMatrix V(scaled(bodies, largest));
    const scalarRectangularMatrix inverse(SVD(products(V)).VSinvUt());
    forAll(result, k)
    {
        forAll(bodies, j)
        {
            scalar time = 0;
            forAll(bodies, i)
            {
                time += V(i, k)*inverse(i, j)/largest[j];
            }
            result[k] += time*displacements[bodies[j]];
        }
    }
    return result;
}
