/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wedgeModes.H"
#include "mathematicalConstants.H"
#include <functional>

namespace Foam
{
namespace fsbi
{

//- Least root between two numbers, to round-off; the upper one if there is none
static scalar firstRoot
(
    const std::function<scalar(scalar)>& f, const scalar from, const scalar to
)
{
    static const label nSteps = 200;
    const scalar step = (to - from)/nSteps;
    scalar a = from;
    while (a + step/2 < to && f(a)*f(a + step) > 0)
    {
        a += step;
    }
    scalar b = min(a + step, to);
    for (label i = 0; i < 60; ++i)
    {
        const scalar middle = (a + b)/2;
        (f(a)*f(middle) > 0 ? a : b) = middle;
    }
    return b;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::wedgeModes::wedgeModes(const scalar angle)
:
    angle_(angle),
    scales_(scalar(1))
{
    const auto symmetric = [=](const scalar l)
    {
        return Foam::sin(l*angle) + l*Foam::sin(angle);
    };
    // the uniform turn, l = 1, is taken off
    const auto antisymmetric = [=](const scalar l)
    {
        const scalar d = l - 1;
        return
            mag(d) < 1e-6
          ? angle*Foam::cos(angle) - Foam::sin(angle)
          : (Foam::sin(l*angle) - l*Foam::sin(angle))/d;
    };
    exponents_ =
    {
        firstRoot(symmetric, 0.5, 1),
        firstRoot(antisymmetric, 0.5, 2),
        constant::mathematical::pi/angle
    };
    for (label k = 0; k < 2; ++k)
    {
        scalar largest = 0;
        for (label i = -8; i <= 8; ++i)
        {
            flow value;
            setInPlane(k, 1, i*angle/16, value);
            largest = max(largest, mag(value.u));
        }
        scales_[k] = largest;
    }
}


void Foam::fsbi::wedgeModes::setInPlane
(
    const label k, const scalar r, const scalar theta, flow& result
) const
{
    const scalar l = exponents_[k], q = l - 1;
    const scalar halfSum = (l + 1)*angle_/2, halfDifference = q*angle_/2;
    const scalar cosSum = Foam::cos((l + 1)*theta), cosDiff = Foam::cos(q*theta);
    const scalar sinSum = Foam::sin((l + 1)*theta), sinDiff = Foam::sin(q*theta);
    scalar A, B, f, df, ddf, p;
    if (k == 0)
    {
        A = Foam::cos(halfDifference);
        B = -Foam::cos(halfSum);
        f = A*cosSum + B*cosDiff;
        df = -A*(l + 1)*sinSum - B*q*sinDiff;
        ddf = -A*sqr(l + 1)*cosSum - B*sqr(q)*cosDiff;
        p = -4*l*B*sinDiff;
    }
    else
    {
        A = Foam::sin(halfDifference);
        B = -Foam::sin(halfSum);
        f = A*sinSum + B*sinDiff;
        df = A*(l + 1)*cosSum + B*q*cosDiff;
        ddf = -A*sqr(l + 1)*sinSum - B*sqr(q)*sinDiff;
        p = 4*l*B*cosDiff;
    }
    const vector e(Foam::cos(theta), Foam::sin(theta), 0);
    const vector t(-e.y(), e.x(), 0);
    const scalar slope = Foam::pow(r, q)/scales_[k], value = r*slope;
    result.u = value*(df*e - (l + 1)*f*t);
    result.p = slope*p;
    result.gradient =
        slope
       *(
            l*df*(e*e) - l*(l + 1)*f*(e*t)
          + (ddf + (l + 1)*f)*(t*e) - l*df*(t*t)
        );
}


Foam::FixedList<Foam::fsbi::wedgeModes::flow, Foam::fsbi::wedgeModes::n>
Foam::fsbi::wedgeModes::at(const point& x) const
{
    const scalar r = max(Foam::sqrt(sqr(x.x()) + sqr(x.y())), 1e-12);
    const scalar theta = std::atan2(x.y(), x.x());
    FixedList<flow, n> result;
    setInPlane(0, r, theta, result[0]);
    setInPlane(1, r, theta, result[1]);

    const scalar m = exponents_[2], slope = Foam::pow(r, m - 1);
    result[2].u = vector(0, 0, r*slope*Foam::cos(m*theta));
    result[2].p = 0;
    result[2].gradient = Zero;
    result[2].gradient.xz() = m*slope*Foam::cos((m - 1)*theta);
    result[2].gradient.yz() = -m*slope*Foam::sin((m - 1)*theta);
    return result;
}
