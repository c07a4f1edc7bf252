/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "generalisedNewtonian.H"
#include "sharedVertices.H"

Foam::fsbi::generalisedNewtonian::generalisedNewtonian
(
    const fvMesh& mesh,
    const viscosityLaw& law,
    const boolList& velocityGiven,
    const schemes& s
)
:
    secondOrderStokes(mesh, law.viscosity(0), velocityGiven, s),
    law_(law),
    faces_(stencil_.meshFaces()),
    inner_(stencil_.owner().size()),
    boundary_(nBoundaryFaces())
{
    if (s.order != 2)
    {
        FatalErrorInFunction
            << "Order " << s.order << " ('coupling' of system/fluid/fvSolution)"
            << " is for fluids of type 'Newtonian'; the '" << law.type().c_str()
            << "' fluid of constant/fluid/material has order 2"
            << exit(FatalError);
    }
}


Foam::tensor Foam::fsbi::generalisedNewtonian::cellGradient
(
    const label celli
) const
{
    const scalar* g = gradients_.cdata() + 12*celli;
    return tensor(g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8]);
}


Foam::vector Foam::fsbi::generalisedNewtonian::innerPull
(
    const label i
) const
{
    const faceGradient face(faceOf(i));
    const scalar* xP = values_.cdata() + 4*stencil_.owner()[i];
    const scalar* xN = values_.cdata() + 4*stencil_.neighbour()[i];
    const scalar* gP = gradients_.cdata() + 12*stencil_.owner()[i];
    const scalar* gN = gradients_.cdata() + 12*stencil_.neighbour()[i];
    const tensor H
    (
        face.gradient(xP[0], xN[0], gP, gN),
        face.gradient(xP[1], xN[1], gP + 3, gN + 3),
        face.gradient(xP[2], xN[2], gP + 6, gN + 6)
    );
    return 2*symm(H) & stencil_.area()[i];
}


Foam::symmTensor Foam::fsbi::generalisedNewtonian::innerRate
(
    const label i
) const
{
    const face& f = mesh_.faces()[faces_[i]];
    symmTensor sum(Zero);
    for (const label v : f)
    {
        sum += vertexRates_[v];
    }
    return sum/f.size();
}


void Foam::fsbi::generalisedNewtonian::setVertexRates() const
{
    const labelList& start = stencil_.vertexStart();
    const labelList& cell = stencil_.vertexCell();
    const scalarList& weight = stencil_.vertexWeight();
    vertexRates_.setSize(mesh_.nPoints());
    forAll(vertexRates_, v)
    {
        vertexRates_[v] = Zero;
        for (label i = start[v]; i < start[v + 1]; ++i)
        {
            vertexRates_[v] += weight[i]*symm(cellGradient(cell[i]));
        }
    }
    sharedVertices::sum<6>
    (
        mesh_, vertexRates_.begin()->v_, stencil_.halo().size()
    );
}


Foam::tensor Foam::fsbi::generalisedNewtonian::boundaryGradient
(
    const label i, const vector& given
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const label P = mesh_.faceOwner()[facei];
    if (!velocityGiven_[i])
    {
        return cellGradient(P);
    }
    const scalar* x = values_.cdata() + 4*P;
    const scalar* g = gradients_.cdata() + 12*P;
    const wallGradient at(wall(facei));
    return tensor
    (
        at.gradient(x[0], given.x(), g),
        at.gradient(x[1], given.y(), g + 3),
        at.gradient(x[2], given.z(), g + 6)
    );
}


Foam::vector Foam::fsbi::generalisedNewtonian::boundaryPull
(
    const label i, const tensor& H
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const vector& S = mesh_.faceAreas()[facei];
    return velocityGiven_[i] ? (H & S) + transposedAtWall(facei) : (S & H);
}


template<class Action>
void Foam::fsbi::generalisedNewtonian::forBoundary(const Action& action) const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label start = pp.start() - mesh_.nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            action(i);
        }
    }
}


