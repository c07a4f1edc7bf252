/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "draggedPressure.H"
#include "compactLaplacian.H"
#include "mathematicalConstants.H"

Foam::fsbi::draggedPressure::draggedPressure
(
    const stokesOperator& stokes,
    const scalarField& drag,
    const scalarField& massFlux
)
:
    stokes_(stokes),
    work_(drag.size())
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    const scalarField& V = mesh.cellVolumes();
    const label n = V.size();
    const globalIndex rows(n);
    const scalar slowest = sqr(constant::mathematical::pi/mag(mesh.bounds().span()));
    // where terms leave cells without a rate, viscosity alone counts, which has
    // one on every scale
    const scalarField rate(max(drag, stokes_.mu()*slowest));
    perRate_ = 1/rate;
    if (massFlux.size())
    {
        massFlux_ = scalarField(massFlux, stokes_.stencil().meshFaces());
    }
    const scalarField D(V/scalarField(stokes_.diagonal()));
    const scalar least = stokes_.closed() ? slowest : 0;
    compactEntries entries;
    addLaplacian(stokes_.stencil(), perRate_, rows, entries);
    addOpenPatches(perRate_, rows, entries);
    for (label i = 0; i < n; ++i)
    {
        entries.add(rows.toGlobal(i), rows.toGlobal(i), least*V[i]/rate[i]);
    }
    entries.create(PETSC_COMM_WORLD, n, laplacian_, solution_, source_);
    entries.fill(laplacian_);
    createCycle(laplacian_, laplacianCycle_);

    const SubList<scalar> stabilisation(stokes_.stabilisation(), n);
    compactEntries smooth;
    addLaplacian
    (
        stokes_.stencil(), 1.5*stokes_.mu()*rate*D*stabilisation, rows, smooth
    );
    for (label i = 0; i < n; ++i)
    {
        smooth.add(rows.toGlobal(i), rows.toGlobal(i), V[i]);
    }
    smooth.create(PETSC_COMM_WORLD, n, smoother_, solution_, source_);
    smooth.fill(smoother_);
    createCycle(smoother_, smootherCycle_);
}


void Foam::fsbi::draggedPressure::addOpenPatches
(
    const scalarField& coefficient,
    const globalIndex& rows,
    compactEntries& entries
) const
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    forAll(stokes_.velocityGiven(), i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const polyBoundaryMesh& patches = mesh.boundaryMesh();
        if
        (
            !stokes_.velocityGiven()[i]
         && !patches[patches.whichPatch(facei)].coupled()
        )
        {
            const label P = mesh.faceOwner()[facei];
            const label row = rows.toGlobal(P);
            entries.add
            (
                row, row, coefficient[P]*stokes_.wallCoeff(i)/stokes_.mu()
            );
        }
    }
}


void Foam::fsbi::draggedPressure::apply(scalarList& pressure) const
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
    if (massFlux_.size())
    {
        addCarried(pressure);
    }
}


void Foam::fsbi::draggedPressure::addCarried(scalarList& pressure) const
{
    const meshStencil& stencil = stokes_.stencil();
    const scalarField& V = stencil.mesh().cellVolumes();
    scalarList f(V.size() + stencil.halo().size());
    forAll(V, i)
    {
        f[i] = perRate_[i]*work_[i];
    }
    stencil.halo().fill(f.data(), 1);
    forAll(massFlux_, i)
    {
        const label P = stencil.owner()[i];
        const label N = stencil.neighbour()[i];
        if (massFlux_[i] < 0)
        {
            pressure[P] += massFlux_[i]*(f[N] - f[P])/V[P];
        }
        else if (N < V.size())
        {
            pressure[N] -= massFlux_[i]*(f[P] - f[N])/V[N];
        }
    }
}
