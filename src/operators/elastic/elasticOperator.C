/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderElastic.H"
#include "secondOrderElastic.H"
#include "sharedVertices.H"
#include "syncTools.H"

Foam::fsbi::elasticOperator::elasticOperator
(
    const fvMesh& mesh,
    const solidMaterial& material,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
:
    mesh_(mesh),
    material_(material),
    mixed_(mixed),
    stencil_(mesh, kinds),
    state_(mesh.name(), mesh.nPoints(), material, form, mixed),
    boundary_(stencil_, state_, kinds),
    jumpHistory_(stencil_.nFaces(), Zero),
    boundaryForce_(stencil_.nGhosts(), Zero)
{
    setOwnedVertices();
}


Foam::autoPtr<Foam::fsbi::elasticOperator> Foam::fsbi::elasticOperator::New
(
    const label order,
    const fvMesh& mesh,
    const solidMaterial& material,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
{
    if (order == 4)
    {
        return autoPtr<elasticOperator>
        (
            new fourthOrderElastic(mesh, material, kinds, form, mixed)
        );
    }
    return autoPtr<elasticOperator>
    (
        new secondOrderElastic(mesh, material, kinds, form, mixed)
    );
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


void Foam::fsbi::elasticOperator::setCortex(const dictionary& dict)
{
    cortex_.reset
    (
        new cortex(mesh_, stencil_.halo().size(), boundary_.kinds(), dict)
    );
}


bool Foam::fsbi::elasticOperator::valid() const
{
    const bool skin = !cortex_ || cortex_->valid();
    return state_.valid() && skin;
}


void Foam::fsbi::elasticOperator::update()
{
    stencil_.update();
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
        const scalar k = state_.stiffness()*stencil_.compact()[i];
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
    const label firstPressure = 3*(nCells + stencil_.nGhosts());
    forAll(ownedVertices_, i)
    {
        const scalar V = stencil_.vertexVolume()[ownedVertices_[i]];
        scale[firstPressure + i] = cbrt(V)/V;
    }
    return scale;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::elasticOperator::boundaryForce() const
{
    auto result = tmp<vectorField>::New(boundary_.kinds().size(), Zero);
    UIndirectList<vector>(result.ref(), stencil_.ghostFaces()) = boundaryForce_;
    return result;
}


void Foam::fsbi::elasticOperator::shareForces
(
    const vectorField& onVertices, vectorField&, vectorField& faces
) const
{
    scalarField number(mesh_.nPoints(), Zero);
    const auto corners = [&](const label b) -> const face&
    {
        return mesh_.faces()[mesh_.nInternalFaces() + b];
    };
    for (const label b : stencil_.ghostFaces())
    {
        for (const label v : corners(b))
        {
            number[v] += 1;
        }
    }
    sharedVertices::sum<1>(mesh_, number.begin(), stencil_.halo().size());
    for (const label b : stencil_.ghostFaces())
    {
        for (const label v : corners(b))
        {
            faces[b] += onVertices[v]/number[v];
        }
    }
}


void Foam::fsbi::elasticOperator::endStep()
{
    state_.endStep();
}
