/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "steadyState.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(steadyState, 0);
    addToRunTimeSelectionTable(motionScheme, steadyState, entry);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::steadyState::steadyState(ITstream& entry)
{
    numbers(entry, {0}, "steadyState");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::steadyState::start
(
    const vectorField& u0, const vectorField&, const vectorField&
)
{
    u_ = u0;
}


void Foam::fsbi::steadyState::prepare(const scalar)
{
    knownAcceleration_.resize(u_.size());
    knownAcceleration_ = Zero;
    knownVelocity_ = knownAcceleration_;
}


void Foam::fsbi::steadyState::accept
(
    const scalar, const vectorField& u, const vectorField&
)
{
    u_ = u;
}


void Foam::fsbi::steadyState::fields(const visitor& visit)
{
    visit("displacement", u_);
}
