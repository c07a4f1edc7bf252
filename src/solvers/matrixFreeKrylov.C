/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "matrixFreeKrylov.H"

Foam::fsbi::matrixFreeKrylov::matrixFreeKrylov
(
    const label size,
    const char* prefix,
    const label restart,
    const bool flexible,
    const function& multiplied,
    const function& preconditioned
)
:
    multiply_(multiplied),
    precondition_(preconditioned)
{
    const PetscInt n = size;
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
    petscCheck(KSPSetType(krylov_, flexible ? KSPFGMRES : KSPGMRES));
    petscCheck(KSPSetPCSide(krylov_, PC_RIGHT));
    petscCheck(KSPGMRESSetRestart(krylov_, restart));
    petscCheck(KSPGetPC(krylov_, &pc));
    petscCheck(PCSetType(pc, PCSHELL));
    petscCheck(PCShellSetContext(pc, this));
    petscCheck(PCShellSetApply(pc, precondition));
    petscCheck(KSPSetOptionsPrefix(krylov_, prefix));
    petscCheck(KSPSetFromOptions(krylov_));
}


void Foam::fsbi::matrixFreeKrylov::apply(const function& f, Vec in, Vec out)
{
    const PetscScalar* x;
    PetscScalar* y;
    VecGetArrayRead(in, &x);
    VecGetArray(out, &y);
    f(x, y);
    VecRestoreArray(out, &y);
    VecRestoreArrayRead(in, &x);
}


PetscErrorCode Foam::fsbi::matrixFreeKrylov::multiply(Mat A, Vec in, Vec out)
{
    void* context;
    MatShellGetContext(A, &context);
    apply(static_cast<matrixFreeKrylov*>(context)->multiply_, in, out);
    return 0;
}


PetscErrorCode Foam::fsbi::matrixFreeKrylov::precondition
(
    PC pc, Vec in, Vec out
)
{
    void* context;
    PCShellGetContext(pc, &context);
    apply(static_cast<matrixFreeKrylov*>(context)->precondition_, in, out);
    return 0;
}


void Foam::fsbi::matrixFreeKrylov::setNullVector
(
    const std::function<void(scalar*)>& fill
)
{
    petscVector constant;
    petscCheck(VecDuplicate(unknown_, constant.create()));
    PetscScalar* values;
    VecGetArray(constant, &values);
    fill(values);
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


Foam::fsbi::matrixFreeKrylov::outcome Foam::fsbi::matrixFreeKrylov::solve
(
    const scalar* rhs,
    scalar* x,
    const scalar tolerance,
    const label maxIterations
)
{
    PetscInt n;
    PetscScalar* values;
    VecGetLocalSize(rhs_, &n);
    VecGetArray(rhs_, &values);
    std::copy_n(rhs, n, values);
    VecRestoreArray(rhs_, &values);
    PetscReal rhsNorm;
    VecNorm(rhs_, NORM_2, &rhsNorm);
    if (rhsNorm < VSMALL)
    {
        std::fill_n(x, n, 0);
        return {0, 0, true};
    }
    petscCheck
    (
        KSPSetTolerances
        (
            krylov_, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, maxIterations
        )
    );
    petscCheck(KSPSolve(krylov_, rhs_, unknown_));

    VecGetArray(unknown_, &values);
    std::copy_n(values, n, x);
    VecRestoreArray(unknown_, &values);

    PetscInt iterations;
    PetscReal norm;
    KSPConvergedReason reason;
    KSPGetIterationNumber(krylov_, &iterations);
    KSPGetResidualNorm(krylov_, &norm);
    KSPGetConvergedReason(krylov_, &reason);
    return {label(iterations), norm/rhsNorm, reason > 0};
}
