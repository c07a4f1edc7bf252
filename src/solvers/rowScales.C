/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowScales.H"
#include "asVectors.H"
#include "mathematicalConstants.H"

//- Of the sphere of the body's volume. Collective
static Foam::scalar radius(const Foam::fsbi::elasticRows& body)
{
    return cbrt
    (
        0.75*gSum(body.volumes)/Foam::constant::mathematical::pi
    );
}


Foam::fsbi::sphereResistance::sphereResistance
(
    const scalar a, const momentumEquation& momentum
)
{
    const scalar pi = constant::mathematical::pi;
    const scalar mu = momentum.viscous().mu();
    const scalar l = a*Foam::sqrt(momentum.densityRate()/mu);
    drag = 6*pi*mu*a*(1 + l + sqr(l)/9);
    spin = 8*pi*mu*pow3(a)*(1 + sqr(l)/(3 + 3*l));
}


Foam::fsbi::sphereResistance::sphereResistance
(
    const elasticRows& body, const momentumEquation& momentum
)
:
    sphereResistance(radius(body), momentum)
{
    const scalar inertia = gSum(body.mass)/body.velocityCoeff;
    drag += inertia;
    spin += 0.4*sqr(radius(body))*inertia;
}


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
    forAll(bodies, b)
    {
        const bodyRows& body = bodies[b];
        const scalar a = body.radius;
        const sphereResistance sphere(a, momentum);
        const scalar drag = sphere.drag + body.massRate;
        const scalar spin = sphere.spin + tr(body.inertiaRate)/3;
        for (label k = 0; k < 6; ++k)
        {
            resistance_[b][k] = body.free[k] ? (k < 3 ? drag : spin) : 1;
            bodies_[b][k] = (k < 3 ? 1 : a)/resistance_[b][k];
        }
    }
    for (const elasticRows* body : elastic)
    {
        const label start = elastic_.size();
        for (const scalar s : body->elastic->rowScale(body->mass))
        {
            elastic_.append(s*body->velocityCoeff);
        }
        if (!solidBoundary::hold(body->elastic->boundary().kinds()))
        {
            addWhole(*body, momentum, start);
        }
    }
}


void Foam::fsbi::rowScales::addWhole
(
    const elasticRows& body,
    const momentumEquation& momentum,
    const label start
)
{
    scalarField weights(body.centres.size());
    forAll(weights, i)
    {
        weights[i] = 1/elastic_[start + 3*i];
    }
    const scalar sum = gSum(weights);
    whole w;
    w.start = 4*momentum_.size() + start;
    w.arms = body.places();
    w.arms -= gSum(weights*w.arms)/sum;
    const sphereResistance sphere(body, momentum);
    // together, all of its cells weigh as much as the one row of a rigid body
    const scalar n =
        Foam::sqrt(scalar(returnReduce(weights.size(), sumOp<label>())));
    w.drag = n*sphere.drag;
    w.spin = n*sphere.spin;
    w.toForce = 1/(1 + sum/w.drag);
    w.toTorque = inv(tensor(I) + momentOfInertia(weights, w.arms)/w.spin);
    wholes_.append(w);
}


Foam::vectorField Foam::fsbi::rowScales::loads(const scalar* rows) const
{
    vectorField sums(2*wholes_.size(), Zero);
    forAll(wholes_, b)
    {
        const vectorField& arms = wholes_[b].arms;
        const vector* row = asVectors(rows + wholes_[b].start);
        forAll(arms, i)
        {
            sums[2*b] += row[i];
            sums[2*b + 1] += arms[i] ^ row[i];
        }
    }
    if (wholes_.size())
    {
        surfaceSide::sum(sums);
    }
    return sums;
}


void Foam::fsbi::rowScales::addVelocities
(
    const vectorField& loads, const scalar part, scalar* rows
) const
{
    forAll(wholes_, b)
    {
        const whole& w = wholes_[b];
        const vector v(part/w.drag*loads[2*b]);
        const vector omega(part/w.spin*loads[2*b + 1]);
        vector* row = asVectors(rows + w.start);
        forAll(w.arms, i)
        {
            row[i] += v + (omega ^ w.arms[i]);
        }
    }
}


void Foam::fsbi::rowScales::apply(scalar* r) const
{
    const vectorField acting(loads(r));
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
    addVelocities(acting, 1, r);
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
    vectorField acting(loads(r));
    forAll(wholes_, b)
    {
        acting[2*b] *= wholes_[b].toForce;
        acting[2*b + 1] = wholes_[b].toTorque & acting[2*b + 1];
    }
    std::copy_n(scaled + n, elastic_.size(), r + n);
    addVelocities(acting, -1, r);
    forAll(elastic_, i)
    {
        r[n + i] /= elastic_[i];
    }
}
