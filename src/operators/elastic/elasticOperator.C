/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderElastic.H"
#include "jointValues.H"
#include "secondOrderElastic.H"
#include "sharedVertices.H"
#include "syncTools.H"

Foam::fsbi::elasticOperator::elasticOperator
(
    const fvMesh& mesh,
    const materialParts& parts,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
:
    mesh_(mesh),
    parts_(parts),
    material_(*parts_.laws[0]),
    mixed_(mixed),
    stencil_(mesh, kinds, parts_.ofCells, parts_.stiffness()),
    state_(mesh.name(), stencil_.vertices().size(), material_, form, mixed),
    boundary_(stencil_, state_, kinds),
    jumpHistory_(stencil_.nFaces(), Zero),
    boundaryForce_(stencil_.nGhosts(), Zero)
{
    setLaws();
    setOwnedVertices();
}


void Foam::fsbi::elasticOperator::setLaws()
{
    if (!stencil_.vertices().several())
    {
        return;
    }
    List<const solidMaterial*> laws(stencil_.vertices().size());
    forAll(laws, v)
    {
        laws[v] = parts_.laws[stencil_.vertices().part(v)];
    }
    state_.setLaws(std::move(laws));
}


Foam::autoPtr<Foam::fsbi::elasticOperator> Foam::fsbi::elasticOperator::New
(
    const label order,
    const fvMesh& mesh,
    const materialParts& parts,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
{
    if (order == 4)
    {
        return autoPtr<elasticOperator>
        (
            new fourthOrderElastic(mesh, parts.law(0), kinds, form, mixed)
        );
    }
    return autoPtr<elasticOperator>
    (
        new secondOrderElastic(mesh, parts, kinds, form, mixed)
    );
}


void Foam::fsbi::elasticOperator::setOwnedVertices()
{
    if (!mixed_)
    {
        return;
    }
    const bitSet master(syncTools::getMasterPoints(mesh_));
    DynamicList<label> owned;
    for (label v = 0; v < stencil_.vertices().size(); ++v)
    {
        if (master[stencil_.vertices().point(v)])
        {
            owned.append(v);
        }
    }
    ownedVertices_.transfer(owned);
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
    const partJoints& joints = stencil_.joints();
    forAll(joints.owned(), i)
    {
        std::fill_n
        (
            scale.begin() + firstJointRow() + 3*i, 3,
            1/(state_.stiffness()*joints.joined()[joints.owned()[i]])
        );
    }
    return scale;
}


void Foam::fsbi::elasticOperator::shareJoints
(
    const scalar* r, UList<vector>& cells
) const
{
    const partJoints& joints = stencil_.joints();
    const vectorField force(jointValues(*this, r));
    for (const partJoints::half& h : joints.halves())
    {
        cells[h.cell] += h.share*force[h.joint];
    }
}


void Foam::fsbi::elasticOperator::followCells
(
    const scalar* r, const UList<vector>& cells, scalar* u
) const
{
    const partJoints& joints = stencil_.joints();
    vectorField parts(joints.size(), Zero);
    for (const partJoints::half& h : joints.halves())
    {
        parts[h.joint] += h.share*cells[h.cell];
    }
    UList<vector> at(asVectors(u + firstJointRow()), joints.owned().size());
    joints.sum(parts, at);
    const vector* force = asVectors(r + firstJointRow());
    forAll(at, i)
    {
        at[i] +=
            force[i]
           /(state_.stiffness()*joints.joined()[joints.owned()[i]]);
    }
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
