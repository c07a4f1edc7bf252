/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "IQNILS.H"
#include "interfaceLeastSquares.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(IQNILS, 0);
    addToRunTimeSelectionTable(accelerator, IQNILS, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::IQNILS::IQNILS(const checkedDictionary& entries)
:
    omega_(entries.positive("omega", 0.1)),
    reuse_(entries.getOrDefault<label>("reuse", 0)),
    filter_(entries.positive("filter", 1e-8)),
    hasOld_(false),
    used_(0),
    filtered_(0)
{
    if (reuse_ < 0)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'reuse' must be 0 or more, but is " << reuse_
            << exit(FatalIOError);
    }
    // below that nothing but round-off is left of a column
    if (filter_ < 1e-14 || filter_ >= 1)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry 'filter' must be 1e-14 or more and below 1, but is "
            << filter_ << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::DynamicList<const Foam::fsbi::IQNILS::column*>
Foam::fsbi::IQNILS::allColumns() const
{
    DynamicList<const column*> all;
    for (const column& c : present_)
    {
        all.append(&c);
    }
    for (const columns& step : past_)
    {
        for (const column& c : step)
        {
            all.append(&c);
        }
    }
    return all;
}


Foam::dictionary Foam::fsbi::IQNILS::saved(const columns& step)
{
    List<scalarField> V(step.size());
    List<scalarField> W(step.size());
    forAll(V, i)
    {
        V[i] = step[i].V;
        W[i] = step[i].W;
    }
    dictionary state;
    state.set("V", V);
    state.set("W", W);
    return state;
}


Foam::fsbi::IQNILS::columns Foam::fsbi::IQNILS::restored
(
    const dictionary& state
)
{
    const List<scalarField> V(state.get<List<scalarField>>("V"));
    const List<scalarField> W(state.get<List<scalarField>>("W"));
    columns step;
    forAll(V, i)
    {
        step.push_back({V[i], W[i]});
    }
    return step;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::IQNILS::update(scalarField& x, const scalarField& residual)
{
    const scalarField Hx(x + residual);
    if (hasOld_)
    {
        present_.push_front({residual - oldResidual_, Hx - oldHx_});
    }
    oldResidual_ = residual;
    oldHx_ = Hx;
    hasOld_ = true;

    const DynamicList<const column*> all(allColumns());
    List<const scalarField*> V(all.size());
    forAll(all, j)
    {
        V[j] = &all[j]->V;
    }
    const interfaceLeastSquares fit(product(), V, residual, filter_);
    used_ = fit.rank();
    filtered_ = all.size() - used_;
    if (!used_)
    {
        x += omega_*residual;
        return;
    }
    x = Hx;
    forAll(all, j)
    {
        // R + V c is minimal for minus the coefficients of R
        x -= fit.coefficients()[j]*all[j]->W;
    }
}


void Foam::fsbi::IQNILS::forgetPasses()
{
    present_.clear();
    oldResidual_.clear();
    oldHx_.clear();
    hasOld_ = false;
}


void Foam::fsbi::IQNILS::learn()
{
    // a step of a single pass must not push out what is known
    if (!present_.empty())
    {
        past_.push_front(std::move(present_));
    }
    while (label(past_.size()) > reuse_)
    {
        past_.pop_back();
    }
}


void Foam::fsbi::IQNILS::forgetSteps()
{
    past_.clear();
}


void Foam::fsbi::IQNILS::saveMemory(dictionary& state) const
{
    state.set("steps", label(past_.size()));
    label i = 0;
    for (const columns& step : past_)
    {
        state.set(word("step" + Foam::name(i++)), saved(step));
    }
}


void Foam::fsbi::IQNILS::restoreMemory(const dictionary& state)
{
    const label n = min(reuse_, state.get<label>("steps"));
    bool fits = true;
    for (label i = 0; i < n; ++i)
    {
        const word name("step" + Foam::name(i));
        past_.push_back(restored(state.subDict(name)));
        for (const column& c : past_.back())
        {
            fits = fits && c.V.size() == product().size()
                && c.W.size() == product().size();
        }
    }
    if (!returnReduce(fits, andOp<bool>()))
    {
        past_.clear();
        WarningInFunction
            << "The state is of another division into processors: coupling "
            << "continues without the columns of past steps" << endl;
    }
}
