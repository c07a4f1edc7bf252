/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesPreconditioner.H"
#include "globalIndex.H"

Foam::fsbi::stokesPreconditioner::stokesPreconditioner
(
    const fvMesh& mesh,
    const stokesOperator& stokes
)
:
    mesh_(mesh),
    stokes_(stokes),
    pressure_(mesh.nCells() + stokes.stencil().halo().size())
{
    createMatrix();
}


void Foam::fsbi::stokesPreconditioner::createMatrix()
{
    const meshStencil& stencil = stokes_.stencil();
    const globalIndex global(mesh_.nCells());

    scalarList cell(pressure_.size());
    for (label i = 0; i < mesh_.nCells(); ++i)
    {
        cell[i] = global.toGlobal(i);
    }
    stencil.halo().fill(cell.data(), 1);

    // one row entry a cell, then two or four a face, as setMatrix() fills them
    DynamicList<PetscInt> rows, columns;
    const auto add = [&](const label row, const label column)
    {
        rows.append(PetscInt(cell[row]));
        columns.append(PetscInt(cell[column]));
    };
    for (label i = 0; i < mesh_.nCells(); ++i)
    {
        add(i, i);
    }
    forAll(stencil.owner(), i)
    {
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        add(P, N);
        if (N < mesh_.nCells())
        {
            add(N, P);
        }
    }

    const PetscInt n = mesh_.nCells();
    petscCheck(MatCreate(PETSC_COMM_WORLD, matrix_.create()));
    petscCheck(MatSetSizes(matrix_, n, n, PETSC_DETERMINE, PETSC_DETERMINE));
    petscCheck(MatSetType(matrix_, MATAIJ));
    petscCheck
    (
        MatSetPreallocationCOO
        (
            matrix_, rows.size(), rows.data(), columns.data()
        )
    );
    petscCheck(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    petscCheck(MatCreateVecs(matrix_, solution_.create(), source_.create()));
}


Foam::scalar Foam::fsbi::stokesPreconditioner::wallCoeff(const label i) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const label P = mesh_.faceOwner()[facei];
    const vector& S = mesh_.faceAreas()[facei];
    const vector db(mesh_.faceCentres()[facei] - mesh_.cellCentres()[P]);
    return stokes_.mu()*magSqr(S)/(S & db);
}


void Foam::fsbi::stokesPreconditioner::setMatrix()
{
    const meshStencil& stencil = stokes_.stencil();
    DynamicList<PetscScalar> entries(mesh_.nCells() + 2*stencil.owner().size());
    entries.setSize(mesh_.nCells(), 0);

    forAll(stencil.owner(), i)
    {
        const faceGradient face
        (
            stencil.area()[i], stencil.fromOwner()[i],
            stencil.fromNeighbour()[i]
        );
        const scalar k = stokes_.mu()*face.compact();
        const label N = stencil.neighbour()[i];
        entries[stencil.owner()[i]] += k;
        entries.append(-k);
        if (N < mesh_.nCells())
        {
            entries[N] += k;
            entries.append(-k);
        }
    }
    forAll(stokes_.velocityGiven(), i)
    {
        if (stokes_.velocityGiven()[i])
        {
            const label facei = mesh_.nInternalFaces() + i;
            entries[mesh_.faceOwner()[facei]] += wallCoeff(i);
        }
    }
    petscCheck(MatSetValuesCOO(matrix_, entries.data(), INSERT_VALUES));
}


void Foam::fsbi::stokesPreconditioner::rebuild()
{
    setMatrix();
    PC pc;
    petscCheck(KSPCreate(PETSC_COMM_WORLD, cycle_.create()));
    petscCheck(KSPSetType(cycle_, KSPPREONLY));
    petscCheck(KSPGetPC(cycle_, &pc));
    petscCheck(PCSetType(pc, PCGAMG));
    petscCheck(KSPSetOptionsPrefix(cycle_, "fsbi_"));
    petscCheck(KSPSetFromOptions(cycle_));
    petscCheck(KSPSetOperators(cycle_, matrix_, matrix_));
    petscCheck(KSPSetUp(cycle_));
}


void Foam::fsbi::stokesPreconditioner::apply
(
    const scalar* r,
    scalar* z
) const
{
    const label n = mesh_.nCells();
    const meshStencil& stencil = stokes_.stencil();
    const scalarField& V = mesh_.cellVolumes();

    for (label i = 0; i < n; ++i)
    {
        pressure_[i] = stokes_.mu()/V[i]*r[4*i + 3];
    }
    stencil.halo().fill(pressure_.data(), 1);

    // r_u - G z_p, gathered in z
    std::copy_n(r, 4*n, z);
    forAll(stencil.owner(), i)
    {
        const vector& S = stencil.area()[i];
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        const vector force(0.5*(pressure_[P] + pressure_[N])*S);
        z[4*P] -= force.x();
        z[4*P + 1] -= force.y();
        z[4*P + 2] -= force.z();
        if (N < n)
        {
            z[4*N] += force.x();
            z[4*N + 1] += force.y();
            z[4*N + 2] += force.z();
        }
    }
    forAll(stokes_.velocityGiven(), i)
    {
        if (stokes_.velocityGiven()[i])
        {
            const label facei = mesh_.nInternalFaces() + i;
            const label P = mesh_.faceOwner()[facei];
            const vector force(pressure_[P]*mesh_.faceAreas()[facei]);
            z[4*P] -= force.x();
            z[4*P + 1] -= force.y();
            z[4*P + 2] -= force.z();
        }
    }

    for (label k = 0; k < 3; ++k)
    {
        solveComponent(cycle_, source_, solution_, 4, z + k);
    }
    for (label i = 0; i < n; ++i)
    {
        z[4*i + 3] = pressure_[i];
    }
}
