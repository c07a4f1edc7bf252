/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "generalisedAlpha.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(generalisedAlpha, 0);
    addToRunTimeSelectionTable(motionScheme, generalisedAlpha, entry);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::generalisedAlpha::generalisedAlpha(const scalar r)
:
    // alpha_f - alpha_m = (1 - r)/(1 + r)
    Newmark(1/sqr(1 + r), 0.5 + (1 - r)/(1 + r)),
    alphaM_((2*r - 1)/(r + 1)),
    alphaF_(r/(r + 1)),
    first_(true)
{}


Foam::fsbi::generalisedAlpha::generalisedAlpha(ITstream& entry)
:
    generalisedAlpha(rhoInfinity(entry))
{}


Foam::scalar Foam::fsbi::generalisedAlpha::rhoInfinity(ITstream& entry)
{
    const scalarList given
    (
        numbers(entry, {0, 1}, "generalisedAlpha [<rhoInfinity>]")
    );
    const scalar r = given.size() ? given[0] : 0.8;
    if (!(r >= 0 && r <= 1))
    {
        FatalIOErrorInFunction(entry)
            << "rhoInfinity must be between 0 and 1, not " << r
            << exit(FatalIOError);
    }
    return r;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::generalisedAlpha::start
(
    const vectorField& u0, const vectorField& v0, const vectorField& a0
)
{
    Newmark::start(u0, v0, a0);
    R_.resize(u0.size());
    R_ = Zero;
    first_ = true;
}


void Foam::fsbi::generalisedAlpha::prepare(const scalar dt)
{
    if (first_)
    {
        Newmark::prepare(dt, 0.25, 0.5);
    }
    else
    {
        Newmark::prepare(dt);
    }
}


void Foam::fsbi::generalisedAlpha::accept
(
    const scalar dt, const vectorField& u, const vectorField& R
)
{
    Newmark::accept(dt, u, R);
    R_ = R;
    first_ = false;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::generalisedAlpha::weighted
(
    const vectorField& R
) const
{
    const scalar w = oldWeight();
    return (1 - w)*R + w*R_;
}


void Foam::fsbi::generalisedAlpha::fields(const visitor& visit)
{
    Newmark::fields(visit);
    visit("forces", R_);
}


void Foam::fsbi::generalisedAlpha::save(dictionary& state) const
{
    motionScheme::save(state);
    state.set("first", label(first_));
}


void Foam::fsbi::generalisedAlpha::restore(const dictionary& state)
{
    motionScheme::restore(state);
    first_ = state.get<label>("first");
}
