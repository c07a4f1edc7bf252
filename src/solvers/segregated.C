/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "segregated.H"
#include "asVectors.H"
#include "compactEntries.H"
#include "globalIndex.H"

//- Accuracy of the solution for one component in one sweep
static const Foam::scalar sweepAccuracy = 0.1;

//- Residual over the first one at which the sweeps are given up
static const Foam::scalar diverged = 1e4;


Foam::fsbi::segregated::segregated
(
    const fvMesh& mesh,
    elasticOperator& elastic,
    const solidMaterial& material,
    const checkedDictionary& entries
)
:
    mesh_(mesh),
    elastic_(elastic),
    material_(material),
    residual_(mesh, elastic, material),
    tolerance_(entries.tolerance("tolerance", 1e-8)),
    relaxation_(entries.positive("relaxation", 1)),
    maxIterations_(entries.count("maxIterations", 100000)),
    rows_(elastic.size())
{
    if (elastic.state().mixed())
    {
        FatalIOErrorInFunction(entries.dict())
            << "Method 'segregated' has no pressure: give 'mixed no', or"
            << " method NewtonKrylov" << exit(FatalIOError);
    }
}


Foam::scalar Foam::fsbi::segregated::coeff(const label face) const
{
    return
        (2*material_.mu() + material_.lambda())
       *elastic_.stencil().compact()[face];
}


void Foam::fsbi::segregated::setMatrix(const scalarField& mass)
{
    const elasticStencil& stencil = elastic_.stencil();
    const label nCells = mesh_.nCells();
    const globalIndex global(nCells);
    scalarList cell(stencil.nColumns());
    for (label i = 0; i < nCells; ++i)
    {
        cell[i] = global.toGlobal(i);
    }
    stencil.halo().fill(cell.data(), 1);

    compactEntries entries;
    const auto add = [&](const label row, const label column, const scalar k)
    {
        entries.add(cell[row], cell[column], k);
    };
    for (label i = 0; i < nCells; ++i)
    {
        add(i, i, mass[i]);
    }
    for (label i = 0; i < stencil.nFaces(); ++i)
    {
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        if (i < stencil.firstBoundary())
        {
            add(P, P, coeff(i));
            add(P, N, -coeff(i));
        }
        if (N < nCells)
        {
            add(N, N, coeff(i));
            add(N, P, -coeff(i));
        }
        const label g = i - stencil.firstBoundary();
        if (g >= 0 && elastic_.boundary().kindOf(g) != solidBoundary::traction)
        {
            add(P, P, 2*coeff(i));
        }
    }
    entries.create(PETSC_COMM_WORLD, nCells, matrix_, solution_, source_);
    entries.fill(matrix_);
    setKrylov();
}


void Foam::fsbi::segregated::setKrylov()
{
    PC pc;
    petscCheck(KSPCreate(PETSC_COMM_WORLD, krylov_.create()));
    petscCheck(KSPSetType(krylov_, KSPCG));
    petscCheck(KSPGetPC(krylov_, &pc));
    petscCheck(PCSetType(pc, PCGAMG));
    petscCheck
    (
        KSPSetTolerances
        (
            krylov_, sweepAccuracy, PETSC_DEFAULT, PETSC_DEFAULT, 100
        )
    );
    petscCheck(KSPSetOperators(krylov_, matrix_, matrix_));
    petscCheck(KSPSetUp(krylov_));
}


void Foam::fsbi::segregated::solveCells()
{
    const elasticStencil& stencil = elastic_.stencil();
    const label nCells = mesh_.nCells();
    for (label g = 0; g < stencil.nGhosts(); ++g)
    {
        const label i = stencil.firstBoundary() + g;
        const auto kind = elastic_.boundary().kindOf(g);
        for (label k = 0; kind == solidBoundary::displacement && k < 3; ++k)
        {
            rows_[3*stencil.owner()[i] + k] +=
                coeff(i)*rows_[3*(nCells + g) + k];
        }
    }
    for (label k = 0; k < 3; ++k)
    {
        solveComponent(krylov_, source_, solution_, 3, rows_.begin() + k);
    }
}


Foam::fsbi::solverReport Foam::fsbi::segregated::solve
(
    const solidProblem& problem, scalarList& x
)
{
    residual_.setProblem(problem);
    setMatrix(residual_.stiffness());
    solverReport report;
    scalar first = -1;
    for (label sweep = 0; ; ++sweep)
    {
        report.iterations = sweep;
        report.corrections = sweep;
        if (!residual_.evaluate(x))
        {
            report.failure = "a cell is turned inside out";
            return report;
        }
        first = first < 0 ? residual_.norm() : first;
        report.residual = residual_.norm()/max(residual_.size(), VSMALL);
        report.converged = residual_.norm() <= residual_.target(tolerance_);
        if
        (
            report.converged || sweep == maxIterations_
         || residual_.norm() > diverged*first
        )
        {
            return report;
        }
        residual_.unscale(residual_.rows().cdata(), rows_);
        solveCells();
        elastic_.boundary().followCells(asVectors(rows_.begin()));
        forAll(x, i)
        {
            x[i] -= relaxation_*rows_[i];
        }
    }
}
