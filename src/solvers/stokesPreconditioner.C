/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stokesPreconditioner.H"
#include "compactLaplacian.H"
#include "gapDrag.H"

namespace Foam
{
namespace fsbi
{

//- Add what mass fluxes [M/T], by faces of the mesh, carry out of cells, as if
//  all were carried from upwind: rows stay dominated by their diagonals
static void addUpwind
(
    const meshStencil& stencil,
    const scalarField& massFlux,
    const globalIndex& rows,
    compactEntries& entries
)
{
    const label n = stencil.mesh().nCells();
    scalarList column(n + stencil.halo().size());
    for (label i = 0; i < n; ++i)
    {
        column[i] = rows.toGlobal(i);
    }
    stencil.halo().fill(column.data(), 1);
    const labelList faces(stencil.meshFaces());
    const auto add = [&](const label P, const label N, const scalar flux)
    {
        entries.add(column[P], column[P], max(flux, scalar(0)));
        entries.add(column[P], column[N], min(flux, scalar(0)));
    };
    forAll(faces, i)
    {
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        add(P, N, massFlux[faces[i]]);
        if (N < n)
        {
            add(N, P, -massFlux[faces[i]]);
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


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
        elastic_.append(new elasticBlock(*body, momentum_, nRows_));
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
    addLaplacian(stokes_.stencil(), stokes_.viscosities(), rows, entries);
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
    addConvection(rows, entries);
}


void Foam::fsbi::stokesPreconditioner::addConvection
(
    const globalIndex& rows, compactEntries& entries
) const
{
    const scalarField flux(momentum_.massFlux());
    if (flux.empty())
    {
        return;
    }
    addUpwind(stokes_.stencil(), flux, rows, entries);
    forAll(stokes_.velocityGiven(), i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        if
        (
            !stokes_.velocityGiven()[i]
         && !mesh_.boundaryMesh()[patchi].coupled()
        )
        {
            const label row = rows.toGlobal(mesh_.faceOwner()[facei]);
            entries.add(row, row, max(flux[facei], scalar(0)));
        }
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
        entries.create
        (
            PETSC_COMM_WORLD, nRows_, matrix_, solution_, source_,
            momentum_.massFlux().empty()
        );
    }
    entries.fill(matrix_);
}


void Foam::fsbi::stokesPreconditioner::rebuild()
{
    setMatrix();
    volume_ = gSum(mesh_.cellVolumes());
    room_ = 0;
    if (stokes_.closed())
    {
        for (const elasticBlock& body : elastic_)
        {
            room_ += body.room();
        }
    }
    const scalarField carried(momentum_.massFlux());
    createCycle(matrix_, cycle_, carried.empty());
    dragged_.clear();
    scalarField drag(max(gapDrag(stokes_), channelDrag(stokes_)));
    if (momentum_.massRate().size())
    {
        drag += momentum_.massRate()/mesh_.cellVolumes();
    }
    if (gMax(drag) > 0 || carried.size())
    {
        dragged_.reset(new draggedPressure(stokes_, drag, carried));
    }
}


void Foam::fsbi::stokesPreconditioner::setPressure(const scalar* r) const
{
    const scalarField& V = mesh_.cellVolumes();
    const label n = mesh_.nCells();
    scalar surplus = 0;
    for (label i = 0; room_ > 0 && i < n; ++i)
    {
        surplus += r[4*i + 3];
    }
    if (room_ > 0)
    {
        reduce(surplus, sumOp<scalar>());
    }
    for (label i = 0; i < n; ++i)
    {
        pressure_[i] =
            stokes_.viscosity(i)*(r[4*i + 3]/V[i] - surplus/volume_);
    }
    if (dragged_)
    {
        dragged_->apply(pressure_);
    }
    for (label i = 0; room_ > 0 && i < n; ++i)
    {
        pressure_[i] += surplus/room_;
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

    setPressure(r);
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
