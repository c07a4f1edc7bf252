/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "simplexRules.H"

namespace Foam
{
namespace fsbi
{

//- Gauss' rules on (0, 1)
template<unsigned n>
struct gaussRule
{
    scalar x[n];
    scalar weights[n];
};

static const gaussRule<2> twoPoints
{
    {0.2113248654051871, 0.7886751345948129}, {0.5, 0.5}
};
static const gaussRule<3> threePoints
{
    {0.1127016653792583, 0.5, 0.8872983346207417},
    {5.0/18, 8.0/18, 5.0/18}
};
static const gaussRule<5> fivePoints
{
    {
        0.0469100770306680, 0.2307653449471585, 0.5,
        0.7692346550528415, 0.9530899229693320
    },
    {
        0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
        0.2393143352496832, 0.1184634425280945
    }
};


template<unsigned n, unsigned m, class Add>
static void addProducts
(
    const gaussRule<n>& a, const gaussRule<m>& b, const Add& add
)
{
    for (unsigned i = 0; i < n; ++i)
    {
        for (unsigned j = 0; j < m; ++j)
        {
            add(a.x[i], b.x[j], a.weights[i]*b.weights[j]);
        }
    }
}


template<unsigned n, unsigned m, unsigned l, class Add>
static void addProducts
(
    const gaussRule<n>& a,
    const gaussRule<m>& b,
    const gaussRule<l>& c,
    const Add& add
)
{
    for (unsigned i = 0; i < n; ++i)
    {
        const auto addOne =
            [&](const scalar s, const scalar q, const scalar weight)
        {
            add(a.x[i], s, q, a.weights[i]*weight);
        };
        addProducts(b, c, addOne);
    }
}


//- The corners, those on the edge first; how many are there?
template<unsigned n>
static label setFirst
(
    const FixedList<point, n>& corners,
    const FixedList<bool, n>& onEdge,
    FixedList<point, n>& x
)
{
    label k = 0;
    for (const bool first : {true, false})
    {
        forAll(corners, i)
        {
            if (onEdge[i] == first)
            {
                x[k++] = corners[i];
            }
        }
    }
    k = 0;
    for (const bool on : onEdge)
    {
        k += on;
    }
    return k;
}


static void normalise(weightedPoints& rule)
{
    scalar sum = 0;
    for (const scalar w : rule.weights)
    {
        sum += w;
    }
    for (scalar& w : rule.weights)
    {
        w /= sum;
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::weightedPoints Foam::fsbi::triangleRule
(
    const FixedList<point, 3>& corners, const FixedList<bool, 3>& onEdge
)
{
    FixedList<point, 3> x;
    const label n = setFirst(corners, onEdge, x);
    // from the edge or the corner x[0], t = (distance from there)^power
    const bool line = n == 2;
    const label power = n == 0 || n == 3 ? 1 : line ? 4 : 3;
    weightedPoints rule;
    const auto add = [&](const scalar tau, const scalar s, const scalar weight)
    {
        const scalar t = Foam::pow(tau, power);
        const point onFirst(line ? (1 - s)*x[0] + s*x[1] : x[0]);
        const point onLast(line ? x[2] : (1 - s)*x[1] + s*x[2]);
        rule.x.append((1 - t)*onFirst + t*onLast);
        rule.weights.append(weight*(line ? 1 - t : t)*Foam::pow(tau, power - 1));
    };
    if (power == 1)
    {
        addProducts(twoPoints, twoPoints, add);
    }
    else
    {
        addProducts(fivePoints, threePoints, add);
    }
    normalise(rule);
    return rule;
}


Foam::fsbi::weightedPoints Foam::fsbi::tetrahedronRule
(
    const FixedList<point, 4>& corners, const FixedList<bool, 4>& onEdge
)
{
    FixedList<point, 4> x;
    const label n = setFirst(corners, onEdge, x);
    const bool line = n == 2;
    const label power = n == 0 || n > 2 ? 1 : line ? 3 : 2;
    weightedPoints rule;
    const auto add =
        [&](const scalar tau, const scalar s, const scalar q, const scalar weight)
    {
        const scalar t = Foam::pow(tau, power);
        const scalar density = Foam::pow(tau, power - 1);
        if (line)
        {
            rule.x.append
            (
                (1 - t)*((1 - s)*x[0] + s*x[1]) + t*((1 - q)*x[2] + q*x[3])
            );
            rule.weights.append(weight*density*t*(1 - t));
        }
        else
        {
            rule.x.append
            (
                (1 - t)*x[0] + t*((1 - s)*x[1] + s*((1 - q)*x[2] + q*x[3]))
            );
            rule.weights.append(weight*density*t*t*s);
        }
    };
    if (power == 1)
    {
        addProducts(twoPoints, twoPoints, twoPoints, add);
    }
    else
    {
        addProducts(fivePoints, twoPoints, twoPoints, add);
    }
    normalise(rule);
    return rule;
}
