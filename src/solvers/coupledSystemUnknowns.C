/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"

Foam::scalarList Foam::fsbi::coupledSystem::packed(const scalarList& x) const
{
    scalarList unknown(layout_.size());
    std::copy_n(x.begin(), layout_.nFluid(), unknown.begin());
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
            unknown.begin() + layout_.elastic(e)
        );
        bodies.tethers[e] = body.tether;
    }
    forAll(bodies.velocities, b)
    {
        bodies.velocities[b] = (*bodies_)[b].velocity;
    }
    layout_.write(bodies, unknown.begin());
    return unknown;
}


void Foam::fsbi::coupledSystem::unpack
(
    const scalarList& unknown, scalarList& x
)
{
    std::copy_n(unknown.begin(), layout_.nFluid(), x.begin());
    const systemLayout::whole bodies(layout_.read(unknown.cdata()));
    forAll(elastic_, e)
    {
        elasticRows& body = *elastic_[e];
        std::copy_n
        (
            unknown.begin() + layout_.elastic(e), body.x->size(),
            body.x->begin()
        );
        body.tether = bodies.tethers[e];
    }
    forAll(bodies.velocities, b)
    {
        (*bodies_)[b].velocity = bodies.velocities[b];
    }
}
