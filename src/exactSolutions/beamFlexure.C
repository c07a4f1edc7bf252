/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "beamFlexure.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(beamFlexure, 0);
    addToRunTimeSelectionTable(exactSolution, beamFlexure, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::beamFlexure::beamFlexure
(
    const checkedDictionary& entries, const dictionary& material
)
:
    exactSolution(entries, material),
    a_(entries.positive("width")/2),
    b_(entries.positive("height")/2),
    length_(entries.positive("length")),
    force_(entries, "force")
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsbi::beamFlexure::inside(const point& X) const
{
    const vector x(local(X));
    // meshes are written with some ten digits
    const scalar margin = 1e-6*(a_ + b_ + length_);
    if
    (
        mag(x.x()) > a_ + margin || mag(x.y()) > b_ + margin
     || x.z() < -margin || x.z() > length_ + margin
    )
    {
        FatalErrorInFunction
            << "Point " << X << " lies outside the bar of beamFlexure, which is"
            << " |x| < " << a_ << ", |y| < " << b_ << ", 0 < z < " << length_
            << " about its origin" << exit(FatalError);
    }
    return x;
}


Foam::scalar Foam::fsbi::beamFlexure::load(const scalar time) const
{
    return force_.value(time)/(4*a_*pow3(b_)/3);
}


Foam::vector Foam::fsbi::beamFlexure::sums(const vector& x) const
{
    const scalar xi = pi*x.x()/a_, eta = pi*mag(x.y())/a_, beta = pi*b_/a_;
    const scalar s = max(beta - eta, scalar(0));

    // sinh(n eta)/cosh(n beta) = e^-ns (1 - q), where e^-ns gives the
    // polylogarithms, and e^-ns q < 2 e^(-n beta) dies out fast; so does cosh
    const std::complex<scalar> mu(-s, xi + pi);
    const std::complex<scalar> Li2(polylogarithm_(2, mu));
    vector sum(Li2.imag(), Li2.real(), polylogarithm_(3, mu).real());
    scalar sign = -1;
    for (scalar n = 1; n*beta < 40; ++n, sign = -sign)
    {
        const scalar rest = sign*Foam::exp(-n*s)/(1 + Foam::exp(-2*n*beta));
        const scalar plus = Foam::exp(-2*n*eta) + Foam::exp(-2*n*beta);
        const scalar minus = Foam::exp(-2*n*eta) - Foam::exp(-2*n*beta);
        sum.x() -= rest*plus*Foam::sin(n*xi)/sqr(n);
        sum.y() += rest*minus*Foam::cos(n*xi)/sqr(n);
        sum.z() -= rest*plus*Foam::cos(n*xi)/pow3(n);
    }
    const scalar side = x.y() < 0 ? -1 : 1;
    return vector(side*sum.x(), sum.y(), side*sum.z());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsbi::beamFlexure::displacement
(
    const point& X, const scalar time
) const
{
    const vector r(inside(X));
    const scalar x = r.x(), y = r.y(), z = r.z();
    const scalar E = law().E(), nu = law().nu(), G = law().mu();
    const scalar warp =
        (sqr(b_)*y - pow3(y)/3)/(2*G)
      + nu/(6*(1 + nu)*G)
       *(
            (3*sqr(x) - sqr(a_))*y
          - 12*pow3(a_)/pow3(pi)*sums(r).z()
        )
      + nu/(2*E)*(pow3(y)/3 - sqr(x)*y);
    return load(time)*vector
    (
        nu/E*(length_ - z)*x*y,
        nu/(2*E)*(length_ - z)*(sqr(y) - sqr(x))
      + (length_/2 - z/6)*sqr(z)/E,
        -(length_ - z/2)*z*y/E + warp
    );
}


Foam::tensor Foam::fsbi::beamFlexure::stress
(
    const point& X, const scalar time
) const
{
    const vector x(inside(X));
    const scalar nu = law().nu();
    const vector sum(sums(x));
    const scalar xz = 2*nu*sqr(a_)/(sqr(pi)*(1 + nu))*sum.x();
    const scalar yz =
        (sqr(b_) - sqr(x.y()))/2
      + nu/(6*(1 + nu))
       *(3*sqr(x.x()) - sqr(a_) - 12*sqr(a_)/sqr(pi)*sum.y());
    const scalar zz = -(length_ - x.z())*x.y();
    return load(time)*tensor(0, 0, xz, 0, 0, yz, xz, yz, zz);
}


Foam::vector Foam::fsbi::beamFlexure::bodyForce
(
    const point&, const scalar
) const
{
    return Zero;
}
