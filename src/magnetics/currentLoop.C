/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "currentLoop.H"
#include "dipole.H"

#include <cmath>

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace fsbi
{

//- Below this w, series; with so many terms their rest is below round-off
static const scalar nearAxis = 0.05;
static const label nTerms = 16;

//- Gauss's hypergeometric series
static scalar hypergeometric
(
    const scalar a, const scalar b, const scalar c, const scalar w
)
{
    scalar term = 1, sum = 1;
    for (label n = 0; n < nTerms; ++n)
    {
        term *= (a + n)*(b + n)/((c + n)*(1 + n))*w;
        sum += term;
    }
    return sum;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::currentLoop::integrals Foam::fsbi::currentLoop::at(const scalar w)
{
    integrals i;
    if (w < nearAxis)
    {
        i.f = pi*hypergeometric(0.75, 1.25, 1, w);
        i.h = 0.75*pi*hypergeometric(1.25, 1.75, 2, w);
        i.dh = 0.75*pi*1.25*1.75/2*hypergeometric(2.25, 2.75, 3, w);
    }
    else
    {
        const scalar e = sqrt(w), root = sqrt(1 + e), k = sqrt(2*e)/root;
        i.f = 2*std::comp_ellint_2(k)/((1 - e)*root);
        i.h = (i.f - 2*std::comp_ellint_1(k)/root)/w;
        i.dh = (0.75*i.f - i.h + 1.25*w*i.h)/(w*(1 - w));
    }
    i.df = (3*i.f + i.h)/(4*(1 - w));
    return i;
}


Foam::vector Foam::fsbi::currentLoop::B(const point& x) const
{
    const vector r(x - centre_);
    const scalar z = r & axis_;
    const vector across(r - z*axis_);
    const scalar r2 = magSqr(across), s2 = sqr(radius_) + magSqr(r);
    const scalar s3 = s2*sqrt(s2), s5 = s3*s2;
    const integrals i(at(4*sqr(radius_)*r2/sqr(s2)));
    return
        2*mu0By4Pi*sqr(radius_)
       *((i.f/s3 - 2*r2*i.h/s5)*axis_ + (2*z*i.h/s5)*across);
}


Foam::tensor Foam::fsbi::currentLoop::gradient(const point& x) const
{
    const vector r(x - centre_);
    const scalar z = r & axis_;
    const vector across(r - z*axis_);
    const scalar r2 = magSqr(across), s2 = sqr(radius_) + magSqr(r);
    const scalar s3 = s2*sqrt(s2), s5 = s3*s2, s7 = s5*s2;
    const integrals i(at(4*sqr(radius_)*r2/sqr(s2)));

    // B = mu0 a^2/(2 pi) (P axis + Q across)
    const vector gradW(8*sqr(radius_/s2)*(across - (2*r2/s2)*r));
    const scalar Q = 2*z*i.h/s5;
    const vector gradP
    (
        (i.df/s3 - 2*r2*i.dh/s5)*gradW
      - (3*i.f/s5 - 10*r2*i.h/s7)*r - (4*i.h/s5)*across
    );
    const vector gradQ
    (
        (2*i.h/s5)*axis_ + (2*z*i.dh/s5)*gradW - (10*z*i.h/s7)*r
    );
    return
        2*mu0By4Pi*sqr(radius_)
       *(
            gradP*axis_ + gradQ*across
          + Q*(tensor::I - tensor(sqr(axis_)))
        );
}
