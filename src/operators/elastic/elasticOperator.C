/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticOperator.H"
#include "asVectors.H"
#include "sharedVertices.H"
#include "syncTools.H"

const Foam::Enum<Foam::fsbi::elasticOperator::formulation>
Foam::fsbi::elasticOperator::formulationNames
({
    { formulation::totalLagrangian, "totalLagrangian" },
    { formulation::updatedLagrangian, "updatedLagrangian" },
    { formulation::slowProcess, "slowProcess" },
    { formulation::slowProcessTotalStrain, "slowProcessTotalStrain" }
});

namespace Foam
{
namespace fsbi
{

//- Of what vertices do not explain, over mu. Near 2/3 the error of bending
//  that falls with the square of the cells' size is gone and beams are a
//  little soft, of third order; larger values make them stiff, but the stress
//  better. In flexure, 8 and 16 cells across, orders of displacement and stress
//  are 3.6, 1.9496 with 0.7; 5.4, 1.951 with 0.72; 0.9, 1.954 with 0.75, where
//  both errors cancel on coarse cells. Below 0.5 it is not stable
static const scalar stabilisation = 0.72;

//- Growth of the stabilisation with the strain: compression of the order of
//  mu would buckle what it holds. None at small strain
static const scalar strainStabilisation = 4;

//- Viscous over elastic stiffness that the stabilisation, which is elastic,
//  still holds
static const scalar mostViscous = 50;

//- Smoothing of the pressure: larger is smoother, and less local
static const scalar smoothingScale = 1;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::elasticOperator::elasticOperator
(
    const fvMesh& mesh,
    const solidMaterial& material,
    const List<solidBoundary::kind>& kinds,
    const formulation form,
    const bool mixed
)
:
    mesh_(mesh),
    material_(material),
    formulation_(form),
    mixed_(mixed),
    kinds_(kinds),
    stencil_(mesh, kinds),
    deltaT_(GREAT),
    referenceF_(mesh.nPoints(), tensor::I),
    oldF_(mesh.nPoints(), tensor::I),
    jumpHistory_(stencil_.nFaces(), Zero),
    values_(stencil_.nColumns(), Zero),
    gradient_(mesh.nPoints(), Zero),
    F_(mesh.nPoints(), tensor::I),
    pressure_(mixed ? mesh.nPoints() : 0, Zero),
    stress_(mesh.nPoints(), Zero),
    stiffening_(mesh.nPoints(), Zero),
    unexplained_(stencil_.nFaces(), Zero),
    boundaryForce_(nGhosts(), Zero),
    given_(nullptr),
    valid_(true),
    dValues_(stencil_.nColumns(), Zero),
    dGradient_(mesh.nPoints(), Zero),
    dPressure_(pressure_.size(), Zero),
    dStress_(mesh.nPoints(), Zero),
    dStiffening_(mesh.nPoints(), Zero),
    dBoundaryForce_(nGhosts(), Zero),
    vertexRow_(pressure_.size(), Zero)
{
    if (material.linear() && form != formulation::totalLagrangian)
    {
        FatalErrorInFunction
            << "A linear law holds for small displacements of the stress-free"
            << " body: region " << mesh.name() << " needs formulation"
            << " totalLagrangian, or StVenantKirchhoff instead of "
            << material.type() << exit(FatalError);
    }
    setOwnedVertices();
}


void Foam::fsbi::elasticOperator::setOwnedVertices()
{
    if (!mixed_)
    {
        return;
    }
    const bitSet master(syncTools::getMasterPoints(mesh_));
    ownedVertices_ = master.toc();
}


void Foam::fsbi::elasticOperator::update()
{
    stencil_.update();
}


void Foam::fsbi::elasticOperator::setStep(const scalar deltaT)
{
    deltaT_ = deltaT;
    const scalar least =
        material_.viscosity()/(mostViscous*material_.mu());
    if (deltaT < least)
    {
        FatalErrorInFunction
            << "A step of " << deltaT << " is too short for the viscosity of"
            << " region " << mesh_.name() << ", which needs " << least
            << " at least (viscosity over " << mostViscous << " mu): take"
            << " longer steps, or less viscosity" << exit(FatalError);
    }
}


Foam::scalar Foam::fsbi::elasticOperator::stiffness() const
{
    const scalar mu = material_.mu();
    return mixed_ ? 4*mu/3 : mu + (mu + material_.lambda())/3;
}


Foam::scalarList Foam::fsbi::elasticOperator::rowScale
(
    const scalarField& mass
) const
{
    const label nCells = mesh_.nCells();
    scalarField stiff(stencil_.nColumns(), Zero);
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const scalar k = stiffness()*stencil_.compact()[i];
        stiff[stencil_.owner()[i]] += k;
        stiff[stencil_.neighbour()[i]] += k;
    }
    scalarList scale(size(), scalar(1));
    for (label celli = 0; celli < nCells; ++celli)
    {
        std::fill_n
        (
            scale.begin() + 3*celli, 3, 1/(stiff[celli] + mass[celli])
        );
    }
    const label firstPressure = 3*(nCells + nGhosts());
    forAll(ownedVertices_, i)
    {
        const scalar V = stencil_.vertexVolume()[ownedVertices_[i]];
        scale[firstPressure + i] = cbrt(V)/V;
    }
    return scale;
}


void Foam::fsbi::elasticOperator::gather
(
    const scalar* x, vectorField& values
) const
{
    const label nCells = mesh_.nCells();
    const vector* given = asVectors(x);
    std::copy_n(given, nCells, values.begin());
    std::copy_n
    (
        given + nCells, nGhosts(), values.begin() + stencil_.firstGhost()
    );
    stencil_.halo().fill(values.begin()->v_, 3);
}


void Foam::fsbi::elasticOperator::setGradient
(
    const vectorField& values, tensorField& gradient
) const
{
    const label* start = stencil_.vertexStart().cdata();
    const label* column = stencil_.vertexColumn().cdata();
    const vector* weight = stencil_.gradientWeight().cdata();
    forAll(gradient, v)
    {
        tensor g(Zero);
        for (label j = start[v]; j < start[v + 1]; ++j)
        {
            g += values[column[j]]*weight[j];
        }
        gradient[v] = g;
    }
    sharedVertices::sum<9>
    (
        mesh_, gradient.begin()->v_, stencil_.halo().size()
    );
}


void Foam::fsbi::elasticOperator::setPressure
(
    const scalar* x, scalarField& pressure
) const
{
    if (!mixed_)
    {
        return;
    }
    const scalar* given = x + 3*(mesh_.nCells() + nGhosts());
    pressure = Zero;
    forAll(ownedVertices_, i)
    {
        pressure[ownedVertices_[i]] = given[i];
    }
    sharedVertices::sum<1>(mesh_, pressure.begin(), stencil_.halo().size());
}


Foam::tensor Foam::fsbi::elasticOperator::cellMean
(
    const label celli, const tensorField& vertices
) const
{
    const labelList& points = mesh_.cellPoints()[celli];
    tensor sum(Zero);
    for (const label v : points)
    {
        sum += vertices[v];
    }
    return sum/points.size();
}


Foam::vector Foam::fsbi::elasticOperator::unexplained
(
    const label i, const vectorField& values, const tensorField& gradient
) const
{
    return
        values[stencil_.neighbour()[i]] - values[stencil_.owner()[i]]
      - (faceMean(i, gradient) & (stencil_.delta()[i] - jumpHistory_[i]));
}


void Foam::fsbi::elasticOperator::setStiffening()
{
    forAll(F_, v)
    {
        const scalar q = mag(symm(F_[v].T() & F_[v]) - symmTensor::I);
        stiffening_[v] =
            material_.linear() ? 0 : strainStabilisation*sqr(q)/(1 + q);
    }
}


Foam::scalar Foam::fsbi::elasticOperator::stiffeningTangent
(
    const label v, const tensor& dF
) const
{
    if (material_.linear())
    {
        return 0;
    }
    const symmTensor strain(symm(F_[v].T() & F_[v]) - symmTensor::I);
    const scalar q = mag(strain);
    return
        strainStabilisation*(2 + q)/sqr(1 + q)
       *2*(strain && symm(F_[v].T() & dF));
}


void Foam::fsbi::elasticOperator::addFaces
(
    const tensorField& stress,
    const vectorField& held,
    vectorField& force,
    scalar* r
) const
{
    const label nCells = mesh_.nCells();
    const label firstBoundary = stencil_.firstBoundary();
    const scalar mu = material_.mu();
    vector* row = asVectors(r);

    forAll(stencil_.owner(), i)
    {
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const vector T
        (
            (faceMean(i, stress) & stencil_.area()[i])
          + mu*stencil_.compact()[i]*held[i]
        );
        if (i >= firstBoundary)
        {
            force[i - firstBoundary] = T;
            continue;
        }
        row[P] -= T;
        if (N < nCells)
        {
            row[N] += T;
        }
    }
}


void Foam::fsbi::elasticOperator::addPressures
(
    const scalarField& volume, const scalarField& pressure, scalar* r
) const
{
    vertexRow_ = Zero;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        scalar mean = 0;
        for (const label v : points)
        {
            mean += pressure[v]/points.size();
        }
        const scalar weight =
            smoothingScale*mesh_.cellVolumes()[celli]
           /(points.size()*material_.mu());
        for (const label v : points)
        {
            vertexRow_[v] += weight*(pressure[v] - mean);
        }
    }
    sharedVertices::sum<1>(mesh_, vertexRow_.begin(), stencil_.halo().size());

