/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrownianPath.H"
#include "mathematicalConstants.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{

//- Halvings of an interval, and its places
static const int halvings = 30;
static const int64_t places = int64_t(1) << halvings;

//- a + b and a += c b
static sixVector sum
(
    const sixVector& a, const sixVector& b, const scalar c = 1
)
{
    sixVector result(a);
    forAll(result, k)
    {
        result[k] += c*b[k];
    }
    return result;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::sixVector Foam::fsbi::BrownianPath::normals
(
    const int64_t interval, const int64_t place
) const
{
    counterRandom::stream draws(random_.at(uint32_t(interval), uint32_t(place)));
    sixVector n;
    for (label k = 0; k < 6; k += 2)
    {
        // Box and Muller
        const scalar r = std::sqrt(-2*std::log(draws.uniform()));
        const scalar angle = constant::mathematical::twoPi*draws.uniform();
        n[k] = r*std::cos(angle);
        n[k + 1] = r*std::sin(angle);
    }
    return n;
}


Foam::fsbi::sixVector Foam::fsbi::BrownianPath::within
(
    const int64_t interval, const int64_t place
) const
{
    const sixVector none(scalar(0));
    if (place == 0)
    {
        return none;
    }
    int64_t a = 0, b = places;
    sixVector atA(none);
    sixVector atB(sum(none, normals(interval, 0), std::sqrt(interval_)));
    while (b != place)
    {
        const int64_t middle = (a + b)/2;
        const scalar h = interval_*scalar(b - a)/scalar(places);
        sixVector between(sum(atA, atB));
        forAll(between, k)
        {
            between[k] *= 0.5;
        }
        between =
            sum(between, normals(interval, middle), 0.5*std::sqrt(h));
        if (place <= middle)
        {
            b = middle;
            atB = between;
        }
        else
        {
            a = middle;
            atA = between;
        }
    }
    return atB;
}


Foam::fsbi::sixVector Foam::fsbi::BrownianPath::increment
(
    const scalar from, const scalar to
) const
{
    const int64_t begin = std::llround(from/interval_*places);
    const int64_t end = std::llround(to/interval_*places);
    const int64_t first = begin >> halvings, last = end >> halvings;
    sixVector dW(within(last, end - last*places));
    for (int64_t i = first; i < last; ++i)
    {
        dW = sum(dW, within(i, places));
    }
    return sum(dW, within(first, begin - first*places), -1);
}
