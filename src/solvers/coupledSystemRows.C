/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "bodyCoupling.H"
#include "elasticCoupling.H"
#include "mathematicalConstants.H"
#include "Pstream.H"

void Foam::fsbi::coupledSystem::fluidResidual
(
    const scalar* x,
    scalar* r,
    const bool homogeneous
) const
{
    homogeneous
      ? momentum_.applyJacobian(x, values_, r, traction_)
      : momentum_.residual(x, values_, r, traction_);
}


void Foam::fsbi::coupledSystem::elasticResiduals
(
    const scalar* x,
    scalar* r,
    const bool homogeneous
) const
{
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        const scalar* xe = x + layout_.elastic(e);
        scalar* re = r + layout_.elastic(e);
        homogeneous
          ? body.elastic->tangent(xe, re)
          : body.elastic->residual(xe, *body.given, re);
        const vector* u = layout_.displacement(e, x);
        vector* row = layout_.displacement(e, r);
        forAll(body.mass, i)
        {
            row[i] +=
                body.mass[i]*u[i]
              - (homogeneous ? vector::zero : body.force[i]);
        }
        setSurfaceVelocity(body, homogeneous, values_);
    }
}


Foam::vectorField Foam::fsbi::coupledSystem::tetherResiduals
(
    const UList<vector>& tethers,
    const scalar* x,
    scalar* r,
    const bool homogeneous
) const
{
    vectorField stretch(elastic_.size(), Zero);
    if (!layout_.tethers())
    {
        return stretch;
    }
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        const vector* u = layout_.displacement(e, x);
        vector* row = layout_.displacement(e, r);
        forAll(body.share, i)
        {
            row[i] -= body.share[i]*tethers[e];
            stretch[e] += body.share[i]*u[i];
        }
    }
    surfaceSide::sum(stretch);
    forAll(stretch, e)
    {
        stretch[e] =
            elastic_[e]->rate
           *(stretch[e] - (homogeneous ? vector::zero : elastic_[e]->place));
    }
    return stretch;
}


Foam::fsbi::loads::onBodies Foam::fsbi::coupledSystem::effectForces
(
    const UList<sixVector>& v, const bool homogeneous
) const
{
    if (!coupling_)
    {
        return loads::onBodies();
    }
    if (!homogeneous)
    {
        return coupling_->forces(v);
    }
    List<vectorField> points(elastic_.size());
    for (label e = 0; coupling_->onElastic() && e < elastic_.size(); ++e)
    {
        points[e] = surfaceDisplacement(*elastic_[e], true).points;
    }
    return coupling_->changes(v, points);
}


Foam::List<Foam::fsbi::sixVector>
Foam::fsbi::coupledSystem::bodyResiduals
(
    const UList<sixVector>& v,
    const loads::onBodies& load,
    const bool homogeneous
) const
{
    List<sixVector> pull(bodyLoads(mesh_, *bodies_, traction_));
    for (label b = 0; coupling_ && b < pull.size(); ++b)
    {
        forAll(pull[b], k)
        {
            pull[b][k] += load.whole[b][k];
        }
    }
    List<sixVector> defects(bodyDefects(*bodies_, v, pull, homogeneous));
    forAll(defects, b)
    {
        forAll(defects[b], k)
        {
            defects[b][k] *= -scales_.bodies()[b][k];
        }
    }
    return defects;
}


void Foam::fsbi::coupledSystem::residual
(
    const scalar* x,
    scalar* r,
    const bool homogeneous
) const
{
    if (homogeneous)
    {
        values_.faces = Zero;
        values_.vertices = Zero;
    }
    else
    {
        values_.faces = given_->faces;
        values_.vertices = given_->vertices;
    }
    const systemLayout::whole now(layout_.read(x));
    setBodyVelocities(stokes_, *bodies_, now.velocities, values_);
    elasticResiduals(x, r, homogeneous);
    fluidResidual(x, r, homogeneous);
    const loads::onBodies load(effectForces(now.velocities, homogeneous));
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        vectorField force(surfaceForce(body, traction_));
        if (coupling_)
        {
            body.solid.addToFaces(load.triangles[bodies_->size() + e], force);
        }
        body.elastic->addLoad(force, r + layout_.elastic(e));
    }
    const vectorField stretch
    (
        tetherResiduals(now.tethers, x, r, homogeneous)
    );
    scales_.apply(r);
    layout_.write
    (
        {bodyResiduals(now.velocities, load, homogeneous), stretch}, r
    );
}


void Foam::fsbi::coupledSystem::precondition
(
    const scalar* r,
    scalar* z
) const
{
    // bodies' rows are scaled by the inverse of a crude diagonal: only torques,
    // which stand as velocities at the surface, change
    scales_.undo(r, state_.begin());
    systemLayout::whole bodies(layout_.read(r));
    List<sixVector>& v = bodies.velocities;
    forAll(v, b)
    {
        for (label k = 3; k < 6; ++k)
        {
            v[b][k] /= (*bodies_)[b].radius;
        }
    }
    if (coupling_)
    {
        coupling_->precondition(v);
    }
    values_.faces = Zero;
    values_.vertices = Zero;
    setBodyVelocities(stokes_, *bodies_, v, values_);
    forAll(v, b)
    {
        for (const label i : (*bodies_)[b].faces)
        {
            const label facei = mesh_.nInternalFaces() + i;
            const scalar k = stokes_.wallCoeff(i);
            const vector& u = values_.faces[i];
            scalar* row = state_.begin() + 4*mesh_.faceOwner()[facei];
            row[0] += k*u.x();
            row[1] += k*u.y();
            row[2] += k*u.z();
            row[3] -= u & mesh_.faceAreas()[facei];
        }
    }

    // a tether's residual is a velocity, which the drag of a sphere resists
    const scalar pi = constant::mathematical::pi;
    forAll(elastic_, e)
    {
        vector& tether = bodies.tethers[e];
        tether *= 6*pi*stokes_.mu()*elastic_[e]->radius;
        vector* row = layout_.displacement(e, state_.begin());
        forAll(elastic_[e]->share, i)
        {
            row[i] += elastic_[e]->share[i]*tether;
        }
    }

    preconditioner_->apply(state_.cdata(), z);
    layout_.write(bodies, z);
}
