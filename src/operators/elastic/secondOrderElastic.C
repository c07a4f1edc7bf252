/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "secondOrderElastic.H"
#include "jointValues.H"
#include "sharedVertices.H"
#include "strainStiffening.H"

namespace Foam
{
namespace fsbi
{

//- Smoothing of the pressure: larger is smoother, and less local
static const scalar smoothingScale = 1;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::secondOrderElastic::secondOrderElastic
(
    const fvMesh& mesh,
    const materialParts& parts,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
:
    elasticOperator(mesh, parts, kinds, form, mixed),
    values_(stencil_.nColumns(), Zero),
    stiffening_(stencil_.vertices().size(), Zero),
    unexplained_(stencil_.nFaces(), Zero),
    unexplainedHalves_(stencil_.joints().halves().size(), Zero),
    given_(nullptr),
    dValues_(stencil_.nColumns(), Zero),
    dGradient_(stencil_.vertices().size(), Zero),
    dPressure_(mixed ? dGradient_.size() : 0, Zero),
    dStress_(dGradient_.size(), Zero),
    dStiffening_(dGradient_.size(), Zero),
    dBoundaryForce_(stencil_.nGhosts(), Zero),
    vertexRow_(dPressure_.size(), Zero)
{}


void Foam::fsbi::secondOrderElastic::gather
(
    const scalar* x, vectorField& values
) const
{
    const label nCells = mesh_.nCells();
    const vector* given = asVectors(x);
    std::copy_n(given, nCells, values.begin());
    std::copy_n
    (
        given + nCells, stencil_.nGhosts(), values.begin() + stencil_.firstGhost()
    );
    stencil_.halo().fill(values.begin()->v_, 3);
    if (stencil_.vertices().several())
    {
        const partJoints& joints = stencil_.joints();
        const vectorField all(jointValues(*this, x));
        forAll(joints.halves(), i)
        {
            const partJoints::half& h = joints.halves()[i];
            values[stencil_.firstHalf() + i] =
                2*all[h.joint] - values[h.cell];
        }
    }
}


void Foam::fsbi::secondOrderElastic::setGradient
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
    stencil_.vertices().sum<9>(gradient.begin()->v_);
}


void Foam::fsbi::secondOrderElastic::setPressure
(
    const scalar* x, scalarField& pressure
) const
{
    if (!mixed_)
    {
        return;
    }
    const scalar* given = x + 3*(mesh_.nCells() + stencil_.nGhosts());
    pressure = Zero;
    forAll(ownedVertices_, i)
    {
        pressure[ownedVertices_[i]] = given[i];
    }
    stencil_.vertices().sum<1>(pressure.begin());
}


Foam::vector Foam::fsbi::secondOrderElastic::unexplained
(
    const label i, const vectorField& values, const tensorField& gradient
) const
{
    const vector delta
    (
        material_.flows()
      ? stencil_.delta()[i] : stencil_.delta()[i] - jumpHistory_[i]
    );
    return
        values[stencil_.neighbour()[i]] - values[stencil_.owner()[i]]
      - (stencil_.faceMean(i, gradient) & delta);
}


void Foam::fsbi::secondOrderElastic::setStiffening()
{
    forAll(stiffening_, v)
    {
        stiffening_[v] =
            material_.linear() || material_.flows()
          ? 0
          : strainStiffening(state_.deformation()[v]);
    }
}


Foam::scalar Foam::fsbi::secondOrderElastic::stiffeningTangent
(
    const label v, const tensor& dF
) const
{
    return
        material_.linear() || material_.flows()
      ? 0
      : strainStiffeningTangent(state_.deformation()[v], dF);
}


void Foam::fsbi::secondOrderElastic::addFaces
(
    const tensorField& stress,
    const vectorField& held,
    vectorField& force,
    scalar* r
) const
{
    const label nCells = mesh_.nCells();
    const label firstBoundary = stencil_.firstBoundary();
    const scalar mu = state_.shearModulus();
    vector* row = asVectors(r);

    forAll(stencil_.owner(), i)
    {
        if (stencil_.between(i))
        {
            continue;
        }
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const vector T
        (
            (stencil_.faceMean(i, stress) & stencil_.area()[i])
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


void Foam::fsbi::secondOrderElastic::addPressures
(
    const scalarField& volume, const scalarField& pressure, scalar* r
) const
{
    vertexRow_ = Zero;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const labelList& points = stencil_.vertices().ofCells()[celli];
        scalar mean = 0;
        for (const label v : points)
        {
            mean += pressure[v]/points.size();
        }
        const scalar weight =
            smoothingScale*mesh_.cellVolumes()[celli]
           /(points.size()*shearModulus(celli));
        for (const label v : points)
        {
            vertexRow_[v] += weight*(pressure[v] - mean);
        }
    }
    stencil_.vertices().sum<1>(vertexRow_.begin());

    scalar* row = r + 3*(mesh_.nCells() + stencil_.nGhosts());
    forAll(ownedVertices_, i)
    {
        const label v = ownedVertices_[i];
        row[i] =
            vertexRow_[v]
          + stencil_.vertexVolume()[v]
           *(volume[v] + pressure[v]/state_.law(v).lambda());
    }
}


void Foam::fsbi::secondOrderElastic::set
(
    const displacementFunction& u, scalar* x
) const
{
    const vectorField C(stencil_.centres());
    vector* row = asVectors(x);
    for (label i = 0; i < stencil_.nCells(); ++i)
    {
        *row++ = u(C[i]);
    }
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        *row++ = u(C[stencil_.firstGhost() + g]);
    }
    row = asVectors(x + firstJointRow());
    const partJoints& joints = stencil_.joints();
    for (const label j : joints.owned())
    {
        *row++ = u(mesh_.faceCentres()[joints.faces()[j]]);
    }
}


void Foam::fsbi::secondOrderElastic::residual
(
    const scalar* x, const solidBoundary& given, scalar* r
)
{
    std::fill_n(r, size(), scalar(0));
    gather(x, values_);
    setGradient(values_, state_.gradient());
    setPressure(x, state_.pressure());
    state_.evaluate();
    const tensorField& gradient = state_.gradient();
    given_ = &given;
    setStiffening();
    vectorField held(stencil_.nFaces());
    forAll(held, i)
    {
        unexplained_[i] = unexplained(i, values_, gradient);
        if (material_.flows())
        {
            held[i] = stabilisation*flowing(i);
            continue;
        }
        unexplained_[i] += jumpHistory_[i];
        held[i] =
            (stabilisation + stencil_.faceMean(i, stiffening_))*unexplained_[i];
    }
    addFaces(state_.stress(), held, boundaryForce_, r);
    addJoints(r);

    vectorField atGhosts(stencil_.nGhosts());
    forAll(atGhosts, g)
    {
        atGhosts[g] =
            boundary_.kindOf(g) == solidBoundary::displacement
          ? given.faces[stencil_.ghostFaces()[g]]
          : boundary_.deadLoad(g, given)
          + boundary_.followerLoad
            (
                g, given, stencil_.area()[stencil_.firstBoundary() + g],
                meanAtGhost(g, gradient)
            );
    }
    boundary_.addRows(values_, gradient, boundaryForce_, atGhosts, r);
    forAll(atGhosts, g)
    {
        if (boundary_.kindOf(g) == solidBoundary::traction)
        {
            boundaryForce_[g] = atGhosts[g];
        }
    }
    scalar growth = 0;
    if (cortex_)
    {
        growth = addCortex(cortex_->forces(atVertices(values_)), r);
    }
    if (mixed_)
    {
        scalarField volume(stencil_.vertices().size());
        forAll(volume, v)
        {
            volume[v] = state_.volumeChange(v);
        }
        setMeanGrowth(growth, volume);
        addPressures(volume, state_.pressure(), r);
    }
}


void Foam::fsbi::secondOrderElastic::applyJacobian(const scalar* dx, scalar* dr) const
{
    std::fill_n(dr, size(), scalar(0));
    gather(dx, dValues_);
    setGradient(dValues_, dGradient_);
    setPressure(dx, dPressure_);
    scalarField volume(dPressure_.size());
    forAll(dStress_, v)
    {
        const tensor& dH = dGradient_[v];
        dStress_[v] = state_.tangent(v, dH, mixed_ ? dPressure_[v] : 0);
        dStiffening_[v] = stiffeningTangent(v, dH & state_.referenceF()[v]);
        if (mixed_)
        {
            volume[v] = state_.volumeTangent(v, dH);
        }
    }
    vectorField held(stencil_.nFaces());
    forAll(held, i)
    {
        const vector change(unexplained(i, dValues_, dGradient_));
        if (material_.flows())
        {
            held[i] = stabilisation*flowingTangent(i, change);
            continue;
        }
        held[i] =
            (stabilisation + stencil_.faceMean(i, stiffening_))*change
          + stencil_.faceMean(i, dStiffening_)*unexplained_[i];
    }
    addFaces(dStress_, held, dBoundaryForce_, dr);
    addJointTangents(dr);

    vectorField atGhosts(stencil_.nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        if (boundary_.kindOf(g) != solidBoundary::displacement)
        {
            atGhosts[g] = boundary_.loadTangent
            (
                g, *given_, stencil_.area()[stencil_.firstBoundary() + g],
                meanAtGhost(g, state_.gradient()), meanAtGhost(g, dGradient_)
            );
        }
    }
    boundary_.addRows(dValues_, dGradient_, dBoundaryForce_, atGhosts, dr);
    scalar growth = 0;
    if (cortex_)
    {
        growth = addCortex(cortex_->tangent(atVertices(dValues_)), dr);
    }
    if (mixed_)
    {
        setMeanGrowth(growth, volume);
        addPressures(volume, dPressure_, dr);
    }
}


Foam::tmp<Foam::vectorField> Foam::fsbi::secondOrderElastic::atVertices
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
Foam::fsbi::secondOrderElastic::vertexDisplacement() const
{
    return atVertices(values_);
}


void Foam::fsbi::secondOrderElastic::shareForces
(
    const vectorField& onVertices, vectorField& cells, vectorField& faces
) const
{
    forAll(onVertices, v)
    {
        if (onVertices[v] == vector::zero)
        {
            continue;
        }
        for
        (
            label j = stencil_.vertexStart()[v];
            j < stencil_.vertexStart()[v + 1];
            ++j
        )
        {
            const label column = stencil_.vertexColumn()[j];
            const vector part(stencil_.valueWeight()[j]*onVertices[v]);
            if (column < stencil_.nCells())
            {
                cells[column] += part;
                continue;
            }
            // u_G = 2 u_b - u_P, b: on the face
            const label g = column - stencil_.firstGhost();
            const label i = stencil_.firstBoundary() + g;
            faces[stencil_.ghostFaces()[g]] += 2*part;
            cells[stencil_.owner()[i]] -= part;
        }
    }
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::secondOrderElastic::vertexIncrement() const
{
    return atVertices(dValues_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::secondOrderElastic::boundaryDisplacement() const
{
    return boundary_.displacement(values_, state_.gradient());
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::secondOrderElastic::boundaryIncrement() const
{
    return boundary_.displacement(dValues_, dGradient_);
}


void Foam::fsbi::secondOrderElastic::endStep()
{
    elasticOperator::endStep();
    if (state_.carriesOn())
    {
        jumpHistory_ = unexplained_;
    }
    for (label i = 0; material_.flows() && i < jumpHistory_.size(); ++i)
    {
        const tensor F(stencil_.faceMean(i, state_.deformation()));
        jumpHistory_[i] = F.T() & unexplained_[i];
    }
}