    scalar* row = r + 3*(mesh_.nCells() + nGhosts());
    forAll(ownedVertices_, i)
    {
        const label v = ownedVertices_[i];
        row[i] =
            vertexRow_[v]
          + stencil_.vertexVolume()[v]
           *(volume[v] + pressure[v]/material_.lambda());
    }
}


void Foam::fsbi::elasticOperator::residual
(
    const scalar* x, const solidBoundary& given, scalar* r
)
{
    given_ = &given;
    std::fill_n(r, size(), scalar(0));
    gather(x, values_);
    setGradient(values_, gradient_);
    setPressure(x, pressure_);
    setStress();
    setStiffening();
    vectorField held(stencil_.nFaces());
    forAll(held, i)
    {
        unexplained_[i] = jumpHistory_[i] + unexplained(i, values_, gradient_);
        held[i] =
            (stabilisation + faceMean(i, stiffening_))*unexplained_[i];
    }
    addFaces(stress_, held, boundaryForce_, r);

    vectorField atGhosts(nGhosts());
    forAll(atGhosts, g)
    {
        const label b = stencil_.ghostFaces()[g];
        atGhosts[g] =
            kinds_[b] == solidBoundary::displacement
          ? given.faces[b]
          : load(g);
    }
    addBoundary(values_, gradient_, boundaryForce_, atGhosts, r);
    forAll(atGhosts, g)
    {
        if (kinds_[stencil_.ghostFaces()[g]] == solidBoundary::traction)
        {
            boundaryForce_[g] = atGhosts[g];
        }
    }
    if (mixed_)
    {
        scalarField volume(F_.size());
        forAll(F_, v)
        {
            volume[v] = volumeChange(v);
        }
        addPressures(volume, pressure_, r);
    }
}


