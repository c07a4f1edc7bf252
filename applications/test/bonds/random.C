/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "materialPoint.H"

#include <array>

namespace Foam
{
namespace fsbi
{

// Known answers of Random123's distribution, tests/kat_vectors
static void checkVectors(checks& c)
{
    using words = counterRandom::words;
    const auto give = counterRandom::philox;
    const uint32_t f = 0xffffffff;
    c.check
    (
        "Philox4x32-10 of zeros",
        give({{0, 0, 0, 0}}, {{0, 0}})
     == words{{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}}
    );
    c.check
    (
        "Philox4x32-10 of ones",
        give({{f, f, f, f}}, {{f, f}})
     == words{{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}}
    );
    c.check
    (
        "Philox4x32-10 of the digits of pi",
        give
        (
            {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
            {{0xa4093822, 0x299f31d0}}
        )
     == words{{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}
    );
    c.check
    (
        "FNV-1a hash of names",
        counterRandom::hash("a") == 0xe40c292c
     && counterRandom::hash("foobar") == 0xbf9cf968
    );
}


void checkRandom(checks& c)
{
    checkVectors(c);

    // the counter is (event, site, draw, 0)
    const counterRandom random(7, "LFA-1");
    counterRandom::stream draws(random.at(3, 5));
    bool same = true;
    for (uint32_t draw = 0; draw < 3; ++draw)
    {
        const auto w = counterRandom::philox
        (
            {{3, 5, draw, 0}}, {{7, counterRandom::hash("LFA-1")}}
        );
        for (label i = 0; i < 4; i += 2)
        {
            const uint64_t bits =
                (uint64_t(w[i] >> 5) << 26) + (w[i + 1] >> 6) + 1;
            same = same && draws.uniform() == std::ldexp(scalar(bits), -53);
        }
    }
    c.check("uniform numbers have the counter (event, site, draw)", same);

    const label n = 100000;
    scalar sum = 0, squares = 0, low = 1, high = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar u = random.at(0, i).uniform();
        sum += u;
        squares += u*u;
        low = min(low, u);
        high = max(high, u);
    }
    checkSigma(c, "mean of uniform numbers", sum/n, 0.5, sqrt(1/12.0/n));
    checkSigma(c, "their mean square", squares/n, 1/3.0, sqrt(4/45.0/n));
    c.check("they lie in (0, 1]", low > 0 && high <= 1);
}


// Two triangles of a unit square, and a large one far away
void checkSpread(checks& c)
{
    const pointField points
    ({
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 0, 1}, {9, 8, 1}
    });
    const List<triFace> triangles
    ({
        triFace{0, 1, 2}, triFace{0, 2, 3}, triFace{1, 4, 5}
    });
    const scalar area = 1 + triangles[2].tri(points).mag();
    const label runs = 2000;
    scalar first = 0, xs = 0, number = 0;
    bool exact = true;
    for (label seed = 0; seed < runs; ++seed)
    {
        const counterRandom random(seed, "kind");
        const auto sites = materialPoint::spread
        (
            materialPoint::numbers(13.3, random, points, triangles), random
        );
        exact = exact && mag(sites.size() - 13.3*area) < 1;
        for (const materialPoint& p : sites)
        {
            const point x(p.on(points, triangles));
            if (p.triangle < 2)
            {
                xs += x.x();
                number += 1;
            }
            first += p.triangle == 0;
        }
    }
    c.check("molecules: total number exact to one", exact);
    // rounding 6.65: at most a quarter of variance each
    checkSigma
    (
        c, "molecules: number on a triangle", first/runs, 6.65,
        sqrt(0.65*0.35/runs)
    );
    checkSigma
    (
        c, "molecules: uniform over a square", xs/number, 0.5,
        sqrt(1/12.0/number)
    );

    const materialPoint p = materialPoint::nearest
    (
        2, {5, 2, 3}, points, triangles
    );
    const triPointRef t(triangles[2].tri(points));
    c.checkBelow
    (
        "nearest point of a triangle as a material point",
        mag
        (
            p.on(points, triangles)
          - t.nearestPoint({5, 2, 3}).rawPoint()
        ), 1e-14
    );
}

} // End namespace fsbi
} // End namespace Foam
