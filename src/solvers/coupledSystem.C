/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "bodyCoupling.H"
#include "finiteRotation.H"
#include "volFields.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace fsbi
{

//- Factors by which velocity per displacement and the fluid's force per velocity,
//  and springs, may change with the same preconditioner
static const scalar rateChange = 1.1;
static const scalar springsChange = 1.5;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::coupledSystem::coupledSystem
(
    const momentumEquation& momentum, const word& preconditionerType
)
:
    momentum_(momentum),
    preconditionerType_(preconditionerType),
    traction_(momentum.viscous().nBoundaryFaces(), Zero)
{}


bool Foam::fsbi::coupledSystem::set
(
    const flowProblem& problem, const scalarList& cells
)
{
    given_ = &problem.given;
    bodies_ = &problem.bodies;
    elastic_ = problem.elastic;
    values_ = problem.given;
    const stokesOperator& stokes = momentum_.viscous();
    enclosedVolume_ = enclosed() ? gSum(stokes.stencil().mesh().V()) : 0;
    scales_ = rowScales(momentum_, problem.bodies, elastic_);
    layout_ =
        systemLayout
        (
            stokes.stencil().mesh().nCells(), elastic_, problem.bodies.size()
        );
    effects_.clear();
    corners_.clear();
    shapes_.clear();
    if (stokes.varies())
    {
        // not those of whatever was evaluated last, which a restart does not know
        const scalarList x(packed(cells));
        scalarList rows(x.size());
        residual(x.cdata(), rows.begin());
        scales_ = rowScales(momentum_, problem.bodies, elastic_);
    }
    if (!problem.acting.empty())
    {
        effects_.reset
        (
            new loadCoupling
            (
                problem.acting, problem.bodies, scales_.resistance()
            )
        );
    }
    return setSprings();
}


bool Foam::fsbi::coupledSystem::setSprings()
{
    scalar rate = 0, springs = 0;
    forAll(elastic_, e)
    {
        elasticRows& body = *elastic_[e];
        body.springs = scalarField();
        if (effects_ && effects_->acting().onElastic())
        {
            // the mean over directions
            const label bodyi = bodies_->size() + e;
            body.springs = tr(effects_->acting().springStiffness(bodyi))/3;
            springs += sum(body.springs);
        }
        rate += body.velocityCoeff;
    }
    const auto changed = [](const scalar a, const scalar b, const scalar factor)
    {
        return max(a, b) > factor*min(a, b);
    };
    if
    (
        changed(rate, rate_, rateChange)
     || changed(springs, springs_, springsChange)
     || changed(momentum_.densityRate(), densityRate_, rateChange)
    )
    {
        rate_ = rate;
        springs_ = springs;
        densityRate_ = momentum_.densityRate();
        return true;
    }
    return false;
}


Foam::scalar Foam::fsbi::coupledSystem::norm(const scalarList& rows)
{
    scalar sum = 0;
    for (const scalar r : rows)
    {
        sum += r*r;
    }
    return sqrt(returnReduce(sum, sumOp<scalar>()));
}


void Foam::fsbi::coupledSystem::addSurfaceForces
(
    const loads::onBodies& load, scalar* r
) const
{
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        vectorField force(body.surfaceForce(body.fluidForces(traction_)));
        vectorField cells;
        const label bodyi = bodies_->size() + e;
        if (effects_)
        {
            body.solid.addToFaces(load.triangles[bodyi], force);
        }
        if (effects_ && load.points[bodyi].size())
        {
            cells.setSize(body.volumes.size(), Zero);
            body.addPointForces(load.points[bodyi], cells, force);
        }
        vector* row = layout_.displacement(e, r);
        forAll(cells, i)
        {
            row[i] -= cells[i];
        }
        body.elastic->boundary().addLoad(force, r + layout_.elastic(e));
    }
}


Foam::List<Foam::fsbi::sixVector> Foam::fsbi::coupledSystem::bodyForces
(
    const loads::onBodies& load
) const
{
    List<sixVector> forces(bodyLoads(momentum_.viscous(), *bodies_, traction_));
    for (label b = 0; effects_ && b < forces.size(); ++b)
    {
        forAll(forces[b], k)
        {
            forces[b][k] += load.whole[b][k];
        }
    }
    return forces;
}


