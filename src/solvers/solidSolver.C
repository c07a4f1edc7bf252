/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticNewton.H"
#include "segregated.H"

Foam::autoPtr<Foam::fsbi::solidSolver> Foam::fsbi::solidSolver::New
(
    const fvMesh& mesh,
    elasticOperator& elastic,
    const solidMaterial& material,
    const dictionary& dict
)
{
    const checkedDictionary entries(dict);
    entries.found("formulation");
    entries.found("mixed");
    entries.found("order");
    const word method
    (
        entries.choice("method", {"NewtonKrylov", "segregated"}, "NewtonKrylov")
    );
    autoPtr<solidSolver> solver;
    if (method == "segregated")
    {
        solver.reset(new segregated(mesh, elastic, material, entries));
    }
    else
    {
        solver.reset(new elasticNewton(mesh, elastic, material, entries));
    }
    entries.finish();
    return solver;
}


void Foam::fsbi::solidSolver::reportUnused
(
    const dictionary& dict, const word& body
)
{
    const checkedDictionary entries(dict);
    entries.found("formulation");
    entries.found("mixed");
    entries.found("order");
    for (const char* key : {"method", "tolerance", "maxIterations", "relaxation"})
    {
        if (entries.found(key))
        {
            Info<< "Warning: entry '" << key << "' of 'solid' in system/"
                << body.c_str() << "/fvSolution is not used: fluid and body are"
                << " solved for at once, by 'coupling' in"
                << " system/fluid/fvSolution" << nl << endl;
        }
    }
    entries.finish();
}
