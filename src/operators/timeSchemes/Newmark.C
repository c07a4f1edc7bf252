/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Newmark.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(Newmark, 0);
    addToRunTimeSelectionTable(motionScheme, Newmark, entry);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::Newmark::Newmark(const scalar beta, const scalar gamma)
:
    beta_(beta),
    gamma_(gamma)
{}


Foam::fsbi::Newmark::Newmark(ITstream& entry)
:
    Newmark(0.25, 0.5)
{
    const scalarList given(numbers(entry, {0, 2}, "Newmark [<beta> <gamma>]"));
    if (given.size())
    {
        beta_ = given[0];
        gamma_ = given[1];
    }
    if (!(beta_ > 0) || !(gamma_ >= 0.5))
    {
        FatalIOErrorInFunction(entry)
            << "Newmark needs beta above 0 and gamma of 0.5 or more, below "
            << "that it is unstable, not " << beta_ << " and " << gamma_
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::Newmark::start
(
    const vectorField& u0, const vectorField& v0, const vectorField& a0
)
{
    u_ = u0;
    v_ = v0;
    a_ = a0;
}


void Foam::fsbi::Newmark::prepare
(
    const scalar dt, const scalar beta, const scalar gamma
)
{
    const scalar oldA = oldAcceleration();
    const scalar c = 1/(beta*dt*dt);

    // of the acceleration at the end of the step
    const vectorField known((1 - 0.5/beta)*a_ - c*(u_ + dt*v_));

    accelerationCoeff_ = (1 - oldA)*c;
    knownAcceleration_ = (1 - oldA)*known + oldA*a_;
    velocityCoeff_ = gamma*dt*c;
    knownVelocity_ = v_ + dt*((1 - gamma)*a_ + gamma*known);
}


void Foam::fsbi::Newmark::prepare(const scalar dt)
{
    prepare(dt, beta_, gamma_);
}


void Foam::fsbi::Newmark::accept
(
    const scalar, const vectorField& u, const vectorField&
)
{
    const scalar oldA = oldAcceleration();
    a_ = (accelerationCoeff_*u + knownAcceleration_ - oldA*a_)/(1 - oldA);
    v_ = velocity(u);
    u_ = u;
}


Foam::scalar Foam::fsbi::Newmark::stepLimit() const
{
    const scalar lack = 0.5*gamma_ - beta_;
    return lack > 0 ? 1/Foam::sqrt(lack) : GREAT;
}


void Foam::fsbi::Newmark::fields(const visitor& visit)
{
    visit("displacement", u_);
    visit("velocity", v_);
    visit("acceleration", a_);
}
