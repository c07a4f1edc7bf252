/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactRate.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::contactRate::contactRate
(
    const bondLaw& law, const scalar roughness
)
:
    law_(law),
    roughness_(roughness),
    nearest_(0),
    reach_(0),
    table_(1025, Zero)
{
    // out to where k_on has fallen to 1e-15 of its peak
    const scalar rest = law.lambda();
    const scalar sigma = law.thermalLength();
    scalar peak = law.logOn(rest);
    scalar x = sigma;
    for (; law.logOn(rest + x) > peak - 34.5; x += 0.25*sigma)
    {
        peak = max(peak, law.logOn(rest + x));
    }
    nearest_ = rest + roughness - x;
    reach_ = rest + roughness + x;

    for (label i = table_.size() - 2; i >= 0; --i)
    {
        const scalar r = nearest_ + i*interval();
        table_[i] = table_[i + 1] + between(r, r + interval());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fsbi::contactRate::between
(
    const scalar from, const scalar to
) const
{
    // Gauss-Legendre, five points
    constexpr scalar x[3] = {0, 0.5384693101056831, 0.9061798459386640};
    constexpr scalar w[3] =
        {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};

    const scalar half = 0.5*(to - from);
    const auto f = [&](const scalar at)
    {
        // no ligand is nearer than zero
        const scalar r = max(0.5*(from + to) + half*at, scalar(0));
        return law_.kOn(r - roughness_)*r;
    };
    scalar sum = w[0]*f(0);
    for (label i = 1; i < 3; ++i)
    {
        sum += w[i]*(f(x[i]) + f(-x[i]));
    }
    return constant::mathematical::twoPi*half*sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::contactRate::operator()(const scalar gap) const
{
    if (gap >= reach_)
    {
        return 0;
    }
    const scalar from = max(gap, nearest_);
    const label last = table_.size() - 1;
    const label next =
        min(last, label(std::floor((from - nearest_)/interval())) + 1);
    return between(from, nearest_ + next*interval()) + table_[next];
}


Foam::scalar Foam::fsbi::contactRate::distance
(
    const scalar gap, const scalar u
) const
{
    // the rate beyond r falls from K(g) at g to zero at the reach
    const scalar target = u*operator()(gap);
    scalar low = max(gap, nearest_);
    scalar high = reach_;
    while (true)
    {
        const scalar middle = 0.5*(low + high);
        if (!(middle > low && middle < high))
        {
            return middle;
        }
        (operator()(middle) > target ? low : high) = middle;
    }
}
