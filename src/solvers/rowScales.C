/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowScales.H"
#include "mathematicalConstants.H"

Foam::fsbi::rowScales::rowScales
(
    const momentumEquation& momentum,
    const UList<bodyRows>& bodies,
    const UList<elasticRows*>& elastic
)
:
    momentum_(momentum.viscous().diagonal().size()),
    continuity_(momentum_.size()),
    bodies_(bodies.size()),
    resistance_(bodies.size())
{
    const stokesOperator& stokes = momentum.viscous();
    const scalarField& V = stokes.stencil().mesh().cellVolumes();
    forAll(V, i)
    {
        momentum_[i] = 1/stokes.diagonal()[i];
        continuity_[i] = 1/cbrt(sqr(V[i]));
    }
    forAll(momentum.massRate(), i)
    {
        momentum_[i] = 1/(stokes.diagonal()[i] + momentum.massRate()[i]);
    }
    const scalar pi = constant::mathematical::pi;
    forAll(bodies, b)
    {
        const bodyRows& body = bodies[b];
        const scalar a = body.radius;
        // a sphere in unsteady Stokes flow, l the radius over the depth that
        // momentum reaches in a step
        const scalar l = a*Foam::sqrt(momentum.densityRate()/stokes.mu());
        const scalar drag =
            6*pi*stokes.mu()*a*(1 + l + sqr(l)/9) + body.massRate;
        const scalar spin =
            8*pi*stokes.mu()*pow3(a)*(1 + sqr(l)/(3 + 3*l))
          + tr(body.inertiaRate)/3;
        for (label k = 0; k < 6; ++k)
        {
            resistance_[b][k] = body.free[k] ? (k < 3 ? drag : spin) : 1;
            bodies_[b][k] = (k < 3 ? 1 : a)/resistance_[b][k];
        }
    }
    for (const elasticRows* body : elastic)
    {
        for (const scalar s : body->elastic->rowScale(body->mass))
        {
            elastic_.append(s*body->velocityCoeff);
        }
    }
}


void Foam::fsbi::rowScales::apply(scalar* r) const
{
    forAll(momentum_, i)
    {
        r[4*i] *= momentum_[i];
        r[4*i + 1] *= momentum_[i];
        r[4*i + 2] *= momentum_[i];
        r[4*i + 3] *= continuity_[i];
    }
    forAll(elastic_, i)
    {
        r[4*momentum_.size() + i] *= elastic_[i];
    }
}


void Foam::fsbi::rowScales::undo(const scalar* scaled, scalar* r) const
{
    forAll(momentum_, i)
    {
        r[4*i] = scaled[4*i]/momentum_[i];
        r[4*i + 1] = scaled[4*i + 1]/momentum_[i];
        r[4*i + 2] = scaled[4*i + 2]/momentum_[i];
        r[4*i + 3] = scaled[4*i + 3]/continuity_[i];
    }
    const label n = 4*momentum_.size();
    forAll(elastic_, i)
    {
        r[n + i] = scaled[n + i]/elastic_[i];
    }
}
