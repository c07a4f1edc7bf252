/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effect.H"
#include "loadLibraries.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(effect, 0);
defineRunTimeSelectionTable(effect, entries);

//- Effects that come with the project, each in a library of its own
static const wordList ours
({
    "bonds", "contact", "magnetics", "opticalTweezers", "repulsion",
    "thermalMotion", "weight"
});

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::effect::effect(const effectContext& context)
:
    context_(context)
{}


Foam::autoPtr<Foam::fsbi::effect> Foam::fsbi::effect::New
(
    const entry& e, const effectContext& context
)
{
    const word& type = e.keyword();
    const auto known = [&type]()
    {
        return
            entriesConstructorTablePtr_
         && entriesConstructorTablePtr_->found(type);
    };
    loadLibraries(e.dict());
    if (!known() && ours.found(type))
    {
        loadLibraryOf(type);
    }
    if (!known())
    {
        wordList valid(ours);
        if (entriesConstructorTablePtr_)
        {
            valid.append(entriesConstructorTablePtr_->sortedToc());
        }
        FatalIOErrorInFunction(e.dict())
            << "There is no effect '" << type << "'; valid effects are "
            << flatOutput(wordHashSet(valid).sortedToc())
            << exit(FatalIOError);
    }
    return (*entriesConstructorTablePtr_)[type](e.dict(), context);
}
