/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelOut.H"

namespace Foam
{
namespace fsbi
{

static const label mostPasses = 20;

//- One pass: what every cell gets from those beside it, less what it gives
static scalarField transfers
(
    const meshStencil& stencil, const scalarField& amounts
)
{
    const label n = amounts.size();
    const labelList& owner = stencil.owner();
    const labelList& neighbour = stencil.neighbour();
    scalarField has(n + stencil.halo().size(), Zero);
    forAll(amounts, celli)
    {
        has[celli] = max(amounts[celli], scalar(0));
    }
    stencil.halo().fill(has.data(), 1);
    scalarField around(n, Zero);
    forAll(owner, i)
    {
        around[owner[i]] += has[neighbour[i]];
        if (neighbour[i] < n)
        {
            around[neighbour[i]] += has[owner[i]];
        }
    }
    // part of what its neighbours have that a cell asks for
    scalarField asks(has.size(), Zero);
    forAll(amounts, celli)
    {
        if (amounts[celli] < 0 && around[celli] > 0)
        {
            asks[celli] = min(-amounts[celli]/around[celli], scalar(1));
        }
    }
    stencil.halo().fill(asks.data(), 1);
    scalarField asked(n, Zero);
    forAll(owner, i)
    {
        asked[owner[i]] += asks[neighbour[i]];
        if (neighbour[i] < n)
        {
            asked[neighbour[i]] += asks[owner[i]];
        }
    }
    scalarField gives(has.size(), Zero);
    forAll(asked, celli)
    {
        gives[celli] = has[celli]/max(asked[celli], scalar(1));
    }
    stencil.halo().fill(gives.data(), 1);
    scalarField change(n, Zero);
    forAll(owner, i)
    {
        const label P = owner[i], N = neighbour[i];
        const scalar toP = asks[P]*gives[N] - asks[N]*gives[P];
        change[P] += toP;
        if (N < n)
        {
            change[N] -= toP;
        }
    }
    return change;
}


//- What is negative still is taken from all
static scalar takeFromAll(scalarField& amounts)
{
    scalar lack = 0, rest = 0;
    for (scalar& amount : amounts)
    {
        lack -= min(amount, scalar(0));
        amount = max(amount, scalar(0));
        rest += amount;
    }
    reduce(lack, sumOp<scalar>());
    reduce(rest, sumOp<scalar>());
    amounts *= rest > lack ? (rest - lack)/rest : 0;
    return lack;
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::levelOut
(
    const meshStencil& stencil, scalarField& amounts
)
{
    scalar moved = 0;
    for (label pass = 0; pass < mostPasses && gMin(amounts) < 0; ++pass)
    {
        const scalarField change(transfers(stencil, amounts));
        amounts += change;
        moved += 0.5*gSumMag(change);
    }
    return gMin(amounts) < 0 ? moved + takeFromAll(amounts) : moved;
}
