/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "bodyCoupling.H"
#include "checkedDictionary.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

//- Growth of the iterations that makes a new hierarchy worth its price
static const Foam::scalar renewAbove = 1.3;


Foam::fsbi::coupledSystem::coupledSystem
(
    const fvMesh& mesh,
    const stokesOperator& stokes,
    const dictionary& dict
)
:
    mesh_(mesh),
    stokes_(stokes),
    preconditioner_(mesh, stokes),
    traction_(stokes.nBoundaryFaces(), Zero),
    freshIterations_(0)
{
    const checkedDictionary entries(dict);
    entries.found("method");
    entries.found("faceValues");
    tolerance_ = entries.positive("tolerance", 1e-6);
    maxIterations_ = entries.getOrDefault<label>("maxIterations", 300);
    entries.finish();

    closed_ = stokes.closed();
}


void Foam::fsbi::coupledSystem::createKrylov(const label nBodies)
{
    const label nCells = mesh_.nCells();
    const label nRows = 4*nCells + (Pstream::master() ? 6*nBodies : 0);
    krylov_.reset
    (
        new matrixFreeKrylov
        (
            nRows, "fsbiKrylov_", 60,
            [this](const scalar* x, scalar* y){ residual(x, y, true); },
            [this](const scalar* r, scalar* z){ precondition(r, z); }
        )
    );
    if (!closed_)
    {
        return;
    }
    krylov_->setNullVector([=](scalar* values)
    {
        std::fill_n(values, nRows, scalar(0));
        for (label i = 0; i < nCells; ++i)
        {
            values[4*i + 3] = 1;
        }
    });
}


Foam::List<Foam::fsbi::sixVector>
Foam::fsbi::coupledSystem::readBodies(const scalar* x) const
{
    List<sixVector> v(bodies_->size());
    forAll(v, b)
    {
        if (Pstream::master())
        {
            std::copy_n(x + 4*mesh_.nCells() + 6*b, 6, v[b].begin());
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
        std::copy_n(v[b].begin(), 6, x + 4*mesh_.nCells() + 6*b);
    }
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
    const List<sixVector> v(readBodies(x));
    setBodyVelocities(stokes_, *bodies_, v, values_);

    stokes_.residual(x, values_, r, traction_);
    if (!homogeneous)
    {
        forAll(*force_, i)
        {
            for (label k = 0; k < 3; ++k)
            {
                r[4*i + k] -= (*force_)[i][k];
            }
        }
    }
    scales_.apply(r);

    List<sixVector> bodyR
    (
        bodyDefects
        (
            *bodies_, v, bodyLoads(mesh_, *bodies_, traction_), homogeneous
        )
    );
    forAll(bodyR, b)
    {
        forAll(bodyR[b], k)
        {
            bodyR[b][k] *= -scales_.bodies()[b][k];
        }
    }
    writeBodies(bodyR, r);
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
    List<sixVector> v(readBodies(r));
    forAll(v, b)
    {
        for (label k = 3; k < 6; ++k)
        {
            v[b][k] /= (*bodies_)[b].radius;
        }
    }
    values_.faces = Zero;
    values_.vertices = Zero;
    setBodyVelocities(stokes_, *bodies_, v, values_);
    forAll(v, b)
    {
        for (const label i : (*bodies_)[b].faces)
        {
            const label facei = mesh_.nInternalFaces() + i;
            const scalar k = preconditioner_.wallCoeff(i);
            const vector& u = values_.faces[i];
            scalar* row = state_.begin() + 4*mesh_.faceOwner()[facei];
            row[0] += k*u.x();
            row[1] += k*u.y();
            row[2] += k*u.z();
            row[3] -= u & mesh_.faceAreas()[facei];
        }
    }

    preconditioner_.apply(state_.cdata(), z);
    writeBodies(v, z);
}


Foam::fsbi::solverReport Foam::fsbi::coupledSystem::solve
(
    const boundaryValues& given,
    const vectorField& force,
    UList<bodyRows>& bodies,
    scalarList& x,
    vectorField& traction
)
{
    const label n = mesh_.nCells();
    given_ = &given;
    force_ = &force;
    bodies_ = &bodies;
    values_ = given;
    scales_ = rowScales(stokes_, bodies);
    state_.setSize(4*n);
    result_.setSize(4*n + (Pstream::master() ? 6*bodies.size() : 0));
    if (!krylov_)
    {
        createKrylov(bodies.size());
    }
    if (!freshIterations_)
    {
        preconditioner_.rebuild();
    }

    // right-hand side: minus the residual at rest
    scalarList rhs(result_.size());
    result_ = Zero;
    residual(result_.cdata(), rhs.begin(), false);
    forAll(rhs, i)
    {
        rhs[i] = -rhs[i];
    }

    List<sixVector> v(bodies.size());
    forAll(v, b)
    {
        v[b] = bodies[b].velocity;
    }
    scalarList unknown(result_.size());
    std::copy_n(x.begin(), 4*n, unknown.begin());
    writeBodies(v, unknown.begin());

    const matrixFreeKrylov::outcome outcome
    (
        krylov_->solve
        (
            rhs.cdata(), unknown.begin(), tolerance_, maxIterations_
        )
    );
    solverReport report;
    report.iterations = outcome.iterations;
    report.residual = outcome.residual;
    report.converged = outcome.converged;

    residual(unknown.cdata(), result_.data(), false);
    v = readBodies(unknown.cdata());
    std::copy_n(unknown.begin(), 4*n, x.begin());
    forAll(v, b)
    {
        bodies[b].velocity = v[b];
    }
    traction = traction_;

    if (!freshIterations_)
    {
        freshIterations_ = max(report.iterations, 1);
    }
    else if (report.iterations > renewAbove*freshIterations_)
    {
        freshIterations_ = 0;           // the next solution builds a new one
    }
    return report;
}
