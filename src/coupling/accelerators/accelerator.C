/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "accelerator.H"
#include "untrapped.H"

#include <cmath>

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(accelerator, 0);
    defineRunTimeSelectionTable(accelerator, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::accelerator::accelerator()
:
    inStep_(false)
{}


Foam::autoPtr<Foam::fsbi::accelerator> Foam::fsbi::accelerator::New
(
    const checkedDictionary& entries
)
{
    const word method(entries.choice("method", methods()));
    return entriesConstructorTablePtr_->cfind(method)()(entries);
}


Foam::wordList Foam::fsbi::accelerator::methods()
{
    return entriesConstructorTablePtr_->sortedToc();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsbi::accelerator::check(const bool good, const char* what) const
{
    if (!good)
    {
        FatalErrorInFunction
            << "Coupling by " << type() << ": " << what << abort(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsbi::accelerator::start(const scalarField& weights)
{
    check(!inStep_, "the interface changes within a step");
    product_ = interfaceProduct(weights);
    forgetSteps();
    forgetPasses();
}


Foam::scalar Foam::fsbi::accelerator::next
(
    scalarField& x, const scalarField& Hx
)
{
    check(inStep_, "a pass outside a step");
    check
    (
        x.size() == product_.size() && Hx.size() == product_.size(),
        "interface vectors and weights differ in size"
    );
    // partners that diverge may return anything: the caller looks at the norm
    const untrapped scope;
    const scalarField residual(Hx - x);
    const scalar norm = product_.norm(residual);
    if (std::isfinite(norm))
    {
        update(x, residual);
    }
    return norm;
}


void Foam::fsbi::accelerator::beginStep()
{
    check(!inStep_, "a step begins within another one");
    inStep_ = true;
}


void Foam::fsbi::accelerator::rewind()
{
    forgetPasses();
    inStep_ = false;
}


void Foam::fsbi::accelerator::endStep()
{
    check(inStep_, "the step that ends is not begun");
    learn();
    forgetPasses();
    inStep_ = false;
}


void Foam::fsbi::accelerator::save(dictionary& state) const
{
    check(!inStep_, "the state is saved within a step");
    state.set("method", word(type()));
    saveMemory(state);
}


void Foam::fsbi::accelerator::restore(const dictionary& state)
{
    check(!inStep_, "a state is restored within a step");
    forgetSteps();
    // another method converges to the same answer, so it may go on
    if (state.get<word>("method") == type())
    {
        restoreMemory(state);
    }
    forgetPasses();
}
