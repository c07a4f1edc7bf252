/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polylogarithm.H"
#include "mathematicalConstants.H"

#include <cmath>

using Foam::constant::mathematical::pi;

Foam::fsbi::polylogarithm::polylogarithm()
:
    zeta_(32)
{
    zeta_[0] = -0.5;
    for (label j = 1; j < zeta_.size(); ++j)
    {
        zeta_[j] = std::riemann_zeta(2.0*j);
    }
}


std::complex<Foam::scalar> Foam::fsbi::polylogarithm::operator()
(
    const label s, complexNumber mu
) const
{
    if (mu.real() < -1.5)
    {
        complexNumber sum(0), power(1);
        for (label n = 1; n < 26; ++n)
        {
            power *= std::exp(mu);
            sum += power/std::pow(scalar(n), s);
        }
        return sum;
    }

    mu.imag(std::remainder(mu.imag(), 2*pi));
    if (mu == complexNumber(0))
    {
        return std::riemann_zeta(scalar(s));
    }
    const complexNumber head
    (
        s == 2
      ? zeta_[1] + mu*(1.0 - std::log(-mu))
      : std::riemann_zeta(3.0) + zeta_[1]*mu
      + 0.5*mu*mu*(1.5 - std::log(-mu))
    );
    // of the negative arguments of zeta only the odd ones count:
    // zeta(1 - 2j) = 2 (-1)^j (2j - 1)! zeta(2j)/(2 pi)^2j
    const complexNumber lead(s == 2 ? mu : mu*mu), r2(mu*mu/(4*sqr(pi)));
    complexNumber sum(zeta_[0]*(s == 2 ? mu/2.0 : mu/6.0)), power(1);
    for (label j = 1; j < zeta_.size(); ++j)
    {
        power *= -r2;
        sum += 2*zeta_[j]*power
           /scalar(2*j*(2*j + 1)*(s == 2 ? 1 : 2*j + 2));
    }
    return head + lead*sum;
}