void Foam::fsbi::coupledSystem::addTethers
(
    const UList<vector>& tethers, scalar* r
) const
{
    forAll(elastic_, e)
    {
        vector* row = layout_.displacement(e, r);
        forAll(elastic_[e]->constraintWeight, i)
        {
            row[i] -= elastic_[e]->constraintWeight[i]*tethers[e];
        }
    }
}


Foam::vectorField Foam::fsbi::coupledSystem::meanDisplacements
(
    const scalar* x
) const
{
    vectorField means(elastic_.size(), Zero);
    if (!layout_.tethers())
    {
        return means;
    }
    forAll(elastic_, e)
    {
        const vector* u = layout_.displacement(e, x);
        forAll(elastic_[e]->constraintWeight, i)
        {
            means[e] += elastic_[e]->constraintWeight[i]*u[i];
        }
    }
    surfaceSide::sum(means);
    return means;
}


bool Foam::fsbi::coupledSystem::enclosed() const
{
    bool all = elastic_.size() && momentum_.viscous().closed();
    for (const elasticRows* body : elastic_)
    {
        all &= body->elastic->state().material().flows();
    }
    return all;
}


void Foam::fsbi::coupledSystem::spreadVolume(scalar* r) const
{
    const scalarField& volumes =
        momentum_.viscous().stencil().mesh().V();
    scalar sum = 0;
    forAll(volumes, celli)
    {
        sum += r[4*celli + 3];
    }
    const scalar mean =
        returnReduce(sum, sumOp<scalar>())/enclosedVolume_;
    forAll(volumes, celli)
    {
        r[4*celli + 3] -= mean*volumes[celli];
    }
}


void Foam::fsbi::coupledSystem::finishRows
(
    List<sixVector> defects, const vectorField& tethers, scalar* r
) const
{
    if (enclosedVolume_ > 0)
    {
        spreadVolume(r);
    }
    scales_.apply(r);
    forAll(defects, b)
    {
        forAll(defects[b], k)
        {
            defects[b][k] *= -scales_.bodies()[b][k];
        }
    }
    layout_.write({defects, tethers}, r);
}


void Foam::fsbi::coupledSystem::residual(const scalar* x, scalar* r) const
{
    const systemLayout::whole now(layout_.read(x));
    values_.faces = given_->faces;
    values_.vertices = given_->vertices;
    setBodyVelocities(momentum_.viscous(), *bodies_, now.velocities, values_);
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        body.residual(x + layout_.elastic(e), r + layout_.elastic(e));
        body.setVelocity(momentum_.viscous(), body.surface(), values_);
    }
    momentum_.residual(x, values_, r, traction_);

    loads::onBodies load;
    if (effects_)
    {
        load = effects_->forces(now.velocities);
    }
    addSurfaceForces(load, r);
    addTethers(now.tethers, r);
    vectorField tethers(meanDisplacements(x));
    forAll(tethers, e)
    {
        const elasticRows& body = *elastic_[e];
        tethers[e] =
            body.velocityCoeff*(tethers[e] - body.targetDisplacement);
    }
    finishRows
    (
        bodyDefects(*bodies_, now.velocities, bodyForces(load)), tethers, r
    );
}


void Foam::fsbi::coupledSystem::loadRows
(
    const loads::onBodies& load, scalar* r
) const
{
    traction_ = Zero;
    addSurfaceForces(load, r);
    finishRows
    (
        bodyDefectChanges
        (
            *bodies_, List<sixVector>(bodies_->size(), sixVector(scalar(0))),
            bodyForces(load)
        ),
        vectorField(elastic_.size(), Zero), r
    );
}


Foam::fsbi::loads::ofBodies Foam::fsbi::coupledSystem::displacements
(
    const scalar* dx
) const
{
    List<vectorField> points(elastic_.size());
    forAll(elastic_, e)
    {
        scalarList rows(elastic_[e]->elastic->size());
        elastic_[e]->applyJacobian(dx + layout_.elastic(e), rows.begin());
        points[e] = elastic_[e]->surfaceIncrement().points;
    }
    return effects_->displacements(layout_.read(dx).velocities, points);
}


