/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSolver.H"
#include "SIMPLEC.H"

Foam::autoPtr<Foam::fsbi::fluidSolver> Foam::fsbi::fluidSolver::New
(
    const fvMesh& mesh,
    const momentumEquation& momentum,
    const dictionary& dict
)
{
    const word method
    (
        checkedDictionary(dict).choice
        (
            "method", {"coupled", "SIMPLEC", "reduced"}, "coupled"
        )
    );
    if (method == "SIMPLEC")
    {
        if (!momentum.linear())
        {
            FatalIOErrorInFunction(dict)
                << "A flow that is not linear in the velocity, by convection or by"
                << " the viscosity (constant/fluid/material), needs method"
                << " 'coupled' in 'coupling' of system/fluid/fvSolution"
                << exit(FatalIOError);
        }
        return autoPtr<fluidSolver>(new SIMPLEC(mesh, momentum, dict));
    }
    // of 'reduced', which has no flow to solve, this one makes the checks
    return autoPtr<fluidSolver>(new coupledSolver(momentum, dict));
}


void Foam::fsbi::fluidSolver::knowOthers(const checkedDictionary& entries)
{
    for
    (
        const char* key
      : {
            "method", "order", "faceValues", "gradients", "scheme", "geometry",
            "passes", "reduced"
        }
    )
    {
        entries.found(key);
    }
}


Foam::fsbi::solverReport Foam::fsbi::fluidSolver::correct
(
    const flowProblem&, const bool, scalarList&, vectorField&
)
{
    FatalErrorInFunction
        << "Elastic bodies in a flow need method 'coupled' in 'coupling' of"
        << " system/fluid/fvSolution" << exit(FatalError);
    return solverReport();
}
