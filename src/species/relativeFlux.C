/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "relativeFlux.H"
#include "cellMatrix.H"
#include "fluidRegion.H"

namespace Foam
{
namespace fsbi
{

//- Part of the largest flux that is no more than digits
static const scalar fluxDigits = 1e-12;

//- By how much what is missing in cells falls in a correction; the second one
//  begins with what digits the first has left
static const scalar fall = 1e-10;
static const label corrections = 2;

static const label mostFluxIterations = 3000;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::relativeFlux::relativeFlux
(
    const fluidRegion& fluid,
    const meshStencil& stencil,
    const motion& from,
    const bool still
)
:
    stencil_(stencil),
    fluid_(fluid),
    inner_(stencil.owner().size(), Zero),
    boundary_(fluid.mesh().nFaces() - fluid.mesh().nInternalFaces(), Zero),
    free_(boundary_.size(), false)
{
    if (!still)
    {
        addFlow();
    }
    subtractSwept(from);
    closeWalls();
    for (label k = 0; k < corrections; ++k)
    {
        correct(missing(from));
    }
}


Foam::label Foam::fsbi::relativeFlux::meshFace(const label i) const
{
    const fvMesh& mesh = stencil_.mesh();
    const haloExchange& halo = stencil_.halo();
    const label k = i - mesh.nInternalFaces();
    if (k < 0)
    {
        return i;
    }
    label p = halo.patches().size() - 1;
    while (halo.start(p) > k)
    {
        --p;
    }
    return mesh.boundaryMesh()[halo.patches()[p]].start() + k - halo.start(p);
}


void Foam::fsbi::relativeFlux::addFlow()
{
    const stokesOperator& stokes = fluid_.stokes();
    const label n = stencil_.mesh().nCells();
    vectorField u(n + stencil_.halo().size());
    tensorField gradient(u.size());
    SubList<vector>(u, n) = fluid_.U().primitiveField();
    SubList<tensor>(gradient, n) = stokes.velocityGradients()();
    stencil_.halo().fill(reinterpret_cast<scalar*>(u.data()), 3);
    stencil_.halo().fill(reinterpret_cast<scalar*>(gradient.data()), 9);
    forAll(inner_, i)
    {
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const vector atP(u[P] + (stencil_.fromOwner()[i] & gradient[P]));
        const vector atN(u[N] + (stencil_.fromNeighbour()[i] & gradient[N]));
        inner_[i] = 0.5*((atP + atN) & stencil_.area()[i]);
    }
    const wordList open(fluid_.openPatches());
    for (const polyPatch& pp : stencil_.mesh().boundaryMesh())
    {
        const label start = pp.start() - stencil_.mesh().nInternalFaces();
        const label end = open.found(pp.name()) ? start + pp.size() : start;
        for (label i = start; i < end; ++i)
        {
            boundary_[i] = stokes.boundaryFlux()[i];
            free_[i] = !stokes.velocityGiven()[i];
        }
    }
}


void Foam::fsbi::relativeFlux::subtractSwept(const motion& from)
{
    const fvMesh& mesh = stencil_.mesh();
    const pointField& now = mesh.points();
    const auto swept = [&](const label facei)
    {
        return mesh.faces()[facei].sweptVol(from.points, now)/from.dt;
    };
    forAll(inner_, i)
    {
        inner_[i] -= swept(meshFace(i));
    }
    forAll(boundary_, i)
    {
        boundary_[i] -= swept(mesh.nInternalFaces() + i);
    }
}


void Foam::fsbi::relativeFlux::closeWalls()
{
    const fvMesh& mesh = stencil_.mesh();
    const scalar largest =
        max(gMax(mag(inner_)()), gMax(mag(boundary_)()));
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        const bool closed = pp.coupled() || fluid_.meshing().isBody(pp.name());
        const label start = pp.start() - mesh.nInternalFaces();
        for (label i = start; i < start + pp.size(); ++i)
        {
            if (closed || mag(boundary_[i]) <= fluxDigits*largest)
            {
                boundary_[i] = 0;
            }
            free_[i] = free_[i] && !closed;
        }
    }
}


Foam::scalarField Foam::fsbi::relativeFlux::missing(const motion& from)
{
    const fvMesh& mesh = stencil_.mesh();
    const scalarField& V = mesh.cellVolumes();
    scalarField lack((from.volumes - V)/from.dt);
    forAll(inner_, i)
    {
        lack[stencil_.owner()[i]] -= inner_[i];
        if (stencil_.neighbour()[i] < mesh.nCells())
        {
            lack[stencil_.neighbour()[i]] += inner_[i];
        }
    }
    scalar out = 0;
    label nFree = 0;
    forAll(boundary_, i)
    {
        lack[mesh.faceOwner()[mesh.nInternalFaces() + i]] -= boundary_[i];
        out += max(boundary_[i], scalar(0));
        nFree += free_[i];
    }
    reduce(out, sumOp<scalar>());
    if (returnReduce(nFree, sumOp<label>()))
    {
        return lack;
    }
    const scalar scale = out > 0 ? gSum(lack)/out : 0;
    forAll(boundary_, i)
    {
        const scalar more = scale*max(boundary_[i], scalar(0));
        boundary_[i] += more;
        lack[mesh.faceOwner()[mesh.nInternalFaces() + i]] -= more;
    }
    return lack - gSum(lack)/gSum(V)*V;
}


void Foam::fsbi::relativeFlux::correct(const scalarField& missing)
{
    const fvMesh& mesh = stencil_.mesh();
    cellMatrix matrix(stencil_, true);
    scalarField g(inner_.size());
    forAll(g, i)
    {
        g[i] = faceGradient
        (
            stencil_.area()[i], stencil_.fromOwner()[i],
            stencil_.fromNeighbour()[i]
        ).compact();
        matrix.setFace(i, g[i], -g[i], -g[i], g[i]);
    }
    scalarField gFree(boundary_.size(), Zero);
    forAll(free_, i)
    {
        if (free_[i])
        {
            const label facei = mesh.nInternalFaces() + i;
            const label P = mesh.faceOwner()[facei];
            const vector& S = mesh.faceAreas()[facei];
            gFree[i] = magSqr(S)
               /(S & (mesh.faceCentres()[facei] - mesh.cellCentres()[P]));
            matrix.addDiagonal(P, gFree[i]);
        }
    }
    const label n = mesh.nCells();
    scalarField q(n, Zero);
    if (gMax(mag(missing)()) > 0)
    {
        matrix.solve(q, missing, fall, mostFluxIterations);
    }
    q.setSize(n + stencil_.halo().size(), 0);
    stencil_.halo().fill(q.data(), 1);
    forAll(inner_, i)
    {
        inner_[i] -=
            g[i]*(q[stencil_.neighbour()[i]] - q[stencil_.owner()[i]]);
    }
    forAll(boundary_, i)
    {
        boundary_[i] += gFree[i]*q[mesh.faceOwner()[mesh.nInternalFaces() + i]];
    }
}
