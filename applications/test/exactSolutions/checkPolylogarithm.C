/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactChecks.H"
#include "polylogarithm.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace fsbi
{

void checkPolylogarithm(checks& c)
{
    typedef std::complex<scalar> number;
    using constant::mathematical::pi;
    const polylogarithm Li;
    const scalar ln2 = Foam::log(2.0), zeta3 = 1.2020569031595942;
    const auto both = [&](const number& mu, const number& Li2, const number& Li3)
    {
        return max(std::abs(Li(2, mu) - Li2), std::abs(Li(3, mu) - Li3));
    };
    c.checkBelow
    (
        "Li(1), Li(-1)",
        max
        (
            both(0, sqr(pi)/6, zeta3),
            both(number(0, 3*pi), -sqr(pi)/12, -0.75*zeta3)
        ), 4e-15
    );
    c.checkBelow
    (
        "Li(1/2)",
        both
        (
            -ln2, sqr(pi)/12 - sqr(ln2)/2,
            7*zeta3/8 - sqr(pi)*ln2/12 + pow3(ln2)/6
        ), 4e-15
    );
    c.checkBelow
    (
        "Li(i)",
        both
        (
            number(0, pi/2), number(-sqr(pi)/48, 0.915965594177219015),
            number(-3*zeta3/32, pow3(pi)/32)
        ), 4e-15
    );
    scalar worst = 0;
    for (const number mu : {number(-1.49, 3.1), number(-1.51, 3.1)})
    {
        number Li2(0), Li3(0);
        for (scalar n = 1; n < 100; ++n)
        {
            Li2 += std::exp(n*mu)/sqr(n);
            Li3 += std::exp(n*mu)/pow3(n);
        }
        worst = max(worst, both(mu, Li2, Li3));
    }
    c.checkBelow("Li where the two ways of summing meet", worst, 4e-15);
}

} // End namespace fsbi
} // End namespace Foam
