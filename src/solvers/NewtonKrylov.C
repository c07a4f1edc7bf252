/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NewtonKrylov.H"

namespace Foam
{
namespace fsbi
{

//- Accuracy of the linear solutions, until the last one needs less
static const scalar forcing = 1e-3;

//- Last linear solution over the tolerance: what is left to round-off
static const scalar margin = 0.3;

//- Growth of the iterations that makes a new hierarchy worth its price
static const scalar renewAbove = 1.5;

static const label maxKrylov = 1000;
static const label maxHalvings = 12;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::NewtonKrylov::NewtonKrylov
(
    const fvMesh& mesh,
    elasticOperator& elastic,
    const solidMaterial& material,
    const checkedDictionary& entries
)
:
    mesh_(mesh),
    elastic_(elastic),
    preconditioner_(mesh, elastic, material),
    tolerance_(entries.tolerance("tolerance", 1e-8)),
    maxIterations_(entries.count("maxIterations", 40)),
    linear_(material.linear()),
    residual_(mesh, elastic, material),
    row_(elastic.size()),
    dx_(elastic.size())
{}


void Foam::fsbi::NewtonKrylov::createKrylov()
{
    const auto multiply = [this](const scalar* x, scalar* y)
    {
        elastic_.tangent(x, y);
        residual_.finishTangent(x, y);
    };
    const auto precondition = [this](const scalar* r, scalar* z)
    {
        residual_.unscale(r, row_);
        preconditioner_.apply(row_.cdata(), z);
    };
    krylov_.reset
    (
        new matrixFreeKrylov
        (
            elastic_.size(), "fsbiSolidKrylov_", 100, multiply, precondition
        )
    );
}


Foam::label Foam::fsbi::NewtonKrylov::correction(const scalar accuracy)
{
    if (!freshIterations_)
    {
        preconditioner_.rebuild(residual_.stiffness());
    }
    dx_ = 0;
    const label iterations = krylov_->solve
    (
        residual_.rows().cdata(), dx_.begin(), accuracy, maxKrylov
    ).iterations;
    if (!freshIterations_)
    {
        freshIterations_ = max(iterations, 10);
    }
    else if (iterations > renewAbove*freshIterations_)
    {
        freshIterations_ = 0;
    }
    return iterations;
}


Foam::label Foam::fsbi::NewtonKrylov::guardedCorrection(const scalar accuracy)
{
    // multigrid stops with an error where the derivative is not positive
    const bool throwing = FatalError.throwExceptions();
    label iterations = -1;
    try
    {
        iterations = correction(accuracy);
    }
    catch (const Foam::error&)
    {
        freshIterations_ = 0;
    }
    FatalError.throwExceptions(throwing);
    return iterations;
}


bool Foam::fsbi::NewtonKrylov::advance(scalarList& x)
{
    scalar part = 1;
    for (label i = 0; i < maxHalvings; ++i)
    {
        forAll(x, j)
        {
            x[j] -= part*dx_[j];
        }
        if (residual_.evaluate(x))
        {
            return true;
        }
        forAll(x, j)
        {
            x[j] += part*dx_[j];
        }
        part /= 2;
    }
    return false;
}


Foam::fsbi::solverReport Foam::fsbi::NewtonKrylov::solve
(
    const solidProblem& problem, scalarList& x
)
{
    residual_.setProblem(problem);
    preconditioner_.setDiagonal(residual_.stiffness());
    if (!krylov_)
    {
        createKrylov();
    }
    const scalar mass = gSum(residual_.stiffness());
    if (mass != mass_)
    {
        mass_ = mass;
        freshIterations_ = 0;
    }
    solverReport report;
    report.corrections = 0;
    if (!residual_.evaluate(x))
    {
        x = 0;
        if (!residual_.evaluate(x))
        {
            report.failure = "the body was inside out when the step began";
            return report;
        }
    }
    while (true)
    {
        const scalar target = residual_.target(tolerance_);
        report.residual = residual_.norm()/max(residual_.size(), VSMALL);
        report.converged = residual_.norm() <= target;
        if (report.converged || report.corrections == maxIterations_)
        {
            return report;
        }
        const scalar needed = margin*target/residual_.norm();
        const label iterations = guardedCorrection
        (
            linear_ ? needed : max(needed, forcing)
        );
        if (iterations < 0)
        {
            report.failure = "the body has lost its stiffness";
            return report;
        }
        report.iterations += iterations;
        ++report.corrections;
        if (!advance(x))
        {
            report.failure = "a cell is turned inside out";
            return report;
        }
    }
}