void Foam::fsbi::generalisedNewtonian::setViscosities() const
{
    const scalarField& V = mesh_.cellVolumes();
    viscosity_.setSize(V.size() + stencil_.halo().size());
    mu_ = GREAT;
    forAll(V, celli)
    {
        viscosity_[celli] =
            law_.viscosity(2*magSqr(symm(cellGradient(celli))));
        mu_ = min(mu_, viscosity_[celli]);
    }
    stencil_.halo().fill(viscosity_.data(), 1);
    reduce(mu_, minOp<scalar>());
    setDiagonal();
}


Foam::fsbi::generalisedNewtonian::sheared
Foam::fsbi::generalisedNewtonian::shearedBy
(
    const symmTensor& D, const vector& pull
) const
{
    const scalar rateSqr = 2*magSqr(D);
    return
    {
        pull, law_.viscosity(rateSqr) - mu_, 4*law_.slope(rateSqr)*D
    };
}


void Foam::fsbi::generalisedNewtonian::setSheared
(
    const boundaryValues& b
) const
{
    forAll(inner_, i)
    {
        inner_[i] = shearedBy(innerRate(i), innerPull(i));
    }
    forBoundary([&](const label i)
    {
        const tensor H(boundaryGradient(i, b.faces[i]));
        boundary_[i] = shearedBy(symm(H), boundaryPull(i, H));
    });
}


void Foam::fsbi::generalisedNewtonian::addInner
(
    const label i, const vector& t, scalar* r
) const
{
    const label N = stencil_.neighbour()[i];
    scalar* row = r + 4*stencil_.owner()[i];
    row[0] -= t.x();
    row[1] -= t.y();
    row[2] -= t.z();
    if (N < mesh_.nCells())
    {
        row = r + 4*N;
        row[0] += t.x();
        row[1] += t.y();
        row[2] += t.z();
    }
}


void Foam::fsbi::generalisedNewtonian::addBoundary
(
    const label i, const vector& t, scalar* r, vectorField& traction
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const label P = mesh_.faceOwner()[facei];
    scalar* row = r + 4*P;
    if (velocityGiven_[i])
    {
        row[0] -= t.x();
        row[1] -= t.y();
        row[2] -= t.z();
        traction[i] += t;
        return;
    }
    // the normal stress beyond that of the smallest viscosity asks for another
    // pressure, see secondOrderStokes::withTraction()
    const wallGradient at(wall(facei));
    const scalar flux = -2*stabilisation_[P]*(t & at.normal())/at.distance();
    row[3] += flux;
    boundaryFlux_[i] += flux;
}


void Foam::fsbi::generalisedNewtonian::residual
(
    const scalar* x,
    const boundaryValues& b,
    const vectorField&,
    scalar* r,
    vectorField& traction
) const
{
    setFlow(x, b);
    setVertexRates();
    setViscosities();
    setSheared(b);
    addFaces(b, r, traction);
    forAll(inner_, i)
    {
        addInner(i, inner_[i].beyond*inner_[i].pull, r);
    }
    forBoundary([&](const label i)
    {
        addBoundary(i, boundary_[i].beyond*boundary_[i].pull, r, traction);
    });
}


void Foam::fsbi::generalisedNewtonian::applyDerivative
(
    const scalar* x,
    const boundaryValues& b,
    const vectorField&,
    scalar* r,
    vectorField& traction
) const
{
    setFlow(x, b);
    setVertexRates();
    addFaces(b, r, traction);
    const auto change = []
    (
        const sheared& at, const symmTensor& dD, const vector& dPull
    )
    {
        return at.beyond*dPull + (at.slope && dD)*at.pull;
    };
    forAll(inner_, i)
    {
        addInner(i, change(inner_[i], innerRate(i), innerPull(i)), r);
    }
    forBoundary([&](const label i)
    {
        const tensor dH(boundaryGradient(i, b.faces[i]));
        addBoundary
        (
            i, change(boundary_[i], symm(dH), boundaryPull(i, dH)), r, traction
        );
    });
}
