/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inertialPressure.H"
#include "globalIndex.H"
#include "mathematicalConstants.H"

Foam::fsbi::inertialPressure::inertialPressure
(
    const momentumEquation& momentum
)
:
    stokes_(momentum.viscous()),
    work_(momentum.massRate().size())
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    const scalarField& V = mesh.cellVolumes();
    const label n = V.size();
    const globalIndex rows(n);
    const scalarField rate(momentum.massRate()/V);
    const scalarField D(V/scalarField(stokes_.diagonal()));

    const scalar longest = mag(mesh.bounds().span());
    const scalar least =
        stokes_.closed() ? sqr(constant::mathematical::pi/longest) : 0;
    compactEntries entries;
    addLaplacian(1/rate, true, entries);
    for (label i = 0; i < n; ++i)
    {
        entries.add(rows.toGlobal(i), rows.toGlobal(i), least*V[i]/rate[i]);
    }
    entries.create(PETSC_COMM_WORLD, n, laplacian_, solution_, source_);
    entries.fill(laplacian_);
    createCycle(laplacian_, laplacianCycle_);

    compactEntries smooth;
    addLaplacian(1.5*stokes_.mu()*rate*D*SubList<scalar>(stokes_.stabilisation(), n), false, smooth);
    for (label i = 0; i < n; ++i)
    {
        smooth.add(rows.toGlobal(i), rows.toGlobal(i), V[i]);
    }
    smooth.create(PETSC_COMM_WORLD, n, smoother_, solution_, source_);
    smooth.fill(smoother_);
    createCycle(smoother_, smootherCycle_);
}


void Foam::fsbi::inertialPressure::addLaplacian
(
    const scalarField& coefficient,
    const bool open,
    compactEntries& entries
) const
{
    const meshStencil& stencil = stokes_.stencil();
    const fvMesh& mesh = stencil.mesh();
    const label n = mesh.nCells();
    const globalIndex rows(n);
    scalarList column(n + stencil.halo().size());
    scalarList values(column.size());
    for (label i = 0; i < n; ++i)
    {
        column[i] = rows.toGlobal(i);
        values[i] = coefficient[i];
    }
    stencil.halo().fill(column.data(), 1);
    stencil.halo().fill(values.data(), 1);
    forAll(stencil.owner(), i)
    {
        const faceGradient face
        (
            stencil.area()[i], stencil.fromOwner()[i],
            stencil.fromNeighbour()[i]
        );
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        const scalar k = 0.5*(values[P] + values[N])*face.compact();
        entries.link(column[P], column[N], k);
        if (N < n)
        {
            entries.link(column[N], column[P], k);
        }
    }
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label k = 0; open && !pp.coupled() && k < pp.size(); ++k)
        {
            const label i = pp.start() + k - mesh.nInternalFaces();
            const label P = pp.faceCells()[k];
            if (!stokes_.velocityGiven()[i])
            {
                entries.add
                (
                    column[P], column[P],
                    coefficient[P]*stokes_.wallCoeff(i)/stokes_.mu()
                );
            }
        }
    }
}


void Foam::fsbi::inertialPressure::apply(scalarList& pressure) const
{
    const scalarField& V = stokes_.stencil().mesh().cellVolumes();
    const scalar mu = stokes_.mu();
    forAll(work_, i)
    {
        pressure[i] *= V[i];
    }
    solveComponent(smootherCycle_, source_, solution_, 1, pressure.data());
    forAll(work_, i)
    {
        work_[i] = V[i]/mu*pressure[i];
    }
    solveComponent(laplacianCycle_, source_, solution_, 1, work_.data());
    forAll(work_, i)
    {
        pressure[i] += work_[i];
    }
}
