/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "PstreamReduceOps.H"

namespace Foam
{
namespace fsbi
{

//- A few times what is lost of a number of 1
static const scalar digits = 1e-15;

} // End namespace fsbi
} // End namespace Foam


Foam::scalarList Foam::fsbi::coupledSystem::packed
(
    const scalarList& cells
) const
{
    scalarList x(layout_.size());
    std::copy_n(cells.begin(), layout_.nFluid(), x.begin());
    systemLayout::whole bodies
    {
        List<sixVector>(bodies_->size()), vectorField(elastic_.size())
    };
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        std::copy
        (
            body.x->begin(), body.x->end(),
            x.begin() + layout_.elastic(e)
        );
        bodies.tethers[e] = body.multiplier;
    }
    forAll(bodies.velocities, b)
    {
        bodies.velocities[b] = (*bodies_)[b].velocity;
    }
    layout_.write(bodies, x.begin());
    return x;
}


Foam::scalarList Foam::fsbi::coupledSystem::atRest(const scalarList& x) const
{
    scalarList rest(x);
    std::fill_n(rest.begin(), layout_.nFluid(), scalar(0));
    systemLayout::whole still(layout_.read(rest.cdata()));
    still.velocities = sixVector(Zero);
    layout_.write(still, rest.begin());
    return rest;
}


void Foam::fsbi::coupledSystem::unpack
(
    const scalarList& x, scalarList& cells
)
{
    std::copy_n(x.begin(), layout_.nFluid(), cells.begin());
    const systemLayout::whole bodies(layout_.read(x.cdata()));
    forAll(elastic_, e)
    {
        elasticRows& body = *elastic_[e];
        std::copy_n
        (
            x.begin() + layout_.elastic(e), body.x->size(),
            body.x->begin()
        );
        body.multiplier = bodies.tethers[e];
    }
    forAll(bodies.velocities, b)
    {
        (*bodies_)[b].velocity = bodies.velocities[b];
    }
}


Foam::fsbi::bodyChange Foam::fsbi::coupledSystem::largestChange
(
    const scalarList& before, const scalarList& x
) const
{
    scalarList changes(elastic_.size(), Zero);
    forAll(elastic_, e)
    {
        const vector* now = layout_.displacement(e, x.cdata());
        const vector* then = layout_.displacement(e, before.cdata());
        forAll(elastic_[e]->volumes, celli)
        {
            changes[e] = max(changes[e], mag(now[celli] - then[celli]));
        }
    }
    Pstream::listCombineGather(changes, maxEqOp<scalar>());
    Pstream::listCombineScatter(changes);
    const label e = findMax(changes);
    return {e, e < 0 ? 0 : changes[e]};
}


Foam::scalar Foam::fsbi::coupledSystem::roundOff(const scalarList& x) const
{
    scalar sum = 0;
    forAll(elastic_, e)
    {
        const elasticRows& body = *elastic_[e];
        const bool linear = body.elastic->state().material().linear();
        const vector* u = layout_.displacement(e, x.cdata());
        forAll(body.volumes, i)
        {
            // a linear law sees the gradient, others see 1 + gradient
            const scalar size = linear ? 0 : cbrt(body.volumes[i]);
            sum += sqr(body.velocityCoeff*(size + mag(u[i])));
        }
    }
    return digits*sqrt(returnReduce(sum, sumOp<scalar>()));
}
