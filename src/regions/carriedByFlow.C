/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedByFlow.H"
#include "loadLibraries.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(carriedByFlow, 0);
defineRunTimeSelectionTable(carriedByFlow, file);

//- The only one so far: the name of its file, its type and of its library
static const word species("species");

} // End namespace fsbi
} // End namespace Foam


bool Foam::fsbi::carriedByFlow::wanted(const Time& time)
{
    bool found = isFile(time.globalPath()/time.constant()/species);
    Pstream::scatter(found);
    return found;
}


Foam::autoPtr<Foam::fsbi::carriedByFlow> Foam::fsbi::carriedByFlow::New
(
    const fluidRegion& fluid, const dictionary& saved
)
{
    loadLibraryOf(species);
    if (!fileConstructorTablePtr_ || !fileConstructorTablePtr_->found(species))
    {
        FatalErrorInFunction
            << "There is a file constant/" << species << ", but its library"
            << " libfsbiSpecies.so cannot be loaded" << exit(FatalError);
    }
    return (*fileConstructorTablePtr_)[species](fluid, saved);
}


void Foam::fsbi::carriedByFlow::reportNames(Ostream& os) const
{
    const wordList all(names());
    forAll(all, i)
    {
        os << (i ? " " : "") << all[i].c_str();
    }
}
