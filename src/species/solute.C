/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solute.H"
#include "fluidRegion.H"
#include "levelOut.H"

namespace Foam
{
namespace fsbi
{

//- Part by which the highest concentration may be passed: digits
static const scalar concentrationDigits = 1e-14;

//- Level amounts out to concentrations from 0 to the highest; the amount moved
static scalar level
(
    const meshStencil& stencil, const scalar highest, scalarField& amounts
)
{
    const scalar moved = levelOut(stencil, amounts);
    const scalarField most(highest*stencil.mesh().cellVolumes());
    if (gMin(scalarField(most - amounts)) >= 0)
    {
        return moved;
    }
    scalarField room(most - amounts);
    const scalar down = levelOut(stencil, room);
    amounts = most - room;
    return moved + down;
}

//- Solutions for what is bound at the end of a step, and part of the sites that
//  may be missing
static const label mostGuesses = 40;
static const scalar sameBound = 1e-8;

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::solute::highest() const
{
    scalar c = gMax(now_.c);
    for (const soluteSurface& surface : surfaces_)
    {
        c = surface.raises() ? GREAT : max(c, surface.inflowing());
    }
    return (1 + concentrationDigits)*c;
}


Foam::fsbi::boundaryLaw Foam::fsbi::solute::flowing
(
    const relativeFlux& flux
) const
{
    boundaryLaw law(flux.boundary().size());
    forAll(flux.boundary(), i)
    {
        law.kinds[i] =
            flux.boundary()[i] ? boundaryLaw::open : boundaryLaw::closed;
    }
    for (const soluteSurface& surface : surfaces_)
    {
        const labelPair range(surface.faces(fluid_.mesh()));
        for (label i = range.first(); i < range.first() + range.second(); ++i)
        {
            law.value[i] = surface.inflowing();
        }
    }
    return law;
}


Foam::fsbi::boundaryLaw Foam::fsbi::solute::law
(
    const relativeFlux& flux,
    const scalar dt,
    const UList<scalar>& atWall
) const
{
    boundaryLaw law(flowing(flux));
    forAll(surfaces_, s)
    {
        const labelPair range(surfaces_[s].faces(fluid_.mesh()));
        scalar area = 0;
        for (label i = range.first(); i < range.first() + range.second(); ++i)
        {
            area += mag
            (
                fluid_.mesh().faceAreas()[fluid_.mesh().nInternalFaces() + i]
            );
        }
        reduce(area, sumOp<scalar>());
        surfaces_[s].set
        (
            range.first(), range.second(), dt, area, now_.surfaces[s],
            bound_.densities(), atWall, law
        );
    }
    return law;
}


Foam::fsbi::solute::uptake Foam::fsbi::solute::taken
(
    const soluteSurface& surface, const soluteTransport& solution
) const
{
    const labelPair range(surface.faces(fluid_.mesh()));
    scalarList sums(3, Zero);
    for (label i = range.first(); i < range.first() + range.second(); ++i)
    {
        const scalar S = mag
        (
            fluid_.mesh().faceAreas()[fluid_.mesh().nInternalFaces() + i]
        );
        sums[0] += S;
        sums[1] += solution.through()[i];
        sums[2] += S*solution.atWall()[i];
    }
    reduce(sums, sumOp<scalarList>());
    return {sums[0], sums[1], sums[2]/max(sums[0], VSMALL)};
}


Foam::fsbi::outcome Foam::fsbi::solute::solve
(
    const relativeFlux& flux, const scalar dt, soluteTransport& transport
)
{
    next_ = now_;
    // where diffusion is faster than binding, that will nearly do
    scalarField atWall(transport.atWall().size());
    forAll(atWall, i)
    {
        atWall[i] = now_.c
        [
            fluid_.mesh().faceOwner()[fluid_.mesh().nInternalFaces() + i]
        ];
    }
    for (label k = 0; k < mostGuesses; ++k)
    {
        const boundaryLaw laws(law(flux, dt, atWall));
        const outcome solved
        (
            transport.solve(laws, tolerance_, k == 0, next_.c)
        );
        if (!solved || bound_.missing(transport, dt) <= sameBound)
        {
            return solved;
        }
        atWall = max(transport.atWall(), scalar(0));
    }
    return outcome::failed
    (
        "what is bound at surfaces by species '" + name_ + "' is not found in "
      + Foam::name(mostGuesses) + " guesses"
    );
}


void Foam::fsbi::solute::account
(
    const relativeFlux& flux,
    const scalar dt,
    const soluteTransport& solution
)
{
    bound_.advance(solution, dt);
    const scalarField& through = solution.through();
    scalar all = 0;
    forAll(through, i)
    {
        all += through[i];
    }
    reduce(all, sumOp<scalar>());
    scalar ofSurfaces = 0;
    forAll(surfaces_, s)
    {
        const uptake u(taken(surfaces_[s], solution));
        next_.surfaces[s] = surfaces_[s].after
        (
            now_.surfaces[s], dt, dt*u.rate, u.wall
        );
        if (surfaces_[s].binds())
        {
            next_.surfaces[s].held = bound_.mean(surfaces_[s]);
        }
        if (!surfaces_[s].isInflow())
        {
            ofSurfaces += u.rate;
            next_.released += dt*max(-u.rate, scalar(0));
            next_.takenUp += dt*max(u.rate, scalar(0));
        }
    }
    next_.entered -= dt*(all - ofSurfaces);
}


void Foam::fsbi::solute::follow
(
    const meshStencil& stencil,
    const relativeFlux& flux,
    const scalarField& volumes
)
{
    soluteTransport transport
    (
        stencil, flux, 0, 0, 1, scalarField(volumes*now_.c)
    );
    // whatever is left of the equations: amounts are those of the fluxes
    transport.solve(flowing(flux), tolerance_, true, now_.c);
    scalar out = 0;
    for (const scalar through : transport.through())
    {
        out += through;
    }
    now_.entered -= returnReduce(out, sumOp<scalar>());
    scalar decayed = 0;
    scalarField amounts(transport.amounts(decayed));
    now_.moved += level(stencil, highest(), amounts);
    now_.c = amounts/fluid_.mesh().cellVolumes();
}


Foam::fsbi::outcome Foam::fsbi::solute::advance
(
    const meshStencil& stencil,
    const relativeFlux& flux,
    const scalarField& volumes,
    const scalar dt
)
{
    soluteTransport transport
    (
        stencil, flux, diffusivity_, decay_, dt, scalarField(volumes*now_.c)
    );
    const outcome solved(solve(flux, dt, transport));
    if (!solved)
    {
        return solved;
    }
    account(flux, dt, transport);
    next_.residual = transport.left();
    scalar decayed = 0;
    scalarField amounts(transport.amounts(decayed));
    next_.decayed += decayed;
    next_.moved += level(stencil, highest(), amounts);
    next_.c = amounts/fluid_.mesh().cellVolumes();
    return outcome();
}


Foam::scalar Foam::fsbi::solute::amount() const
{
    return gSum(scalarField(fluid_.mesh().cellVolumes()*now_.c));
}


void Foam::fsbi::solute::accept()
{
    now_ = next_;
    bound_.accept();
}


void Foam::fsbi::solute::set(scalarField&& c, const scalar displaced)
{
    now_.c = std::move(c);
    now_.displaced += displaced;
}


Foam::scalar Foam::fsbi::solute::imbalance() const
{
    const scalar there = amount();
    const scalar wanted =
        now_.began + now_.released - now_.takenUp + now_.entered - now_.decayed
      + now_.displaced;
    const scalar scale = max
    (
        mag(there), mag(now_.began) + now_.released + mag(now_.entered)
    );
    return (there - wanted)/max(scale, VSMALL);
}
