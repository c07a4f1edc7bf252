/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticNewton.H"

namespace Foam
{
namespace fsbi
{

//- Of one linear solution
static const label maxKrylov = 1000;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::elasticNewton::elasticNewton
(
    const fvMesh& mesh,
    elasticOperator& elastic,
    const solidMaterial& material,
    const checkedDictionary& entries
)
:
    elastic_(elastic),
    preconditioner_(mesh, elastic),
    residual_(mesh, elastic, material),
    tolerance_(entries.tolerance("tolerance", 1e-8)),
    maxIterations_(entries.count("maxIterations", 40)),
    linear_(material.linear()),
    row_(elastic.size()),
    newton_(*this, "fsbiSolidKrylov_", 100, maxKrylov)
{}


bool Foam::fsbi::elasticNewton::admissible(const scalarList& x)
{
    return residual_.evaluate(x);
}


void Foam::fsbi::elasticNewton::applyJacobian
(
    const scalar* dx, scalar* dr
) const
{
    elastic_.applyJacobian(dx, dr);
    residual_.finishJacobian(dx, dr);
}


void Foam::fsbi::elasticNewton::precondition
(
    const scalar* r, scalar* z
) const
{
    residual_.unscale(r, row_);
    preconditioner_.apply(row_.cdata(), z);
}


void Foam::fsbi::elasticNewton::renewPreconditioner()
{
    preconditioner_.rebuild(residual_.stiffness());
}


void Foam::fsbi::elasticNewton::setProblem(const solidProblem& problem)
{
    residual_.setProblem(problem);
    preconditioner_.setDiagonal(residual_.stiffness());
    const scalar mass = gSum(residual_.stiffness());
    if (mass != mass_)
    {
        mass_ = mass;
        newton_.renewPreconditioner();
    }
}


Foam::fsbi::solverReport Foam::fsbi::elasticNewton::solve
(
    const solidProblem& problem, scalarList& x
)
{
    setProblem(problem);
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
        newton_.correct
        (
            residual_.rows(), residual_.norm(), target, x, report
        );
        if (report.failure.size())
        {
            return report;
        }
    }
}
