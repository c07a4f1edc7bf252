/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesPreconditioner.H"
#include "compactLaplacian.H"
#include "gapDrag.H"

Foam::fsbi::stokesPreconditioner::stokesPreconditioner
(
    const fvMesh& mesh,
    const momentumEquation& momentum,
    const UList<elasticRows*>& elastic
)
:
    mesh_(mesh),
    momentum_(momentum),
    stokes_(momentum.viscous()),
    nRows_(mesh.nCells()),
    pressure_(mesh.nCells() + momentum.viscous().stencil().halo().size())
{
    for (const elasticRows* body : elastic)
    {
        elastic_.append(new elasticBlock(*body, stokes_, nRows_));
        elasticSize_.append(body->elastic->size());
        nRows_ += elastic_.last().nRows();
    }
    velocity_.setSize(nRows_);
}


void Foam::fsbi::stokesPreconditioner::addFluid
(
    const globalIndex& rows, compactEntries& entries
) const
{
    addLaplacian
    (
        stokes_.stencil(), scalarField(mesh_.nCells(), stokes_.mu()), rows,
        entries
    );
    forAll(stokes_.velocityGiven(), i)
    {
        if (stokes_.velocityGiven()[i])
        {
            const label facei = mesh_.nInternalFaces() + i;
            const label row = rows.toGlobal(mesh_.faceOwner()[facei]);
            entries.add(row, row, stokes_.wallCoeff(i));
        }
    }
    forAll(momentum_.massRate(), i)
    {
        const label row = rows.toGlobal(i);
        entries.add(row, row, momentum_.massRate()[i]);
    }
}


void Foam::fsbi::stokesPreconditioner::setMatrix()
{
    const globalIndex rows(nRows_);
    compactEntries entries;
    addFluid(rows, entries);
    for (elasticBlock& body : elastic_)
    {
        body.addEntries(rows, entries);
    }
    if (!matrix_)
    {
        entries.create(PETSC_COMM_WORLD, nRows_, matrix_, solution_, source_);
    }
    entries.fill(matrix_);
}


void Foam::fsbi::stokesPreconditioner::rebuild()
{
    setMatrix();
    createCycle(matrix_, cycle_);
    dragged_.clear();
    scalarField drag(max(gapDrag(stokes_), channelDrag(stokes_)));
    if (momentum_.massRate().size())
    {
        drag += momentum_.massRate()/mesh_.cellVolumes();
    }
    if (gMax(drag) > 0)
    {
        dragged_.reset(new draggedPressure(stokes_, drag));
    }
}


void Foam::fsbi::stokesPreconditioner::setForce
(
    const scalar* r, vectorField& force
) const
{
    const label n = mesh_.nCells();
    const meshStencil& stencil = stokes_.stencil();
    for (label i = 0; i < n; ++i)
    {
        force[i] = vector(r[4*i], r[4*i + 1], r[4*i + 2]);
    }
    forAll(stencil.owner(), i)
    {
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        const vector push
        (
            0.5*(pressure_[P] + pressure_[N])*stencil.area()[i]
        );
        force[P] -= push;
        if (N < n)
        {
            force[N] += push;
        }
    }
    forAll(stokes_.velocityGiven(), i)
    {
        if (stokes_.velocityGiven()[i])
        {
            const label facei = mesh_.nInternalFaces() + i;
            const label P = mesh_.faceOwner()[facei];
            force[P] -= pressure_[P]*mesh_.faceAreas()[facei];
        }
    }
}


void Foam::fsbi::stokesPreconditioner::apply
(
    const scalar* r,
    scalar* z
) const
{
    const label n = mesh_.nCells();
    const scalarField& V = mesh_.cellVolumes();

    for (label i = 0; i < n; ++i)
    {
        pressure_[i] = stokes_.mu()/V[i]*r[4*i + 3];
    }
    if (dragged_)
    {
        dragged_->apply(pressure_);
    }
    stokes_.stencil().halo().fill(pressure_.data(), 1);

    vectorField& force = velocity_;
    setForce(r, force);
    label start = 4*n;
    forAll(elastic_, e)
    {
        elastic_[e].begin(r + start, pressure_, z + start, force);
        start += elasticSize_[e];
    }

    for (label k = 0; k < 3; ++k)
    {
        solveComponent
        (
            cycle_, source_, solution_, 3, velocity_.begin()->v_ + k
        );
    }
    for (label i = 0; i < n; ++i)
    {
        z[4*i] = velocity_[i].x();
        z[4*i + 1] = velocity_[i].y();
        z[4*i + 2] = velocity_[i].z();
        z[4*i + 3] = pressure_[i];
    }
    start = 4*n;
    forAll(elastic_, e)
    {
        elastic_[e].end(r + start, velocity_, z + start);
        start += elasticSize_[e];
    }
}
