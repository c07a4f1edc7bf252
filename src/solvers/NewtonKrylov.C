/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NewtonKrylov.H"
#include "PstreamReduceOps.H"

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
    tolerance_(entries.positive("tolerance", 1e-8)),
    maxIterations_(entries.getOrDefault<label>("maxIterations", 40)),
    linear_(material.linear()),
    scale_(elastic.size()),
    residual_(elastic.size()),
    row_(elastic.size()),
    dx_(elastic.size())
{}


void Foam::fsbi::NewtonKrylov::createKrylov()
{
    const PetscInt n = elastic_.size();
    petscCheck
    (
        MatCreateShell
        (
            PETSC_COMM_WORLD, n, n, PETSC_DETERMINE, PETSC_DETERMINE, this,
            operator_.create()
        )
    );
    petscCheck
    (
        MatShellSetOperation
        (
            operator_, MATOP_MULT, reinterpret_cast<void(*)(void)>(multiply)
        )
    );
    petscCheck(MatCreateVecs(operator_, unknown_.create(), rhs_.create()));

    PC pc;
    petscCheck(KSPCreate(PETSC_COMM_WORLD, krylov_.create()));
    petscCheck(KSPSetOperators(krylov_, operator_, operator_));
    petscCheck(KSPSetType(krylov_, KSPFGMRES));
    petscCheck(KSPGMRESSetRestart(krylov_, 100));
    petscCheck(KSPGetPC(krylov_, &pc));
    petscCheck(PCSetType(pc, PCSHELL));
    petscCheck(PCShellSetContext(pc, this));
    petscCheck(PCShellSetApply(pc, applyPreconditioner));
    petscCheck(KSPSetOptionsPrefix(krylov_, "fsbiSolidKrylov_"));
    petscCheck(KSPSetFromOptions(krylov_));
}


void Foam::fsbi::NewtonKrylov::setScale()
{
    const label nCells = mesh_.nCells();
    const label nGhosts = elastic_.nGhosts();
    const scalarField& volume = elastic_.stencil().vertexVolume();
    forAll(preconditioner_.diagonal(), celli)
    {
        for (label k = 0; k < 3; ++k)
        {
            scale_[3*celli + k] = 1/preconditioner_.diagonal()[celli];
        }
    }
    std::fill_n(scale_.begin() + 3*nCells, 3*nGhosts, scalar(1));
    forAll(elastic_.ownedVertices(), i)
    {
        const scalar V = volume[elastic_.ownedVertices()[i]];
        scale_[3*(nCells + nGhosts) + i] = cbrt(V)/V;
    }
}


bool Foam::fsbi::NewtonKrylov::evaluate(const scalarList& x, scalar& norm)
{
    elastic_.residual(x.cdata(), problem_->given, residual_.begin());
    scalar sum = 0;
    forAll(problem_->force, celli)
    {
        for (direction k = 0; k < 3; ++k)
        {
            const label i = 3*celli + k;
            residual_[i] +=
                problem_->mass[celli]*x[i] - problem_->force[celli][k];
        }
    }
    forAll(residual_, i)
    {
        residual_[i] *= scale_[i];
        sum += sqr(residual_[i]);
    }
    norm = sqrt(returnReduce(sum, sumOp<scalar>()));
    return elastic_.valid() && std::isfinite(norm);
}


Foam::scalar Foam::fsbi::NewtonKrylov::reference(const scalarList& x) const
{
    scalar sum = 0;
    forAll(mesh_.cells(), celli)
    {
        const scalar area = pow(mesh_.cellVolumes()[celli], 2.0/3.0);
        const scalar force =
            area*mag(elastic_.cellMean(celli, elastic_.stress()))
          + mag(problem_->force[celli]);
        sum += magSqr(force*scale_[3*celli]);
    }
    return sqrt(returnReduce(sum, sumOp<scalar>()));
}


Foam::scalar Foam::fsbi::NewtonKrylov::roundOff() const
{
    // a linear law sees the gradient, others see 1 + gradient
    scalar sum = 0;
    forAll(mesh_.cells(), celli)
    {
        const scalar area = pow(mesh_.cellVolumes()[celli], 2.0/3.0);
        sum += sqr(elastic_.stiffness()*area*scale_[3*celli]);
    }
    return linear_ ? 0 : 1e-15*sqrt(returnReduce(sum, sumOp<scalar>()));
}


