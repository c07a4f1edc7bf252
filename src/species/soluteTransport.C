/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soluteTransport.H"
#include "faceGradient.H"
#include "matrixFreeKrylov.H"

namespace Foam
{
namespace fsbi
{

//- Corrections of c, and its change, over the largest, after which limits stay
static const label mostCorrections = 10;
static const scalar sameConcentration = 1e-6;

static const label mostIterations = 300;

//- Part of the residual to which iterations can bring it, and of what fluxes
//  add up to: digits
static const scalar least = 1e-9;
static const scalar digits = 1e-13;
static const label restart = 40;

//- Of the preconditioner's equations
static const scalar roughly = 0.02;
static const label roughIterations = 100;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::soluteTransport::soluteTransport
(
    const meshStencil& stencil,
    const relativeFlux& flux,
    const scalar diffusivity,
    const scalar decay,
    const scalar dt,
    const scalarField& amounts
)
:
    stencil_(stencil),
    flux_(flux),
    D_(diffusivity),
    decay_(decay),
    dt_(dt),
    before_(amounts),
    gradients_(stencil),
    c_(stencil.mesh().nCells() + stencil.halo().size(), Zero),
    limits_(c_.size(), 1),
    walls_(flux.boundary().size(), oneSided),
    through_(flux.boundary().size(), Zero),
    atWall_(flux.boundary().size(), Zero)
{}


Foam::fsbi::soluteTransport::derivative
Foam::fsbi::soluteTransport::normal(const label i) const
{
    const fvMesh& mesh = stencil_.mesh();
    const label facei = mesh.nInternalFaces() + i;
    const label P = mesh.faceOwner()[facei];
    const vector d(mesh.faceCentres()[facei] - mesh.cellCentres()[P]);
    const vector n(mesh.faceAreas()[facei]/mag(mesh.faceAreas()[facei]));
    const scalar w = stencil_.wallWeight()[i];
    const scalar h = n & d;
    if (walls_[i] == twoPoint)
    {
        return {1/h, c_[P]/h};
    }
    const scalar along = n & g_[P];
    const scalar beside = c_[P] + (d & g_[P]) - h*along;
    return {w/h, w*beside/h - (1 - w)*along};
}


void Foam::fsbi::soluteTransport::setMatrix()
{
    const fvMesh& mesh = stencil_.mesh();
    firstOrder_.reset(new cellMatrix(stencil_, false));
    cellMatrix& M = firstOrder_();
    const scalarField& V = mesh.cellVolumes();
    forAll(V, celli)
    {
        M.addDiagonal(celli, V[celli]*(1 + decay_*dt_));
    }
    forAll(flux_.inner(), i)
    {
        const scalar g = dt_*D_*faceGradient
        (
            stencil_.area()[i], stencil_.fromOwner()[i],
            stencil_.fromNeighbour()[i]
        ).compact();
        const scalar out = dt_*max(flux_.inner()[i], scalar(0));
        const scalar in = dt_*min(flux_.inner()[i], scalar(0));
        M.setFace(i, out + g, in - g, -out - g, g - in);
    }
    forAll(law_->kinds, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const label P = mesh.faceOwner()[facei];
        const scalar S = mag(mesh.faceAreas()[facei]);
        const boundaryLaw::kind kind = law_->kinds[i];
        if (kind == boundaryLaw::open || kind == boundaryLaw::fixed)
        {
            M.addDiagonal(P, dt_*max(flux_.boundary()[i], scalar(0)));
        }
        if (kind == boundaryLaw::fixed)
        {
            M.addDiagonal(P, dt_*D_*S*normal(i).slope);
        }
        if (kind == boundaryLaw::exchange)
        {
            const scalar across = D_*normal(i).slope;
            M.addDiagonal
            (
                P, dt_*S*law_->a[i]*across/(law_->a[i] + across + VSMALL)
            );
        }
    }
}


void Foam::fsbi::soluteTransport::addInner(scalar* r) const
{
    const label nCells = stencil_.mesh().nCells();
    forAll(flux_.inner(), i)
    {
        const vector& S = stencil_.area()[i];
        const vector& rP = stencil_.fromOwner()[i];
        const vector& rN = stencil_.fromNeighbour()[i];
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const faceGradient face(S, rP, rN);
        const scalar phi = flux_.inner()[i];
        const scalar upwind =
            phi > 0
          ? c_[P] + limits_[P]*(g_[P] & rP)
          : c_[N] + limits_[N]*(g_[N] & rN);
        const vector H
        (
            face.gradient(c_[P], c_[N], g_[P].cdata(), g_[N].cdata())
        );
        const scalar out = dt_*(phi*upwind - D_*(H & S));
        r[P] += out;
        if (N < nCells)
        {
            r[N] -= out;
        }
    }
}


void Foam::fsbi::soluteTransport::addBoundary(const scalar part, scalar* r)
{
    const fvMesh& mesh = stencil_.mesh();
    forAll(law_->kinds, i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const label P = mesh.faceOwner()[facei];
        const scalar S = mag(mesh.faceAreas()[facei]);
        const scalar phi = flux_.boundary()[i];
        const scalar given = part*law_->value[i];
        scalar& wall = atWall_[i];
        scalar& out = through_[i];
        switch (law_->kinds[i])
        {
            case boundaryLaw::closed:
                wall = c_[P];
                out = 0;
                break;
            case boundaryLaw::open:
                wall = phi < 0 ? given : c_[P];
                out = phi*wall;
                break;
            case boundaryLaw::fixed:
            {
                const derivative d(normal(i));
                wall = given;
                out = phi*(phi < 0 ? given : c_[P])
                  - D_*S*(d.slope*given - d.offset);
                break;
            }
            case boundaryLaw::exchange:
            {
                const derivative d(normal(i));
                const scalar a = law_->a[i], b = part*law_->b[i];
                wall =
                    walls_[i] == zero
                  ? 0
                  : (b + D_*d.offset)/(a + D_*d.slope);
                out = S*(a*wall - b);
            }
        }
        r[P] += dt_*out;
    }
}


void Foam::fsbi::soluteTransport::residual
(
    const scalar* c, const scalar part, scalar* r
)
{
    const scalarField& V = stencil_.mesh().cellVolumes();
    std::copy_n(c, V.size(), c_.begin());
    stencil_.halo().fill(c_.data(), 1);
    gradients_.set(c_, part, g_);
    forAll(V, celli)
    {
        r[celli] = V[celli]*c[celli]*(1 + decay_*dt_) - part*before_[celli];
    }
    addInner(r);
    addBoundary(part, r);
}


Foam::scalar Foam::fsbi::soluteTransport::norm(const scalarField& x)
{
    return sqrt(gSumSqr(x));
}


Foam::fsbi::outcome Foam::fsbi::soluteTransport::correct
(
    const scalarField& r, const scalar fall, scalarField& dc
)
{
    const label n = r.size();
    matrixFreeKrylov krylov
    (
        n, "species_", restart, true,
        [this](const scalar* x, scalar* y) { residual(x, 0, y); },
        [this, n](const scalar* x, scalar* y)
        {
            scalarField rhs(n), z(n, Zero);
            std::copy_n(x, n, rhs.begin());
            firstOrder_->solve(z, rhs, roughly, roughIterations);
            std::copy_n(z.cbegin(), n, y);
        }
    );
    dc = scalarField(n, Zero);
    const matrixFreeKrylov::outcome solved
    (
        krylov.solve(r.cdata(), dc.begin(), fall, mostIterations)
    );
    return
        solved.converged
      ? outcome()
      : outcome::failed
        (
            "the equations of a species are left with "
          + Foam::name(solved.residual) + " of their residual after "
          + Foam::name(solved.iterations) + " iterations"
        );
}


void Foam::fsbi::soluteTransport::setLimits(const scalarField& c)
{
    scalarField r(c.size());
    walls_ = oneSided;
    residual(c.cdata(), 1, r.begin());
    limits_ = gradients_.limits(c_, g_);
    setWalls();
}


void Foam::fsbi::soluteTransport::setWalls()
{
    const labelList& owner = stencil_.mesh().faceOwner();
    forAll(walls_, i)
    {
        // what flows out of a cell must, or nothing balances what flows in
        if
        (
            law_->kinds[i] == boundaryLaw::exchange
         && max(law_->b[i], scalar(0)) + D_*normal(i).offset < 0
        )
        {
            const scalar c = c_[owner[stencil_.mesh().nInternalFaces() + i]];
            walls_[i] = c < 0 ? zero : twoPoint;
        }
    }
}


Foam::fsbi::outcome Foam::fsbi::soluteTransport::solve
(
    const boundaryLaw& law,
    const scalar tolerance,
    const bool newLimits,
    scalarField& c
)
{
    law_ = &law;
    boolList fixed(law.kinds.size());
    forAll(fixed, i)
    {
        fixed[i] = law.kinds[i] == boundaryLaw::fixed;
    }
    gradients_.give(fixed, law.value);
    g_.setSize(c_.size(), Zero);
    setMatrix();
    const scalarField& V = stencil_.mesh().cellVolumes();
    scalarField r(c.size()), dc;
    bool settled = !newLimits;
    for (label k = 0; k < mostCorrections; ++k)
    {
        if (!settled)
        {
            setLimits(c);
        }
        residual(c.cdata(), 1, r.begin());
        if (k == 0 && settled)
        {
            // walls that another law would make negative
            setWalls();
            residual(c.cdata(), 1, r.begin());
        }
        const scalar size = norm(r);
        const scalar wanted = max
        (
            tolerance*norm(scalarField(V*c)),
            digits*norm(scalarField(firstOrder_->diagonal()*c))
        );
        if (size <= max(wanted, VSMALL))
        {
            break;
        }
        const scalar fall = min(max(wanted/size, least), tolerance);
        const outcome solved(correct(r, settled ? fall : tolerance, dc));
        if (!solved)
        {
            return solved;
        }
        c -= dc;
        settled =
            settled || gMax(mag(dc)()) <= sameConcentration*gMax(mag(c)());
    }
    residual(c.cdata(), 1, r.begin());
    left_ = norm(r)/max(norm(scalarField(V*c)), VSMALL);
    return outcome();
}


Foam::scalarField Foam::fsbi::soluteTransport::amounts
(
    scalar& decayed
) const
{
    const fvMesh& mesh = stencil_.mesh();
    scalarField gone(mesh.nCells(), Zero);
    addInner(gone.data());
    forAll(through_, i)
    {
        gone[mesh.faceOwner()[mesh.nInternalFaces() + i]] += dt_*through_[i];
    }
    const scalarField there((before_ - gone)/(1 + decay_*dt_));
    decayed = decay_*dt_*gSum(there);
    return there;
}