Foam::scalar Foam::fsbi::coupledSystem::normOfEffects() const
{
    scalarList r(size(), Zero);
    loadRows(effects_->acting().forces(), r.begin());
    return norm(r);
}


void Foam::fsbi::coupledSystem::followShapes()
{
    shapes_.clear();
    for (const elasticRows* body : elastic_)
    {
        shapes_.append(new shapeDerivative(momentum_.viscous(), *body));
    }
}


void Foam::fsbi::coupledSystem::finishRotations
(
    const scalarList& before, scalarList& x
) const
{
    forAll(elastic_, e)
    {
        const label start = layout_.elastic(e);
        finishRotation
        (
            *elastic_[e], before.cdata() + start, x.begin() + start
        );
    }
}


bool Foam::fsbi::coupledSystem::admissible(const scalarList& x)
{
    bool valid = true;
    scalarList rows;
    forAll(elastic_, e)
    {
        rows.setSize(elastic_[e]->elastic->size());
        elastic_[e]->residual(x.cdata() + layout_.elastic(e), rows.begin());
        valid = elastic_[e]->elastic->valid() && valid;
    }
    return valid;
}


void Foam::fsbi::coupledSystem::applyJacobian
(
    const scalar* dx, scalar* dr
) const
{
    const systemLayout::whole change(layout_.read(dx));
    values_.faces = Zero;
    values_.vertices = Zero;
    setBodyVelocities
    (
        momentum_.viscous(), *bodies_, change.velocities, values_
    );
    List<vectorField> points(elastic_.size());
    List<surfaceDisplacement> moved(elastic_.size());
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        body.applyJacobian(dx + layout_.elastic(e), dr + layout_.elastic(e));
        const surfaceDisplacement dd(body.surfaceIncrement());
        moved[e] = body.parts(dd);
        body.setVelocityIncrement(momentum_.viscous(), moved[e], values_);
        points[e] = dd.points;
        if (shapes_.size())
        {
            shapes_[e].addVelocity(moved[e], values_);
        }
    }
    momentum_.applyJacobian(dx, values_, dr, traction_);
    forAll(shapes_, e)
    {
        shapes_[e].addTraction(moved[e], traction_);
    }

    loads::onBodies load;
    if (effects_)
    {
        load = effects_->changes(change.velocities, points);
    }
    addSurfaceForces(load, dr);
    addTethers(change.tethers, dr);
    vectorField tethers(meanDisplacements(dx));
    forAll(tethers, e)
    {
        tethers[e] *= elastic_[e]->velocityCoeff;
    }
    finishRows
    (
        bodyDefectChanges(*bodies_, change.velocities, bodyForces(load)),
        tethers, dr
    );
}


void Foam::fsbi::coupledSystem::precondition(const scalar* r, scalar* z) const
{
    preconditioner_->apply(r, z);
    if (!effects_ || !effects_->acting().onCorners())
    {
        return;
    }
    if (!corners_)
    {
        corners_.reset
        (
            new cornerSprings
            (
                effects_->acting(), size(),
                [this](const loads::onBodies& load, scalar* rows)
                {
                    loadRows(load, rows);
                },
                [this](const scalar* dx) { return displacements(dx); },
                [this](const scalar* rows, scalar* answer)
                {
                    preconditioner_->apply(rows, answer);
                }
            )
        );
    }
    corners_->apply(z);
}


void Foam::fsbi::coupledSystem::forgetPreconditioner()
{
    preconditioner_.clear();
    corners_.clear();
}


Foam::fsbi::coupledPreconditioner& Foam::fsbi::coupledSystem::preconditioner()
{
    if (!preconditioner_)
    {
        preconditioner_ =
            coupledPreconditioner::New(preconditionerType_, *this);
    }
    return preconditioner_();
}


void Foam::fsbi::coupledSystem::renewPreconditioner()
{
    preconditioner().rebuild();
    corners_.clear();
}
