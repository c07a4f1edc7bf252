/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "species.H"
#include "addToRunTimeSelectionTable.H"
#include "fluidRegion.H"
#include "namedDictionaries.H"
#include "untrapped.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(species, 0);
addToRunTimeSelectionTable(carriedByFlow, species, file);

} // End namespace fsbi
} // End namespace Foam


const Foam::fvMesh& Foam::fsbi::species::mesh() const
{
    return fluid_.mesh();
}


Foam::fsbi::species::species
(
    const fluidRegion& fluid, const dictionary& saved
)
:
    carriedByFlow(fluid)
{
    const namedDictionaries file
    (
        mesh().time(), typeName, "a species is name { diffusivity ...; ... }"
    );
    for (const entry* e : file.entries())
    {
        const word& name = e->keyword();
        solutes_.append
        (
            new solute(fluid_, e->dict(), saved.subOrEmptyDict(name))
        );
    }
    take();
}


Foam::wordList Foam::fsbi::species::names() const
{
    wordList all(solutes_.size());
    forAll(all, i)
    {
        all[i] = solutes_[i].name();
    }
    return all;
}


const Foam::fsbi::occupiedSites& Foam::fsbi::species::occupied
(
    const word& name, const word& surface, const dictionary& where
)
{
    const label i = names().find(name);
    if (i < 0)
    {
        FatalIOErrorInFunction(where)
            << "There is no species '" << name << "' in constant/species; valid are "
            << flatOutput(names()) << exit(FatalIOError);
    }
    return solutes_[i].bound().occupied(surface, where);
}


void Foam::fsbi::species::take()
{
    points_ = mesh().points();
    volumes_ = mesh().cellVolumes();
}


Foam::wordList Foam::fsbi::species::presentBodies() const
{
    DynamicList<word> present;
    for (const word& name : namesOf(fluid_.meshing().bodies()))
    {
        if (mesh().boundaryMesh().findPatchID(name) >= 0)
        {
            present.append(name);
        }
    }
    return wordList(std::move(present));
}


void Foam::fsbi::species::follow()
{
    const bool still = returnReduce
    (
        mesh().points() == points_, andOp<bool>()
    );
    if (still || gMin(mesh().cellVolumes()) <= 0)
    {
        return;
    }
    const meshStencil stencil(mesh());
    const relativeFlux flux(fluid_, stencil, {points_, volumes_, 1}, true);
    for (solute& s : solutes_)
    {
        s.follow(stencil, flux, volumes_);
    }
    take();
}


void Foam::fsbi::species::release()
{
    const untrapped scope;
    follow();
    bodies_ = presentBodies();
    amounts_.setSize(solutes_.size());
    // of a mesh that is turned inside out gradients are none
    autoPtr<meshStencil> stencil;
    if (returnReduce(mesh().points() == points_, andOp<bool>()))
    {
        stencil.reset(new meshStencil(mesh()));
    }
    for (solute& s : solutes_)
    {
        s.bound().release();
    }
    old_.clear();
    for (label first = 0; first < solutes_.size(); first += 3)
    {
        vectorField c(mesh().nCells(), Zero);
        tensorField gradient(mesh().nCells(), Zero);
        for (label i = first; i < min(first + 3, solutes_.size()); ++i)
        {
            const scalarField& mine = solutes_[i].concentration();
            amounts_[i] = gSum(scalarField(volumes_*mine));
            c.replace(i - first, mine);
            if (stencil)
            {
                const vectorField g(limitedGradient(stencil(), mine));
                for (direction d = 0; d < 3; ++d)
                {
                    gradient.replace(3*d + i - first, g.component(d));
                }
            }
        }
        old_.append(new meshOverlap(mesh(), points_, c, gradient));
    }
}


void Foam::fsbi::species::renew()
{
    const untrapped scope;
    take();
    const bool same = presentBodies() == bodies_;
    forAll(old_, k)
    {
        vectorField c(mesh().nCells());
        tensorField gradient(mesh().nCells());
        old_[k].onto(mesh(), c, gradient);
        for (label i = 3*k; i < min(3*k + 3, solutes_.size()); ++i)
        {
            scalarField mine(max(c.component(i - 3*k)(), scalar(0)));
            const scalar there = gSum(scalarField(volumes_*mine));
            if (same && there > 0)
            {
                mine *= amounts_[i]/there;
            }
            solutes_[i].set(std::move(mine), same ? 0 : there - amounts_[i]);
            solutes_[i].bound().renew();
        }
    }
    old_.clear();
}


Foam::fsbi::outcome Foam::fsbi::species::advance()
{
    const untrapped scope;
    const scalar dt = mesh().time().deltaTValue();
    const meshStencil& stencil = fluid_.stokes().stencil();
    const relativeFlux flux(fluid_, stencil, {points_, volumes_, dt}, false);
    for (solute& s : solutes_)
    {
        const outcome solved(s.advance(stencil, flux, volumes_, dt));
        if (!solved)
        {
            return solved;
        }
    }
    return outcome();
}


void Foam::fsbi::species::endStep()
{
    for (solute& s : solutes_)
    {
        s.accept();
    }
    take();
}


void Foam::fsbi::species::declare(recording& history) const
{
    for (const solute& s : solutes_)
    {
        s.declare(history);
    }
}


void Foam::fsbi::species::record(recording& history) const
{
    for (const solute& s : solutes_)
    {
        s.record(history);
    }
}


void Foam::fsbi::species::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    for (const solute& s : solutes_)
    {
        s.write(add);
    }
}


void Foam::fsbi::species::save(dictionary& state) const
{
    for (const solute& s : solutes_)
    {
        dictionary dict;
        s.save(dict);
        state.set(s.name(), dict);
    }
}


void Foam::fsbi::species::restore(const dictionary& state)
{
    for (solute& s : solutes_)
    {
        s.restore(state.subDict(s.name()));
    }
    take();
}
