/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexElasticity.H"
#include "sharedVertices.H"
#include "globalIndex.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Stiffness of supports over that of the material
static const scalar supportStiffness = 100;

//- Couplings that the coarsening ignores, over those of the diagonal
static PetscReal weakBelow = 0.03;

//- Bodies that are so many vertices long and need at most so many operations of
//  3 x 3 blocks for a factor have a cheaper factor than the cycles it saves: on
//  rods and plates a quarter to three quarters of the seconds, on cubes none. By
//  order 4, seconds by cycles and by a factor: a plate of 9e7 operations 47 and
//  7.5, a rod of 4e7 20 and 16, a box of 1.3e8, 32 x 16 x 8 cells, 5.2 and 6.9; on
//  hexahedra a rod of 3.4e7 4.0 and 5.8. Memory: the same within a tenth
static const label slender = 20;
static const scalar fewOperations = 2e7;

//- Lame's lambda over mu where the operator has a pressure of its own
static const scalar mixedLambda = 2;


//- Of steps from a vertex to the farthest one, to neighbours, from one at an end
static label nLevels(const UList<DynamicList<label>>& beside)
{
    label first = 0, count = 0;
    for (label sweep = 0; sweep < 2 && beside.size(); ++sweep)
    {
        labelList level(beside.size(), -1);
        DynamicList<label> queue(beside.size());
        queue.append(first);
        level[first] = 0;
        for (label i = 0; i < queue.size(); ++i)
        {
            for (const label v : beside[queue[i]])
            {
                if (level[v] < 0)
                {
                    level[v] = level[queue[i]] + 1;
                    queue.append(v);
                }
            }
        }
        first = queue.last();
        count = level[first];
    }
    return count;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::vertexElasticity::vertexElasticity
(
    const fvMesh& mesh,
    const elasticOperator& elastic
)
:
    mesh_(mesh),
    elastic_(elastic),
    vertices_(mesh.nPoints(), Zero)
{
    setNumbers();
}


void Foam::fsbi::vertexElasticity::setNumbers()
{
    owned_ = syncTools::getMasterPoints(mesh_).toc();
    const globalIndex global(owned_.size());
    global_ = labelList(mesh_.nPoints(), -1);
    forAll(owned_, i)
    {
        global_[owned_[i]] = global.toGlobal(i);
    }
    syncTools::syncPointList(mesh_, global_, maxEqOp<label>(), label(-1));
}


void Foam::fsbi::vertexElasticity::createMatrix()
{
    // vertices of the cells around a vertex; those of other processors are
    // not known here, but are fewer than all
    List<DynamicList<label>> beside(mesh_.nPoints());
    for (const labelList& points : mesh_.cellPoints())
    {
        for (const label v : points)
        {
            beside[v].append(points);
        }
    }
    scalarField nBeside(mesh_.nPoints());
    forAll(beside, v)
    {
        labelList& list = beside[v];
        Foam::sort(list);
        nBeside[v] = std::unique(list.begin(), list.end()) - list.begin();
        beside[v].setSize(label(nBeside[v]));
    }
    const scalar n = beside.size(), levels = nLevels(beside);
    direct_ =
        !Pstream::parRun()
     && levels >= slender
     && n*sqr(n/levels) < fewOperations*elastic_.factorWorth();
    sharedVertices::sum<1>
    (
        mesh_, nBeside.begin(), elastic_.stencil().halo().size()
    );

    List<PetscInt> diagonal(owned_.size()), off(owned_.size(), 0);
    forAll(owned_, i)
    {
        const PetscInt n = nBeside[owned_[i]];
        diagonal[i] = min(n, PetscInt(owned_.size()));
        off[i] = Pstream::parRun() ? n : 0;
    }
    const PetscInt nRows = 3*owned_.size();
    petscCheck(MatCreate(PETSC_COMM_WORLD, matrix_.create()));
    petscCheck
    (
        MatSetSizes(matrix_, nRows, nRows, PETSC_DETERMINE, PETSC_DETERMINE)
    );
    petscCheck(MatSetType(matrix_, MATAIJ));
    petscCheck(MatSetBlockSize(matrix_, 3));
    petscCheck
    (
        MatXAIJSetPreallocation
        (
            matrix_, 3, diagonal.cdata(), off.cdata(), nullptr, nullptr
        )
    );
    petscCheck
    (
        MatSetOption(matrix_, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE)
    );
    petscCheck(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    petscCheck(MatCreateVecs(matrix_, solution_.create(), source_.create()));
    setRigidMotions();
}


void Foam::fsbi::vertexElasticity::setRigidMotions()
{
    petscVector places;
    petscCheck(VecDuplicate(solution_, places.create()));
    petscCheck(VecSetBlockSize(places, 3));
    PetscScalar* x;
    VecGetArray(places, &x);
    forAll(owned_, i)
    {
        std::copy_n(mesh_.points()[owned_[i]].v_, 3, x + 3*i);
    }
    VecRestoreArray(places, &x);
    petscCheck(MatNullSpaceCreateRigidBody(places, rigid_.create()));
    petscCheck(MatSetNearNullSpace(matrix_, rigid_));
}


void Foam::fsbi::vertexElasticity::createCycle()
{
    PC pc;
    petscCheck(KSPCreate(PETSC_COMM_WORLD, cycle_.create()));
    petscCheck(KSPSetType(cycle_, KSPPREONLY));
    petscCheck(KSPGetPC(cycle_, &pc));
    if (direct_)
    {
        petscCheck(PCSetType(pc, PCCHOLESKY));
        petscCheck(PCFactorSetMatOrderingType(pc, MATORDERINGND));
        petscCheck(PCFactorSetShiftType(pc, MAT_SHIFT_NONZERO));
    }
    else
    {
        petscCheck(PCSetType(pc, PCGAMG));
        petscCheck(PCGAMGSetThreshold(pc, &weakBelow, 1));
    }
    petscCheck(KSPSetOptionsPrefix(cycle_, "fsbiSolid_"));
    petscCheck(KSPSetFromOptions(cycle_));
    petscCheck(KSPSetOperators(cycle_, matrix_, matrix_));
    petscCheck(KSPSetUp(cycle_));
}


Foam::vectorField Foam::fsbi::vertexElasticity::gradientVectors
(
    const label celli
) const
{
    const labelList& points = mesh_.cellPoints()[celli];
    vectorField B(points.size(), Zero);
    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
        const vector share
        (
            sign*mesh_.faceAreas()[facei]/(f.size()*mesh_.cellVolumes()[celli])
        );
        for (const label v : f)
        {
            B[points.find(v)] += share;
        }
    }
    tensor linear(Zero);
    forAll(points, i)
    {
        linear += B[i]*(mesh_.points()[points[i]] - mesh_.cellCentres()[celli]);
    }
    const tensor correction(inv(linear));
    for (vector& b : B)
    {
        b = correction & b;
    }
    return B;
}


void Foam::fsbi::vertexElasticity::setGhostWeights()
{
    const elasticStencil& stencil = elastic_.stencil();
    ghostWeights_.setSize(stencil.nGhosts());
    forAll(ghostWeights_, g)
    {
        const label i = stencil.firstBoundary() + g;
        const vectorField B(gradientVectors(stencil.owner()[i]));
        ghostWeights_[g] = scalarList(1.0/B.size() + (B & stencil.delta()[i]));
    }
}


Foam::tensor Foam::fsbi::vertexElasticity::tangent
(
    const solidMaterial& law, const tensor& F, const tensor& dF
) const
{
    if (!elastic_.state().mixed())
    {
        return law.tangent(F, dF);
    }
    const tensor Q(law.thetaGradient(F));
    return law.shearTangent(F, dF) + mixedLambda*law.mu()*(Q && dF)*Q;
}


Foam::scalarSquareMatrix Foam::fsbi::vertexElasticity::penalty
(
    const label celli, const vectorField& B
) const
{
    const labelList& points = mesh_.cellPoints()[celli];
    const label n = points.size();
    vector middle(Zero);
    for (const label v : points)
    {
        middle += mesh_.points()[v]/n;
    }
    scalarSquareMatrix rest(n);
    for (label i = 0; i < n; ++i)
    {
        const vector d(mesh_.points()[points[i]] - middle);
        for (label j = 0; j < n; ++j)
        {
            rest(i, j) = (i == j) - 1.0/n - (d & B[j]);
        }
    }
    return
        elastic_.parts().law(celli).mu()*cbrt(mesh_.cellVolumes()[celli])
       *scalarSquareMatrix(rest.T()*rest);
}


void Foam::fsbi::vertexElasticity::addCell(const label celli)
{
    const labelList& points = mesh_.cellPoints()[celli];
    const label n = points.size();
    const scalar V = mesh_.cellVolumes()[celli];
    const vectorField B(gradientVectors(celli));
    const scalarSquareMatrix extra(penalty(celli, B));

    const tensor F
    (
        elastic_.stencil().cellMean(celli, elastic_.state().deformation())
    );
    const solidMaterial& law = elastic_.parts().law(celli);
    rows_.setSize(n);
    entries_.setSize(9*n*n);
    forAll(points, i)
    {
        rows_[i] = global_[points[i]];
    }
    for (label j = 0; j < n; ++j)
    {
        for (direction l = 0; l < 3; ++l)
        {
            tensor dF(Zero);
            dF(l, 0) = B[j].x();
            dF(l, 1) = B[j].y();
            dF(l, 2) = B[j].z();
            const tensor dP(V*tangent(law, F, dF));
            for (label i = 0; i < n; ++i)
            {
                const vector force(dP & B[i]);
                PetscScalar* entry = entries_.data() + 9*n*i + 3*j + l;
                for (direction k = 0; k < 3; ++k)
                {
                    entry[3*n*k] = force[k] + (k == l ? extra(i, j) : 0);
                }
            }
        }
    }
    petscCheck
    (
        MatSetValuesBlocked
        (
            matrix_, n, rows_.cdata(), n, rows_.cdata(), entries_.cdata(),
            ADD_VALUES
        )
    );
}


void Foam::fsbi::vertexElasticity::addSupports()
{
    const elasticStencil& stencil = elastic_.stencil();
    for (label g = 0; g < stencil.nGhosts(); ++g)
    {
        const auto kind = elastic_.boundary().kindOf(g);
        if (kind == solidBoundary::traction)
        {
            continue;
        }
        const label i = stencil.firstBoundary() + g;
        const vector n(normalised(stencil.area()[i]));
        const face& f = mesh_.faces()[stencil.face()[i]];
        const tensor stiff
        (
            supportStiffness*elastic_.state().stiffness()
           *stencil.compact()[i]/f.size()
           *(kind == solidBoundary::symmetry ? n*n : tensor::I)
        );
        for (const label v : f)
        {
            const PetscInt row = global_[v];
            petscCheck
            (
                MatSetValuesBlocked
                (
                    matrix_, 1, &row, 1, &row, stiff.v_, ADD_VALUES
                )
            );
        }
    }
}


void Foam::fsbi::vertexElasticity::rebuild(const scalarField& mass)
{
    if (!matrix_)
    {
        createMatrix();
    }
    petscCheck(MatZeroEntries(matrix_));
    setGhostWeights();
    addSupports();
    forAll(mesh_.cells(), celli)
    {
        addCell(celli);
        const labelList& points = mesh_.cellPoints()[celli];
        const tensor m(mass[celli]/points.size()*tensor::I);
        for (const label v : points)
        {
            const PetscInt row = global_[v];
            if (mass[celli] > 0)
            {
                MatSetValuesBlocked(matrix_, 1, &row, 1, &row, m.v_, ADD_VALUES);
            }
        }
    }
    petscCheck(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    petscCheck(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    createCycle();
}


void Foam::fsbi::vertexElasticity::addCorrection
(
    const vectorField& f, vectorField& u, UList<vector> joints
) const
{
    const label nHalo = elastic_.stencil().halo().size();
    vertices_ = Zero;
    forAll(f, celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        const vector share(f[celli]/points.size());
        for (const label v : points)
        {
            vertices_[v] += share;
        }
    }
    sharedVertices::sum<3>(mesh_, vertices_.begin()->v_, nHalo);

    PetscScalar* source;
    VecGetArray(source_, &source);
    forAll(owned_, i)
    {
        std::copy_n(vertices_[owned_[i]].v_, 3, source + 3*i);
    }
    VecRestoreArray(source_, &source);
    petscCheck(KSPSolve(cycle_, source_, solution_));

    vertices_ = Zero;
    const PetscScalar* result;
    VecGetArrayRead(solution_, &result);
    forAll(owned_, i)
    {
        std::copy_n(result + 3*i, 3, vertices_[owned_[i]].v_);
    }
    VecRestoreArrayRead(solution_, &result);
    sharedVertices::sum<3>(mesh_, vertices_.begin()->v_, nHalo);

    forAll(f, celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        vector sum(Zero);
        for (const label v : points)
        {
            sum += vertices_[v];
        }
        u[celli] += sum/points.size();
    }
    const elasticStencil& stencil = elastic_.stencil();
    forAll(ghostWeights_, g)
    {
        const label P = stencil.owner()[stencil.firstBoundary() + g];
        const labelList& points = mesh_.cellPoints()[P];
        forAll(points, i)
        {
            u[f.size() + g] += ghostWeights_[g][i]*vertices_[points[i]];
        }
    }
    addToJoints(joints);
}


void Foam::fsbi::vertexElasticity::addToJoints(UList<vector>& joints) const
{
    const partJoints& all = elastic_.stencil().joints();
    forAll(joints, i)
    {
        const face& f = mesh_.faces()[all.faces()[all.owned()[i]]];
        for (const label v : f)
        {
            joints[i] += vertices_[v]/f.size();
        }
    }
}
