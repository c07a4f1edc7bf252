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


Foam::fsbi::steeringLaw::steeringLaw
(
    const UList<scalar>& frequencies,
    const UList<scalar>& advances,
    const UList<scalar>& stepOuts
)
:
    speeds_(advances.size(), frequencies.size()),
    times_(frequencies.size(), advances.size(), Zero),
    distinction_(0)
{
    const label n = advances.size(), nModes = frequencies.size();
    scalarList largest(n, Zero);
    for (label i = 0; i < n; ++i)
    {
        for (label k = 0; k < nModes; ++k)
        {
            speeds_(i, k) = advances[i]*rate(frequencies[k], stepOuts[i]);
            largest[i] = max(largest[i], mag(speeds_(i, k)));
        }
    }
    // the least squares by V^T (V V^T)^-1, bodies scaled to one
    scalarRectangularMatrix G(n, n, Zero);
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            for (label k = 0; k < nModes; ++k)
            {
                G(i, j) +=
                    speeds_(i, k)*speeds_(j, k)/(largest[i]*largest[j]);
            }
        }
    }
    const SVD parts(G);
    distinction_ = sqrt(max(min(parts.S())/max(parts.S()), scalar(0)));
    const scalarRectangularMatrix inverse(parts.VSinvUt());
    for (label k = 0; k < nModes; ++k)
    {
        for (label j = 0; j < n; ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                times_(k, j) +=
                    speeds_(i, k)/largest[i]*inverse(i, j)/largest[j];
            }
        }
    }
}


Foam::vectorField Foam::fsbi::steeringLaw::times
(
    const vectorField& displacements
) const
{
    vectorField result(times_.m(), Zero);
    forAll(result, k)
    {
        forAll(displacements, i)
        {
            result[k] += times_(k, i)*displacements[i];
        }
    }
    return result;
}