PetscErrorCode Foam::fsbi::NewtonKrylov::multiply(Mat A, Vec in, Vec out)
{
    void* context;
    MatShellGetContext(A, &context);
    const auto& self = *static_cast<NewtonKrylov*>(context);
    const PetscScalar* x;
    PetscScalar* y;
    VecGetArrayRead(in, &x);
    VecGetArray(out, &y);
    self.elastic_.tangent(x, y);
    forAll(self.problem_->mass, celli)
    {
        for (label i = 3*celli; i < 3*celli + 3; ++i)
        {
            y[i] += self.problem_->mass[celli]*x[i];
        }
    }
    forAll(self.scale_, i)
    {
        y[i] *= self.scale_[i];
    }
    VecRestoreArray(out, &y);
    VecRestoreArrayRead(in, &x);
    return 0;
}


PetscErrorCode Foam::fsbi::NewtonKrylov::applyPreconditioner
(
    PC pc, Vec in, Vec out
)
{
    void* context;
    PCShellGetContext(pc, &context);
    const auto& self = *static_cast<NewtonKrylov*>(context);
    const PetscScalar* r;
    PetscScalar* z;
    VecGetArrayRead(in, &r);
    VecGetArray(out, &z);
    forAll(self.scale_, i)
    {
        self.row_[i] = r[i]/self.scale_[i];
    }
    self.preconditioner_.apply(self.row_.cdata(), z);
    VecRestoreArray(out, &z);
    VecRestoreArrayRead(in, &r);
    return 0;
}


Foam::label Foam::fsbi::NewtonKrylov::correction(const scalar accuracy)
{
    if (!freshIterations_)
    {
        preconditioner_.rebuild(problem_->mass);
    }
    PetscScalar* values;
    VecGetArray(rhs_, &values);
    std::copy(residual_.begin(), residual_.end(), values);
    VecRestoreArray(rhs_, &values);
    petscCheck
    (
        KSPSetTolerances
        (
            krylov_, accuracy, PETSC_DEFAULT, PETSC_DEFAULT, maxKrylov
        )
    );
    petscCheck(KSPSolve(krylov_, rhs_, unknown_));
    VecGetArray(unknown_, &values);
    std::copy_n(values, dx_.size(), dx_.begin());
    VecRestoreArray(unknown_, &values);

    PetscInt iterations;
    KSPGetIterationNumber(krylov_, &iterations);
    if (!freshIterations_)
    {
        freshIterations_ = max(label(iterations), 10);
    }
    else if (iterations > renewAbove*freshIterations_)
    {
        freshIterations_ = 0;
    }
    return iterations;
}


bool Foam::fsbi::NewtonKrylov::advance(scalarList& x, scalar& norm)
{
    scalar part = 1;
    for (label i = 0; i < maxHalvings; ++i)
    {
        forAll(x, j)
        {
            x[j] -= part*dx_[j];
        }
        if (evaluate(x, norm))
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
    problem_ = &problem;
    if (!krylov_)
    {
        createKrylov();
    }
    const scalar mass = gSum(problem.mass);
    if (mass != mass_)
    {
        mass_ = mass;
        freshIterations_ = 0;
    }
    solverReport report;
    report.corrections = 0;
    scalar norm = 0;
    preconditioner_.setDiagonal(problem.mass);
    setScale();
    if (!evaluate(x, norm))
    {
        x = 0;
        if (!evaluate(x, norm))
        {
            report.failure = "the body was inside out when the step began";
            return report;
        }
    }
    const scalar least = roundOff();
    scalar size = max(norm, reference(x));
    while (true)
    {
        report.residual = norm/max(size, VSMALL);
        report.converged = norm <= max(tolerance_*size, least);
        if (report.converged || report.corrections == maxIterations_)
        {
            return report;
        }
        const scalar needed = margin*max(tolerance_*size, least)/norm;
        report.iterations += correction
        (
            linear_ ? needed : max(needed, forcing)
        );
        ++report.corrections;
        if (!advance(x, norm))
        {
            report.failure = "a cell is turned inside out";
            return report;
        }
        size = max(size, reference(x));
    }
}
