/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactSolution.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "Time.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(exactSolution, 0);
    defineRunTimeSelectionTable(exactSolution, entries);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::exactSolution::exactSolution
(
    const checkedDictionary& entries, const dictionary& material
)
:
    law_(solidMaterial::New(material)),
    origin_(entries.getOrDefault<point>("origin", Zero))
{}


Foam::autoPtr<Foam::fsbi::exactSolution> Foam::fsbi::exactSolution::New
(
    const dictionary& dict, const dictionary& material
)
{
    const checkedDictionary entries(dict);
    const word type(entries.get<word>("type"));
    auto constructor = entriesConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown exact solution '" << type
            << "'; valid exact solutions are "
            << flatOutput(entriesConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    autoPtr<exactSolution> solution(constructor()(entries, material));
    entries.finish();
    return solution;
}


Foam::autoPtr<Foam::fsbi::exactSolution> Foam::fsbi::exactSolution::New
(
    const fvMesh& mesh
)
{
    const auto read = [&](const word& name)
    {
        return IOdictionary
        (
            IOobject
            (
                name, mesh.time().constant(), mesh, IOobject::MUST_READ,
                IOobject::NO_WRITE, false
            )
        );
    };
    return New(read("exactSolution"), read("material"));
}
