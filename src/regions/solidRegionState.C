/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidRegion.H"
#include "IOField.H"
#include "Time.H"

// fsbiRedistribute knows by these names which part of the mesh a number is of
template<class Visitor>
void Foam::fsbi::solidRegion::visitState(const Visitor& visit)
{
    visit("solution", x_);
    visit("increment", increment_);
    visit("faceForce", balance_.force());
    if (moves())
    {
        visit("referenceF", elastic_->state().referenceF());
    }
    if
    (
        moves()
     || (elastic_->dampsJumps() && !isStatic())
     || material_->flows()
    )
    {
        visit("jumpHistory", elastic_->jumpHistory());
    }
    if (viscous() || material_->flows())
    {
        visit("oldF", elastic_->state().oldF());
    }
    if (material_->flows())
    {
        visit("olderF", elastic_->state().olderF());
    }
    motion_->fields
    (
        [&](const word& name, vectorField& field)
        {
            visit("motion." + name, field);
        }
    );
    if (wetted_)
    {
        wetted_->fields
        (
            [&](const word& name, vectorField& field)
            {
                visit("surface." + name, field);
            }
        );
    }
}


void Foam::fsbi::solidRegion::write
(
    const std::function<void(const regIOobject&)>& add
)
{
    writeMesh(mesh(), moves() ? reference_ : mesh().points(), add);
    fields_->write(add);
    visitState
    (
        [&](const word& name, const auto& field)
        {
            typedef typename std::decay_t<decltype(field)>::value_type type;
            add
            (
                IOField<type>
                (
                    IOobject
                    (
                        name, time_.timeName(), "state", mesh(),
                        IOobject::NO_READ, IOobject::NO_WRITE, false
                    ),
                    field
                )
            );
        }
    );
}


void Foam::fsbi::solidRegion::save(dictionary& state) const
{
    body_.saveShape(state);
    state.set("formulation", constitutiveState::formulationNames[formulation_]);
    state.set("order", order_);
    state.set("oldStep", oldStep_);
    balance_.save(state);
    dictionary motion;
    motion_->save(motion);
    state.set("motion", motion);
    if (wetted_)
    {
        dictionary surface;
        wetted_->save(surface);
        state.set("surface", surface);
        state.set("fluidForce", fluidForce_);
        state.set("tether", rows_.multiplier);
        state.set("place", tethered_);
    }
}


void Foam::fsbi::solidRegion::restore(const dictionary& state)
{
    body_.checkShape(state);
    const auto changed = [this](const char* what)
    {
        FatalErrorInFunction
            << "Body '" << name() << "': " << what << " no longer as in the"
            << " saved state. Put it back, or start a new run at time 0"
            << exit(FatalError);
    };
    if
    (
        state.get<word>("formulation")
     != constitutiveState::formulationNames[formulation_]
    )
    {
        changed("'formulation' is");
    }
    if (state.getOrDefault<label>("order", 2) != order_)
    {
        changed("'order' is");
    }
    const label size = x_.size();
    motion_->restore(state.subDict("motion"));
    if (wetted_)
    {
        wetted_->restore(state.subDict("surface"));
        fluidForce_ = state.get<vector>("fluidForce");
        rows_.multiplier = state.get<vector>("tether");
        tethered_ = state.get<vector>("place");
    }
    visitState
    (
        [&](const word& name, auto& field)
        {
            typedef typename std::decay_t<decltype(field)>::value_type type;
            const IOField<type> saved
            (
                IOobject
                (
                    name, time_.timeName(), "state", mesh(),
                    IOobject::MUST_READ, IOobject::NO_WRITE, false
                )
            );
            field = saved;
        }
    );
    if (x_.size() != size)
    {
        changed("'mixed' or the kinds of boundary conditions are");
    }
    oldStep_ = state.get<scalar>("oldStep");
    balance_.restore
    (
        state, fields_->boundaryD(), gSum(volumes_*fields_->D())
    );
    measures_.work = balance_.work();
}
