/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "systemLayout.H"
#include "petscObjects.H"
#include "Pstream.H"

Foam::fsbi::systemLayout::systemLayout
(
    const label nCells,
    const UList<elasticRows*>& elastic,
    const label nRigid
)
:
    starts_(elastic.size() + 1, 4*nCells),
    nRigid_(nRigid)
{
    forAll(elastic, e)
    {
        starts_[e + 1] = starts_[e] + elastic[e]->elastic->size();
        if (elastic[e]->tethered())
        {
            tethered_.append(e);
        }
    }
}


Foam::label Foam::fsbi::systemLayout::size() const
{
    return nDistributed() + (Pstream::master() ? nWhole() : 0);
}


Foam::fsbi::systemLayout::whole
Foam::fsbi::systemLayout::read(const scalar* x) const
{
    scalarList numbers(nWhole());
    if (Pstream::master())
    {
        std::copy_n(x + nDistributed(), numbers.size(), numbers.begin());
    }
    if (numbers.size())
    {
        MPI_Bcast
        (
            numbers.data(), numbers.size(), MPI_DOUBLE, 0, PETSC_COMM_WORLD
        );
    }
    whole bodies
    {
        List<sixVector>(nRigid_), vectorField(starts_.size() - 1, Zero)
    };
    const scalar* at = numbers.cdata();
    for (sixVector& v : bodies.velocities)
    {
        std::copy_n(at, 6, v.begin());
        at += 6;
    }
    for (const label e : tethered_)
    {
        std::copy_n(at, 3, bodies.tethers[e].begin());
        at += 3;
    }
    return bodies;
}


void Foam::fsbi::systemLayout::write(const whole& bodies, scalar* x) const
{
    if (!Pstream::master())
    {
        return;
    }
    x += nDistributed();
    for (const sixVector& v : bodies.velocities)
    {
        x = std::copy_n(v.begin(), 6, x);
    }
    for (const label e : tethered_)
    {
        x = std::copy_n(bodies.tethers[e].begin(), 3, x);
    }
}
