/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magnetisation.H"
#include "wordList.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(magnetisation, 0);
defineRunTimeSelectionTable(magnetisation, entries);

//- A m^2, 1/mol
static const scalar BohrMagneton = 9.2740100783e-24;
static const scalar Avogadro = 6.02214076e23;

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::magnetisation> Foam::fsbi::magnetisation::New
(
    const dictionary& dict
)
{
    const checkedDictionary entries(dict);
    const word type
    (
        entries.choice("type", entriesConstructorTablePtr_->sortedToc())
    );
    auto law(entriesConstructorTablePtr_->cfind(type)()(entries));
    entries.finish();
    return law;
}


Foam::fsbi::momentSize::momentSize(const checkedDictionary& entries)
{
    label given = 0;
    if (entries.found("moment"))
    {
        whole_ = entries.positive("moment");
        ++given;
    }
    if (entries.found("magnetisation"))
    {
        perVolume_ = entries.positive("magnetisation");
        ++given;
    }
    if (entries.found("atoms"))
    {
        const checkedDictionary atoms(entries.subDict("atoms"));
        perVolume_ =
            atoms.positive("moment")*BohrMagneton*Avogadro
           *atoms.positive("density")/atoms.positive("molarMass");
        atoms.finish();
        ++given;
    }
    if (given != 1)
    {
        FatalIOErrorInFunction(entries.dict())
            << "Give one of the entries 'moment' (A m2), 'magnetisation' (A/m)"
            << " and 'atoms'; there are " << given << exit(FatalIOError);
    }
}
