/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "bodyCoupling.H"
#include "checkedDictionary.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

//- Growth of the iterations that makes a new hierarchy worth its price
static const Foam::scalar renewAbove = 1.3;


Foam::fsbi::coupledSystem::coupledSystem
(
    const fvMesh& mesh,
    const stokesOperator& stokes,
    const dictionary& dict
)
:
    mesh_(mesh),
    stokes_(stokes),
    preconditioner_(mesh, stokes),
    traction_(stokes.nBoundaryFaces(), Zero),
    freshIterations_(0)
{
    const checkedDictionary entries(dict);
    entries.found("method");
    entries.found("faceValues");
    tolerance_ = entries.positive("tolerance", 1e-6);
    maxIterations_ = entries.getOrDefault<label>("maxIterations", 300);
    entries.finish();

    closed_ = stokes.closed();
}


void Foam::fsbi::coupledSystem::createKrylov(const label nBodies)
{
    const PetscInt n =
        4*mesh_.nCells() + (Pstream::master() ? 6*nBodies : 0);

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
    if (closed_)
    {
        setNullSpace(nBodies);
    }

    PC pc;
    petscCheck(KSPCreate(PETSC_COMM_WORLD, krylov_.create()));
    petscCheck(KSPSetOperators(krylov_, operator_, operator_));
    petscCheck(KSPSetType(krylov_, KSPFGMRES));
    petscCheck(KSPGMRESSetRestart(krylov_, 60));
    petscCheck(KSPSetInitialGuessNonzero(krylov_, PETSC_TRUE));
    petscCheck
    (
        KSPSetTolerances
        (
            krylov_, tolerance_, PETSC_DEFAULT, PETSC_DEFAULT, maxIterations_
        )
    );
    petscCheck(KSPGetPC(krylov_, &pc));
    petscCheck(PCSetType(pc, PCSHELL));
    petscCheck(PCShellSetContext(pc, this));
    petscCheck(PCShellSetApply(pc, applyPreconditioner));
    petscCheck(KSPSetOptionsPrefix(krylov_, "fsbiKrylov_"));
    petscCheck(KSPSetFromOptions(krylov_));
}


void Foam::fsbi::coupledSystem::setNullSpace(const label nBodies)
{
    petscVector constant;
    petscCheck(VecDuplicate(unknown_, constant.create()));
    PetscScalar* values;
    VecGetArray(constant, &values);
    std::fill_n(values, 4*mesh_.nCells(), PetscScalar(0));
    if (Pstream::master())
    {
        std::fill_n(values + 4*mesh_.nCells(), 6*nBodies, PetscScalar(0));
    }
    for (label i = 0; i < mesh_.nCells(); ++i)
    {
        values[4*i + 3] = 1;
    }
    VecRestoreArray(constant, &values);
    petscCheck(VecNormalize(constant, nullptr));

    petscNullSpace space;
    Vec held = constant;
    petscCheck
    (
        MatNullSpaceCreate
        (
            PETSC_COMM_WORLD, PETSC_FALSE, 1, &held, space.create()
        )
    );
    petscCheck(MatSetNullSpace(operator_, space));
}