void Foam::fsbi::elasticOperator::applyJacobian(const scalar* dx, scalar* dr) const
{
    std::fill_n(dr, size(), scalar(0));
    gather(dx, dValues_);
    setGradient(dValues_, dGradient_);
    setPressure(dx, dPressure_);
    scalarField volume(dPressure_.size());
    forAll(dStress_, v)
    {
        const tensor& dH = dGradient_[v];
        dStress_[v] = meshTangent(v, dH, mixed_ ? dPressure_[v] : 0);
        dStiffening_[v] = stiffeningTangent(v, dH & referenceF_[v]);
        if (mixed_)
        {
            volume[v] = volumeTangent(v, dH);
        }
    }
    vectorField held(stencil_.nFaces());
    forAll(held, i)
    {
        held[i] =
            (stabilisation + faceMean(i, stiffening_))
           *unexplained(i, dValues_, dGradient_)
          + faceMean(i, dStiffening_)*unexplained_[i];
    }
    addFaces(dStress_, held, dBoundaryForce_, dr);

    vectorField atGhosts(nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        const label i = stencil_.firstBoundary() + g;
        if (kindAt(i) != solidBoundary::displacement)
        {
            atGhosts[g] = loadTangent(g, faceMean(i, dGradient_));
        }
    }
    addBoundary(dValues_, dGradient_, dBoundaryForce_, atGhosts, dr);
    if (mixed_)
    {
        addPressures(volume, dPressure_, dr);
    }
}


bool Foam::fsbi::elasticOperator::valid() const
{
    return returnReduce(valid_, andOp<bool>());
}


Foam::tmp<Foam::vectorField> Foam::fsbi::elasticOperator::atVertices
(
    const vectorField& values
) const
{
    auto result = tmp<vectorField>::New(mesh_.nPoints(), Zero);
    vectorField& u = result.ref();
    forAll(u, v)
    {
        for
        (
            label j = stencil_.vertexStart()[v];
            j < stencil_.vertexStart()[v + 1];
            ++j
        )
        {
            u[v] +=
                stencil_.valueWeight()[j]*values[stencil_.vertexColumn()[j]];
        }
    }
    sharedVertices::sum<3>(mesh_, u.begin()->v_, stencil_.halo().size());
    return result;
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::elasticOperator::vertexDisplacement() const
{
    return atVertices(values_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::elasticOperator::vertexIncrement() const
{
    return atVertices(dValues_);
}


void Foam::fsbi::elasticOperator::endStep()
{
    oldF_ = F_;
    if (formulation_ != formulation::totalLagrangian)
    {
        referenceF_ = F_;
        jumpHistory_ = unexplained_;
    }
}
