/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidResidual.H"
#include "massRows.H"
#include "PstreamReduceOps.H"

Foam::fsbi::solidResidual::solidResidual
(
    const fvMesh& mesh,
    elasticOperator& elastic,
    const solidMaterial& material
)
:
    mesh_(mesh),
    elastic_(elastic),
    linear_(material.linear()),
    scale_(elastic.size()),
    rows_(elastic.size())
{}


void Foam::fsbi::solidResidual::setStiffness()
{
    stiffness_ = problem_->mass;
    const elasticStencil& stencil = elastic_.stencil();
    for (label g = 0; problem_->spring && g < elastic_.stencil().nGhosts(); ++g)
    {
        const label b = stencil.ghostFaces()[g];
        const label i = stencil.firstBoundary() + g;
        // in a row with half of the cell
        const scalar k = 2*elastic_.state().stiffness()*stencil.compact()[i];
        const scalar spring =
            max(tr(problem_->spring->stiffness[b])/3, scalar(0));
        if (elastic_.boundary().kinds()[b] == solidBoundary::traction)
        {
            stiffness_[stencil.owner()[i]] += k*spring/(k + spring);
        }
    }
}


void Foam::fsbi::solidResidual::setProblem(const solidProblem& problem)
{
    problem_ = &problem;
    setStiffness();
    scale_ = elastic_.rowScale(stiffness_);
    size_ = 0;

    // a linear law sees the gradient, others see 1 + gradient
    roundOff_ =
        linear_
      ? 0
      : 1e-15*sqrt(squareSum([&](const label celli)
        {
            return
                elastic_.state().stiffness()
               *pow(mesh_.cellVolumes()[celli], 2.0/3.0);
        }));
}


Foam::scalar Foam::fsbi::solidResidual::squareSum
(
    const std::function<scalar(const label)>& cell
) const
{
    scalar sum = 0;
    forAll(mesh_.cells(), celli)
    {
        sum += sqr(cell(celli)*scale_[3*celli]);
    }
    return returnReduce(sum, sumOp<scalar>());
}


bool Foam::fsbi::solidResidual::evaluate(const scalarList& x)
{
    elastic_.residual(x.cdata(), problem_->given, rows_.begin());
    if (problem_->spring)
    {
        elastic_.boundary().addLoad
        (
            problem_->spring->force(elastic_.surfaceDisplacement()),
            rows_.begin()
        );
    }
    scalar sum = 0;
    addMassAndForce
    (
        problem_->mass, problem_->force, x.cdata(), rows_.begin()
    );
    forAll(rows_, i)
    {
        rows_[i] *= scale_[i];
        sum += sqr(rows_[i]);
    }
    norm_ = sqrt(returnReduce(sum, sumOp<scalar>()));
    if (!elastic_.valid() || !std::isfinite(norm_))
    {
        return false;
    }
    const scalar forces = sqrt(squareSum([&](const label celli)
    {
        return
            mag(problem_->force[celli])
          + pow(mesh_.cellVolumes()[celli], 2.0/3.0)
           *mag(elastic_.stencil().cellMean(celli, elastic_.state().stress()));
    }));
    size_ = max(size_, size_ > 0 ? forces : max(forces, norm_));
    return true;
}


void Foam::fsbi::solidResidual::finishJacobian
(
    const scalar* dx, scalar* dr
) const
{
    if (problem_->spring)
    {
        elastic_.boundary().addLoad
        (
            -(problem_->spring->stiffness & elastic_.surfaceIncrement()), dr
        );
    }
    addMass(problem_->mass, dx, dr);
    forAll(scale_, i)
    {
        dr[i] *= scale_[i];
    }
}


void Foam::fsbi::solidResidual::unscale
(
    const scalar* scaled, scalarList& r
) const
{
    forAll(scale_, i)
    {
        r[i] = scaled[i]/scale_[i];
    }
}
