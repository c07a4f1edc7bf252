/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Fornberg.H"
#include "addToRunTimeSelectionTable.H"
#include "scalarMatrices.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Fornberg, 0);
    addToRunTimeSelectionTable(motionScheme, Fornberg, entry);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::Fornberg::Fornberg(ITstream& entry)
:
    order_(0)
{
    const string usage("Fornberg <order 1, 2, 3 or 4>");
    const scalar order = numbers(entry, {1}, usage)[0];
    for (label i = 1; i <= 4; ++i)
    {
        if (order == i)
        {
            order_ = i;
        }
    }
    if (!order_)
    {
        FatalIOErrorInFunction(entry)
            << "A time scheme of order " << order << ": it is written as  "
            << usage.c_str() << exit(FatalIOError);
    }
}


Foam::fsbi::Fornberg::Fornberg(const label order)
:
    order_(order)
{}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

// d^derivative(x^k)/dx^derivative, for k not below the derivative
Foam::scalar powerDerivative
(
    const Foam::scalar x, const Foam::label k, const Foam::label derivative
)
{
    Foam::scalar value = 1;
    for (Foam::label m = 0; m < k; ++m)
    {
        value *= m < derivative ? k - m : x;
    }
    return value;
}

}


// * * * * * * * * * * * * * * * * Weights * * * * * * * * * * * * * * * * * //

Foam::scalarList Foam::fsbi::Fornberg::fornbergWeights
(
    const scalar x0, const scalarList& nodes, const label derivative
)
{
    // w(j, k): weight of node j in derivative k, with the nodes up to i
    scalarRectangularMatrix w(nodes.size(), derivative + 1, Zero);
    w(0, 0) = 1;
    scalar oldProduct = 1;
    for (label i = 1; i < nodes.size(); ++i)
    {
        const scalar distance = nodes[i] - x0;
        const scalar oldDistance = nodes[i - 1] - x0;
        scalar product = 1;
        for (label j = 0; j < i; ++j)
        {
            product *= nodes[i] - nodes[j];
        }
        for (label k = min(i, derivative); k >= 0; --k)
        {
            const scalar below = k ? k*w(i - 1, k - 1) : 0;
            w(i, k) = oldProduct/product*(below - oldDistance*w(i - 1, k));
            for (label j = 0; j < i; ++j)
            {
                w(j, k) = (distance*w(j, k) - (k ? k*w(j, k - 1) : 0))
                    /(nodes[i] - nodes[j]);
            }
        }
        oldProduct = product;
    }

    scalarList weights(nodes.size());
    forAll(weights, j)
    {
        weights[j] = w(j, derivative);
    }
    return weights;
}


Foam::scalarList Foam::fsbi::Fornberg::HermiteWeights
(
    const scalar x0, const scalarList& nodes, const labelList& given,
    const label derivative
)
{
    const label n = nodes.size();
    scalar scale = 0;
    for (const scalar x : nodes)
    {
        scale = max(scale, mag(x - x0));
    }

    // exact for the powers k of (x - x0)/scale
    scalarSquareMatrix equations(n, Zero);
    forAll(nodes, j)
    {
        for (label k = given[j]; k < n; ++k)
        {
            equations(k, j) =
                powerDerivative((nodes[j] - x0)/scale, k, given[j]);
        }
    }
    scalarField wanted(n, Zero);
    wanted[derivative] = powerDerivative(0, derivative, derivative);
    scalarField weights(n);
    Foam::solve(weights, equations, wanted);
    forAll(weights, j)
    {
        weights[j] *= Foam::pow(scale, given[j] - derivative);
    }
    return scalarList(weights);
}


Foam::scalarList Foam::fsbi::Fornberg::weights
(
    const scalar dt, const label derivative
) const
{
    // counted from the end of the step
    scalarList nodes(history_.size() + 1, Zero);
    labelList given(nodes.size(), Zero);
    for (label i = 1; i < nodes.size(); ++i)
    {
        nodes[i] = -(history_[i - 1].age + dt);
        given[i] = history_[i - 1].derivative;
    }
    return
        max(given) > 0
      ? HermiteWeights(0, nodes, given, derivative)
      : fornbergWeights(0, nodes, derivative);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::Fornberg::combine
(
    const scalarList& weights, scalar& coeff, vectorField& known
) const
{
    coeff = weights[0];
    known = weights[1]*history_[0].value;
    for (label i = 2; i < weights.size(); ++i)
    {
        known += weights[i]*history_[i - 1].value;
    }
}


void Foam::fsbi::Fornberg::start
(
    const vectorField& u0, const vectorField& v0, const vectorField& a0
)
{
    history_ = {{0, 0, u0}, {0, 1, v0}};
    if (order_ > 2)
    {
        history_.push_back({0, 2, a0});
    }
}


void Foam::fsbi::Fornberg::start(const vectorField& u0)
{
    history_ = {{0, 0, u0}};
}


void Foam::fsbi::Fornberg::prepare(const scalar dt)
{
    combine(weights(dt, 2), accelerationCoeff_, knownAcceleration_);
    combine(weights(dt, 1), velocityCoeff_, knownVelocity_);
}


void Foam::fsbi::Fornberg::accept
(
    const scalar dt, const vectorField& u, const vectorField&
)
{
    for (datum& d : history_)
    {
        d.age += dt;
    }
    history_.insert(history_.begin(), {0, 0, u});
    if (history_.size() > std::size_t(order_ + 1))
    {
        history_.pop_back();
    }
}


Foam::scalar Foam::fsbi::Fornberg::stepLimit() const
{
    // measured: growth by 1 % in a period
    return order_ == 3 ? 0.158 : order_ == 4 ? 0.292 : GREAT;
}


void Foam::fsbi::Fornberg::fields(const visitor& visit)
{
    for (std::size_t i = 0; i < history_.size(); ++i)
    {
        visit("history" + Foam::name(label(i)), history_[i].value);
    }
}


void Foam::fsbi::Fornberg::save(dictionary& state) const
{
    motionScheme::save(state);
    scalarList ages;
    labelList derivatives;
    for (const datum& d : history_)
    {
        ages.append(d.age);
        derivatives.append(d.derivative);
    }
    state.set("order", order_);
    state.set("ages", ages);
    state.set("derivatives", derivatives);
}


void Foam::fsbi::Fornberg::restore(const dictionary& state)
{
    motionScheme::restore(state);
    if (state.get<label>("order") != order_)
    {
        FatalIOErrorInFunction(state)
            << "The run was saved with Fornberg " << state.get<label>("order")
            << " and cannot continue with order " << order_
            << exit(FatalIOError);
    }
    const scalarList ages(state.get<scalarList>("ages"));
    const labelList derivatives(state.get<labelList>("derivatives"));
    history_.clear();
    forAll(ages, i)
    {
        history_.push_back({ages[i], derivatives[i], vectorField()});
    }
}
