/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplacianMotion.H"
#include "compactEntries.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "globalIndex.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

static const PetscReal tolerance = 1e-10;

//- The master may work alone
static MPI_Comm communicator()
{
    return Pstream::parRun() ? PETSC_COMM_WORLD : PETSC_COMM_SELF;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::laplacianMotion::laplacianMotion(const polyMesh& mesh)
:
    mesh_(mesh)
{
    const untrapped scope;
    number();
    createMatrix();
    createSolver();
}


void Foam::fsbi::laplacianMotion::number()
{
    boolList given(mesh_.nPoints(), false);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(patch))
        {
            UIndirectList<bool>(given, patch.meshPoints()) = true;
        }
    }
    syncTools::syncPointList(mesh_, given, orEqOp<bool>(), false);

    bitSet inside(syncTools::getMasterPoints(mesh_));
    inside.unset(bitSet(given));
    owned_ = inside.toc();
    const globalIndex global(owned_.size());
    row_ = labelList(mesh_.nPoints(), -1);
    forAll(owned_, i)
    {
        row_[owned_[i]] = global.toGlobal(i);
    }
    syncTools::syncPointList(mesh_, row_, maxEqOp<label>(), label(-1));
}


template<class Action>
void Foam::fsbi::laplacianMotion::eachPair
(
    const label celli, const Action& add
) const
{
    const labelList& points = mesh_.cellPoints()[celli];
    const label n = points.size();
    const scalar V = mesh_.cellVolumes()[celli];

    // V times the gradient's vectors: the mean over a face is that of its
    // vertices
    vectorField B(n, Zero);
    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
        for (const label p : f)
        {
            B[points.find(p)] += sign/f.size()*mesh_.faceAreas()[facei];
        }
    }
    const scalar spring = n > 4 ? cbrt(V) : 0;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            const scalar k = (B[i] & B[j])/V + spring*((i == j) - 1.0/n);
            add(points[i], points[j], k/V);
        }
    }
}


void Foam::fsbi::laplacianMotion::createMatrix()
{
    compactEntries entries;
    forAll(mesh_.cells(), celli)
    {
        eachPair
        (
            celli,
            [&](const label i, const label j, const scalar k)
            {
                if (row_[i] >= 0 && row_[j] >= 0)
                {
                    entries.add(row_[i], row_[j], k);
                }
                else if (row_[i] >= 0)
                {
                    couplings_.append(coupling{i, j, k});
                }
            }
        );
    }
    entries.create
    (
        communicator(), owned_.size(), matrix_, solution_, source_
    );
    entries.fill(matrix_);
}


void Foam::fsbi::laplacianMotion::createSolver()
{
    PC pc;
    petscCheck(KSPCreate(communicator(), solver_.create()));
    petscCheck(KSPSetType(solver_, KSPCG));
    petscCheck(KSPGetPC(solver_, &pc));
    petscCheck(PCSetType(pc, PCGAMG));
    petscCheck(KSPSetOptionsPrefix(solver_, "fsbiMotion_"));
    petscCheck
    (
        KSPSetTolerances
        (
            solver_, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT
        )
    );
    petscCheck(KSPSetErrorIfNotConverged(solver_, PETSC_TRUE));
    petscCheck(KSPSetFromOptions(solver_));
    petscCheck(KSPSetOperators(solver_, matrix_, matrix_));
    petscCheck(KSPSetUp(solver_));
}


void Foam::fsbi::laplacianMotion::fill(vectorField& r) const
{
    const untrapped scope;
    vectorField source(mesh_.nPoints(), Zero);
    for (const coupling& c : couplings_)
    {
        source[c.inside] -= c.stiffness*r[c.given];
    }
    syncTools::syncPointList
    (
        mesh_, source, plusEqOp<vector>(), vector::zero
    );

    scalarList x(3*owned_.size());
    forAll(owned_, i)
    {
        std::copy_n(source[owned_[i]].v_, 3, x.begin() + 3*i);
    }
    for (label k = 0; k < 3; ++k)
    {
        solveComponent(solver_, source_, solution_, 3, x.begin() + k);
    }

    forAll(r, p)
    {
        if (row_[p] >= 0)
        {
            r[p] = Zero;
        }
    }
    forAll(owned_, i)
    {
        std::copy_n(x.begin() + 3*i, 3, r[owned_[i]].v_);
    }
    syncTools::syncPointList
    (
        mesh_, r, maxMagSqrEqOp<vector>(), vector::zero
    );
}
