/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "Pstream.H"

Foam::label Foam::fsbi::coupledSystem::nCellRows() const
{
    label n = 4*mesh_.nCells();
    for (const elasticRows* body : elastic_)
    {
        n += body->elastic->size();
    }
    return n;
}


Foam::label Foam::fsbi::coupledSystem::nTethers() const
{
    label n = 0;
    for (const elasticRows* body : elastic_)
    {
        n += body->tethered();
    }
    return n;
}


Foam::List<Foam::fsbi::sixVector>
Foam::fsbi::coupledSystem::readBodies(const scalar* x) const
{
    List<sixVector> v(bodies_->size());
    forAll(v, b)
    {
        if (Pstream::master())
        {
            std::copy_n(x + nCellRows() + 6*b, 6, v[b].begin());
        }
        MPI_Bcast(v[b].data(), 6, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
    }
    return v;
}


void Foam::fsbi::coupledSystem::writeBodies
(
    const UList<sixVector>& v,
    scalar* x
) const
{
    for (label b = 0; Pstream::master() && b < v.size(); ++b)
    {
        std::copy_n(v[b].begin(), 6, x + nCellRows() + 6*b);
    }
}


Foam::vectorField Foam::fsbi::coupledSystem::readTethers
(
    const scalar* x
) const
{
    vectorField f(elastic_.size(), Zero);
    if (Pstream::master())
    {
        const scalar* at = x + nCellRows() + 6*bodies_->size();
        forAll(f, e)
        {
            if (elastic_[e]->tethered())
            {
                std::copy_n(at, 3, f[e].begin());
                at += 3;
            }
        }
    }
    if (nTethers())
    {
        MPI_Bcast
        (
            f.data()->v_, 3*f.size(), MPI_DOUBLE, 0, PETSC_COMM_WORLD
        );
    }
    return f;
}


void Foam::fsbi::coupledSystem::writeTethers
(
    const UList<vector>& f, scalar* x
) const
{
    scalar* at = x + nCellRows() + 6*bodies_->size();
    for (label e = 0; Pstream::master() && e < f.size(); ++e)
    {
        if (elastic_[e]->tethered())
        {
            at = std::copy_n(f[e].begin(), 3, at);
        }
    }
}


Foam::scalarList Foam::fsbi::coupledSystem::packed(const scalarList& x) const
{
    scalarList unknown(result_.size());
    scalar* at = std::copy_n(x.begin(), 4*mesh_.nCells(), unknown.begin());
    for (const elasticRows* body : elastic_)
    {
        at = std::copy(body->x->begin(), body->x->end(), at);
    }
    List<sixVector> v(bodies_->size());
    forAll(v, b)
    {
        v[b] = (*bodies_)[b].velocity;
    }
    writeBodies(v, unknown.begin());
    vectorField tethers(elastic_.size());
    forAll(tethers, e)
    {
        tethers[e] = elastic_[e]->tether;
    }
    writeTethers(tethers, unknown.begin());
    return unknown;
}


void Foam::fsbi::coupledSystem::unpack
(
    const scalarList& unknown, scalarList& x
)
{
    const label n = 4*mesh_.nCells();
    std::copy_n(unknown.begin(), n, x.begin());
    const scalar* at = unknown.begin() + n;
    for (elasticRows* body : elastic_)
    {
        std::copy_n(at, body->x->size(), body->x->begin());
        at += body->x->size();
    }
    const List<sixVector> v(readBodies(unknown.cdata()));
    forAll(v, b)
    {
        (*bodies_)[b].velocity = v[b];
    }
    const vectorField tethers(readTethers(unknown.cdata()));
    forAll(tethers, e)
    {
        elastic_[e]->tether = tethers[e];
    }
}
