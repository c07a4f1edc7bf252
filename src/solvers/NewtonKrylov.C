/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NewtonKrylov.H"
#include "error.H"

namespace Foam
{
namespace fsbi
{

//- Accuracy of a correction's linear solution, until the last one needs less
static const scalar forcing = 1e-3;

//- Last linear solution over the target: what is left to the second order
static const scalar margin = 0.3;

//- Growth of the iterations that makes a new preconditioner worth its price
static const scalar renewAbove = 1.3;

//- Iterations a digit that are few enough with any preconditioner
static const scalar fewIterations = 4;

static const label maxHalvings = 12;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::NewtonKrylov::NewtonKrylov
(
    nonlinearSystem& system,
    const char* prefix,
    const label restart,
    const label maxIterations
)
:
    system_(system),
    maxIterations_(maxIterations),
    krylov_
    (
        system.size(), prefix, restart, !system.fixedPreconditioner(),
        [&](const scalar* x, scalar* y){ system.applyJacobian(x, y); },
        [&](const scalar* r, scalar* z){ system.precondition(r, z); }
    ),
    dx_(system.size())
{}


void Foam::fsbi::NewtonKrylov::watch
(
    const label iterations, const scalar accuracy
)
{
    const scalar rate = max(iterations/log10(1/accuracy), fewIterations);
    if (!freshRate_)
    {
        freshRate_ = rate;
    }
    else if (rate > renewAbove*freshRate_)
    {
        freshRate_ = 0;
    }
}


Foam::fsbi::matrixFreeKrylov::outcome Foam::fsbi::NewtonKrylov::step
(
    const scalarList& rows, const scalar accuracy
)
{
    if (!freshRate_)
    {
        system_.renewPreconditioner();
    }
    const matrixFreeKrylov::outcome outcome
    (
        krylov_.solve(rows.cdata(), dx_.begin(), accuracy, maxIterations_)
    );
    watch(outcome.iterations, accuracy);
    return outcome;
}


Foam::fsbi::matrixFreeKrylov::outcome Foam::fsbi::NewtonKrylov::guardedStep
(
    const scalarList& rows, const scalar accuracy
)
{
    const bool throwing = FatalError.throwExceptions();
    matrixFreeKrylov::outcome outcome{-1, GREAT, false};
    try
    {
        outcome = step(rows, accuracy);
    }
    catch (const Foam::error&)
    {
        freshRate_ = 0;
    }
    FatalError.throwExceptions(throwing);
    return outcome;
}


bool Foam::fsbi::NewtonKrylov::advance(scalarList& x)
{
    const scalarList old(x);
    scalar part = 1;
    for (label halving = 0; halving < maxHalvings; ++halving)
    {
        forAll(x, i)
        {
            x[i] = old[i] - part*dx_[i];
        }
        if (system_.admissible(x))
        {
            return true;
        }
        part /= 2;
    }
    x = old;
    return false;
}


bool Foam::fsbi::NewtonKrylov::correct
(
    const scalarList& rows,
    const scalar norm,
    const scalar target,
    scalarList& x,
    solverReport& report
)
{
    const matrixFreeKrylov::outcome outcome
    (
        system_.linear()
      ? step(rows, target/norm)
      : guardedStep(rows, max(margin*target/norm, forcing))
    );
    if (outcome.iterations < 0)
    {
        report.failure =
            "the linear equations broke down: a body may have lost its stiffness";
        return false;
    }
    report.iterations += outcome.iterations;
    ++report.corrections;
    if (!advance(x))
    {
        report.failure = "a cell is turned inside out";
        return false;
    }
    return outcome.converged;
}
