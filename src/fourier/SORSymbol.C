/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SORSymbol.H"

#include "Pair.H"

#include <queue>

//- Accuracy of log|g|^2 that round-off allows
static const Foam::scalar symbolRoundOff = 2e-13;

//- Parts looked at at most; a few hundred are usual
static const Foam::label mostSymbolParts = 20000;

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
            // w^2 + 4 (1 - w)^2 + rise c without the loss of digits at c = 1
            const scalar n = max(sqr(2 - w) - rise*(1 - c), VSMALL);
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
            // 4 + w^2 - 4 w c, likewise
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
    for
    (
        label i = 0;
        i < mostSymbolParts && !parts.empty()
     && parts.top().bound > best + symbolRoundOff;
        ++i
    )
    {
        const part widest = parts.top();
        parts.pop();
        const scalar middle = (widest.a + widest.b)/2;
        best = max(best, log2.value(middle));
        for (const auto& ends : {Pair<scalar>(widest.a, middle),
                                 Pair<scalar>(middle, widest.b)})
        {
            const scalar bound = log2.bound(ends.first(), ends.second());
            if (bound > best + symbolRoundOff)
            {
                parts.push({bound, ends.first(), ends.second()});
            }
        }
    }
    return exp(best/2);
}
