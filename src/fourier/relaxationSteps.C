/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "relaxationSteps.H"
#include "mathematicalConstants.H"
#include "SortableList.H"

namespace Foam
{
namespace fsbi
{

//- The maximum between two neighbouring roots
static scalar peak(const UList<scalar>& factors, scalar left, scalar right)
{
    for (label i = 0; i < 200 && right - left > 1e-16*mag(right); ++i)
    {
        const scalar middle = (left + right)/2;
        scalar slope = 0;       // of log|p|, falls from left to right
        for (const scalar omega : factors)
        {
            const scalar rest = 1 - omega*middle;
            slope -= omega/(mag(rest) < VSMALL ? VSMALL : rest);
        }
        (slope > 0 ? left : right) = middle;
    }
    return mag(amplification(factors, (left + right)/2));
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::amplification
(
    const UList<scalar>& factors, const scalar eigenvalue
)
{
    scalar product = 1;
    for (const scalar omega : factors)
    {
        product *= 1 - omega*eigenvalue;
    }
    return product;
}


Foam::scalar Foam::fsbi::spectralRadius
(
    const UList<scalar>& factors, const eigenvalueRange& range
)
{
    SortableList<scalar> roots;
    for (const scalar omega : factors)
    {
        if (omega != 0)
        {
            roots.append(1/omega);
        }
    }
    roots.sort();
    scalar largest = max
    (
        mag(amplification(factors, range.lowest)),
        mag(amplification(factors, range.highest))
    );
    for (label i = 1; i < roots.size(); ++i)
    {
        const scalar left = max(roots[i - 1], range.lowest);
        const scalar right = min(roots[i], range.highest);
        if (left < right)
        {
            largest = max(largest, peak(factors, left, right));
        }
    }
    return largest;
}


Foam::scalar Foam::fsbi::spectralRadius
(
    const UList<scalar>& factors, const UList<scalar>& eigenvalues
)
{
    scalar largest = 0;
    for (const scalar kappa : eigenvalues)
    {
        largest = max(largest, mag(amplification(factors, kappa)));
    }
    return largest;
}


Foam::scalar Foam::fsbi::radiusPerStep
(
    const UList<scalar>& factors, const eigenvalueRange& range
)
{
    return pow(spectralRadius(factors, range), 1/scalar(factors.size()));
}


Foam::scalarList Foam::fsbi::bestFactors
(
    const label steps, const eigenvalueRange& range
)
{
    const scalar middle = (range.lowest + range.highest)/2;
    const scalar half = (range.highest - range.lowest)/2;
    scalarList factors(steps);
    forAll(factors, i)
    {
        const scalar angle = (2*i + 1)*constant::mathematical::pi/(2*steps);
        factors[i] = 1/(middle + half*cos(angle));
    }
    return tamed(factors, range);
}


Foam::scalar Foam::fsbi::bestRadius
(
    const label steps, const eigenvalueRange& range
)
{
    // T_m(1 + d) without the loss of digits of 1 + d
    const scalar d = 2*range.lowest/(range.highest - range.lowest);
    const scalar angle = log1p(d + sqrt(d*(d + 2)));
    return 1/cosh(steps*angle);
}


Foam::scalarList Foam::fsbi::tamed
(
    scalarList factors, const eigenvalueRange& range
)
{
    for (label done = 1; done < factors.size(); ++done)
    {
        label best = done;
        scalar lowest = GREAT;
        for (label i = done; i < factors.size(); ++i)
        {
            Swap(factors[done], factors[i]);
            const SubList<scalar> taken(factors, done + 1);
            const scalar radius = spectralRadius(taken, range);
            Swap(factors[done], factors[i]);
            if (radius < lowest)
            {
                lowest = radius;
                best = i;
            }
        }
        Swap(factors[done], factors[best]);
    }
    return factors;
}


Foam::scalar Foam::fsbi::speedUp
(
    const scalar radius, const scalar referenceRadius
)
{
    return radius < 1 ? log(radius)/log(referenceRadius) : 0;
}
