/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SORSymbol.H"

#include "Pair.H"

#include <queue>

namespace Foam
{
namespace fsbi
{

//- log|g|^2 of all steps as a function of c = cos(theta), in two parts
class stepLogarithm
{
    const UList<scalar>& factors_;

public:

    explicit stepLogarithm(const UList<scalar>& factors) : factors_(factors) {}

    //- log of the numerators, with the slope of its tangent
    scalar concave(const scalar c, scalar& slope) const
    {
        scalar sum = 0;
        slope = 0;
        for (const scalar w : factors_)
        {
            const scalar rise = 4*w*(1 - w);
            const scalar n = max(sqr(w) + 4*sqr(1 - w) + rise*c, VSMALL);
            sum += log(n);
            slope += rise/n;
        }
        return sum;
    }

    //- -log of the denominators
    scalar convex(const scalar c) const
    {
        scalar sum = 0;
        for (const scalar w : factors_)
        {
            // (2 - w)^2 + 4 w (1 - c) would be 4 + w^2 - 4 w c
            sum -= log(max(sqr(2 - w) + 4*w*(1 - c), VSMALL));
        }
        return sum;
    }

    scalar value(const scalar c) const
    {
        scalar slope;
        return concave(c, slope) + convex(c);
    }

    //- Above value() on [a, b]
    scalar bound(const scalar a, const scalar b) const
    {
        scalar slope;
        const scalar tangent = concave((a + b)/2, slope);
        const scalar rise = slope*(b - a)/2;
        return tangent + max(convex(a) - rise, convex(b) + rise);
    }
};

} // End namespace fsbi
} // End namespace Foam


std::complex<Foam::scalar> Foam::fsbi::SORSymbol::step
(
    const scalar theta, const scalar factor
)
{
    const std::complex<scalar> wave = std::polar(scalar(1), theta);
    return (factor*wave + 2*(1 - factor))/(scalar(2) - factor*std::conj(wave));
}


Foam::scalar Foam::fsbi::SORSymbol::spectralRadius
(
    const UList<scalar>& factors, const scalar thetaMin
)
{
    struct part
    {
        scalar bound, a, b;
        bool operator<(const part& other) const { return bound < other.bound; }
    };
    const stepLogarithm log2(factors);
    const scalar highest = cos(thetaMin);
    scalar best = max(log2.value(-1), log2.value(highest));
    std::priority_queue<part> parts;
    parts.push({GREAT, -1, highest});
    while (!parts.empty() && parts.top().bound > best + 1e-14)
    {
        const part widest = parts.top();
        parts.pop();
        const scalar middle = (widest.a + widest.b)/2;
        best = max(best, log2.value(middle));
        if (widest.b - widest.a < 1e-15)
        {
            continue;
        }
        for (const auto& ends : {Pair<scalar>(widest.a, middle),
                                 Pair<scalar>(middle, widest.b)})
        {
            const scalar bound = log2.bound(ends.first(), ends.second());
            if (bound > best + 1e-14)
            {
                parts.push({bound, ends.first(), ends.second()});
            }
        }
    }
    return exp(best/2);
}