Foam::List<Foam::fsbi::sixVector>
Foam::fsbi::coupledSystem::readBodies(const scalar* x) const
{
    List<sixVector> v(bodies_->size());
    forAll(v, b)
    {
        if (Pstream::master())
        {
            std::copy_n(x + 4*mesh_.nCells() + 6*b, 6, v[b].begin());
        }
        MPI_Bcast(v[b].data(), 6, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
    }
    return v;
}


void Foam::fsbi::coupledSystem::writeBodies
(
    const UList<sixVector>& v,
    scalar* x
) const
{
    for (label b = 0; Pstream::master() && b < v.size(); ++b)
    {
        std::copy_n(v[b].begin(), 6, x + 4*mesh_.nCells() + 6*b);
    }
}


void Foam::fsbi::coupledSystem::residual
(
    const scalar* x,
    scalar* r,
    const bool homogeneous
) const
{
    if (homogeneous)
    {
        values_.faces = Zero;
        values_.vertices = Zero;
    }
    else
    {
        values_.faces = given_->faces;
        values_.vertices = given_->vertices;
    }
    const List<sixVector> v(readBodies(x));
    setBodyVelocities(stokes_, *bodies_, v, values_);

    stokes_.residual(x, values_, r, traction_);
    if (!homogeneous)
    {
        forAll(*force_, i)
        {
            for (label k = 0; k < 3; ++k)
            {
                r[4*i + k] -= (*force_)[i][k];
            }
        }
    }
    scales_.apply(r);

    List<sixVector> bodyR
    (
        bodyDefects
        (
            *bodies_, v, bodyLoads(mesh_, *bodies_, traction_), homogeneous
        )
    );
    forAll(bodyR, b)
    {
        forAll(bodyR[b], k)
        {
            bodyR[b][k] *= -scales_.bodies()[b][k];
        }
    }
    writeBodies(bodyR, r);
}


PetscErrorCode Foam::fsbi::coupledSystem::multiply(Mat A, Vec in, Vec out)
{
    void* context;
    MatShellGetContext(A, &context);
    const PetscScalar* x;
    PetscScalar* y;
    VecGetArrayRead(in, &x);
    VecGetArray(out, &y);
    static_cast<coupledSystem*>(context)->residual(x, y, true);
    VecRestoreArray(out, &y);
    VecRestoreArrayRead(in, &x);
    return 0;
}


PetscErrorCode Foam::fsbi::coupledSystem::applyPreconditioner
(
    PC pc, Vec in, Vec out
)
{
    void* context;
    PCShellGetContext(pc, &context);
    const PetscScalar* r;
    PetscScalar* z;
    VecGetArrayRead(in, &r);
    VecGetArray(out, &z);
    static_cast<coupledSystem*>(context)->precondition(r, z);
    VecRestoreArray(out, &z);
    VecRestoreArrayRead(in, &r);
    return 0;
}


void Foam::fsbi::coupledSystem::precondition
(
    const scalar* r,
    scalar* z
) const
{
    // bodies' rows are scaled by the inverse of a crude diagonal: only torques,
    // which stand as velocities at the surface, change
    scales_.undo(r, state_.begin());
    List<sixVector> v(readBodies(r));
    forAll(v, b)
    {
        for (label k = 3; k < 6; ++k)
        {
            v[b][k] /= (*bodies_)[b].radius;
        }
    }
    values_.faces = Zero;
    values_.vertices = Zero;
    setBodyVelocities(stokes_, *bodies_, v, values_);
    forAll(v, b)
    {
        for (const label i : (*bodies_)[b].faces)
        {
            const label facei = mesh_.nInternalFaces() + i;
            const scalar k = preconditioner_.wallCoeff(i);
            const vector& u = values_.faces[i];
            scalar* row = state_.begin() + 4*mesh_.faceOwner()[facei];
            row[0] += k*u.x();
            row[1] += k*u.y();
            row[2] += k*u.z();
            row[3] -= u & mesh_.faceAreas()[facei];
        }
    }

    preconditioner_.apply(state_.cdata(), z);
    writeBodies(v, z);
}


Foam::fsbi::solverReport Foam::fsbi::coupledSystem::solve
(
    const boundaryValues& given,
    const vectorField& force,
    UList<bodyRows>& bodies,
    scalarList& x,
    vectorField& traction
)
{
    const label n = mesh_.nCells();
    given_ = &given;
    force_ = &force;
    bodies_ = &bodies;
    values_ = given;
    scales_ = rowScales(stokes_, bodies);
    state_.setSize(4*n);
    result_.setSize(4*n + (Pstream::master() ? 6*bodies.size() : 0));
    if (!krylov_)
    {
        createKrylov(bodies.size());
    }
    if (!freshIterations_)
    {
        preconditioner_.rebuild();
    }

    // right-hand side: minus the residual at rest
    PetscScalar* rhs;
    result_ = Zero;
    VecGetArray(rhs_, &rhs);
    residual(result_.cdata(), rhs, false);
    VecRestoreArray(rhs_, &rhs);
    petscCheck(VecScale(rhs_, -1));

    List<sixVector> v(bodies.size());
    forAll(v, b)
    {
        v[b] = bodies[b].velocity;
    }
    PetscScalar* values;
    VecGetArray(unknown_, &values);
    std::copy_n(x.begin(), 4*n, values);
    writeBodies(v, values);
    VecRestoreArray(unknown_, &values);

    petscCheck(KSPSolve(krylov_, rhs_, unknown_));

    solverReport report;
    PetscInt iterations;
    PetscReal norm, rhsNorm;
    KSPConvergedReason reason;
    KSPGetIterationNumber(krylov_, &iterations);
    KSPGetResidualNorm(krylov_, &norm);
    KSPGetConvergedReason(krylov_, &reason);
    VecNorm(rhs_, NORM_2, &rhsNorm);
    report.iterations = iterations;
    report.residual = norm/max(rhsNorm, VSMALL);
    report.converged = reason > 0;

    VecGetArray(unknown_, &values);
    residual(values, result_.data(), false);
    v = readBodies(values);
    std::copy_n(values, 4*n, x.begin());
    VecRestoreArray(unknown_, &values);
    forAll(v, b)
    {
        bodies[b].velocity = v[b];
    }
    traction = traction_;

    if (!freshIterations_)
    {
        freshIterations_ = max(report.iterations, 1);
    }
    else if (report.iterations > renewAbove*freshIterations_)
    {
        freshIterations_ = 0;           // the next solution builds a new one
    }
    return report;
}
