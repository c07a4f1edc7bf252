/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderStokes.H"
#include "generalisedNewtonian.H"
#include "syncTools.H"

const Foam::point Foam::fsbi::boundaryValues::nowhere
(
    Foam::GREAT, Foam::GREAT, Foam::GREAT
);


namespace Foam
{
namespace fsbi
{

//- Of a fluid with inertia: the stabilisation over that of inertia alone, at
//  most. A larger one costs iterations in short steps; at 1 it would fall with
//  the step wherever inertia outweighs viscosity, and pressures that alternate
//  from cell to cell would grow
static const scalar stiffest = 5;

} // End namespace fsbi
} // End namespace Foam

const Foam::Enum<Foam::fsbi::stokesOperator::gradientScheme>
Foam::fsbi::stokesOperator::gradientSchemes
({
    { gradientScheme::vertex, "vertex" },
    { gradientScheme::Gauss, "Gauss" },
    { gradientScheme::leastSquares, "leastSquares" }
});


Foam::fsbi::stokesOperator::stokesOperator
(
    const fvMesh& mesh, const scalar mu, const boolList& velocityGiven
)
:
    mesh_(mesh),
    stencil_(mesh),
    mu_(mu),
    velocityGiven_(velocityGiven)
{
    setWallVertices();
    setDiagonal();
}


Foam::autoPtr<Foam::fsbi::stokesOperator> Foam::fsbi::stokesOperator::New
(
    const fvMesh& mesh,
    const viscosityLaw& law,
    const boolList& velocityGiven,
    const schemes& s
)
{
    if (!law.constant())
    {
        return autoPtr<stokesOperator>
        (
            new generalisedNewtonian(mesh, law, velocityGiven, s)
        );
    }
    const scalar mu = law.viscosity(0);
    if (s.order == 4)
    {
        return autoPtr<stokesOperator>
        (
            new fourthOrderStokes(mesh, mu, velocityGiven, s)
        );
    }
    return autoPtr<stokesOperator>
    (
        new secondOrderStokes(mesh, mu, velocityGiven, s)
    );
}


void Foam::fsbi::stokesOperator::setWallVertices()
{
    boolList onWall(mesh_.nPoints(), false);
    forAll(velocityGiven_, i)
    {
        if (velocityGiven_[i])
        {
            for (const label v : mesh_.faces()[mesh_.nInternalFaces() + i])
            {
                onWall[v] = true;
            }
        }
    }
    syncTools::syncPointList(mesh_, onWall, orEqOp<bool>(), false);
    DynamicList<label> vertices;
    forAll(onWall, v)
    {
        if (onWall[v])
        {
            vertices.append(v);
        }
    }
    wallVertices_.transfer(vertices);
}


Foam::labelList Foam::fsbi::stokesOperator::wallPointsOn
(
    const labelUList& vertices
) const
{
    boolList on(mesh_.nPoints(), false);
    UIndirectList<bool>(on, vertices) = true;
    DynamicList<label> found;
    forAll(wallVertices_, i)
    {
        if (on[wallVertices_[i]])
        {
            found.append(i);
        }
    }
    forAll(wallEdges_, i)
    {
        if (on[wallEdges_[i].start()] && on[wallEdges_[i].end()])
        {
            found.append(wallVertices_.size() + i);
        }
    }
    return labelList(found);
}


void Foam::fsbi::stokesOperator::addPressure
(
    const label i, const scalar p, scalar* r, vector& traction
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const vector push(p*mesh_.faceAreas()[facei]);
    const scalar flux = fluxPerPressure(i)*p;
    scalar* row = r + 4*mesh_.faceOwner()[facei];
    row[0] += push.x();
    row[1] += push.y();
    row[2] += push.z();
    row[3] += flux;
    boundaryFlux_[i] += flux;
    traction -= push;
}


Foam::scalar Foam::fsbi::stokesOperator::wallCoeff(const label i) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const vector& S = mesh_.faceAreas()[facei];
    const vector db
    (
        mesh_.faceCentres()[facei]
      - mesh_.cellCentres()[mesh_.faceOwner()[facei]]
    );
    return viscosity(mesh_.faceOwner()[facei])*magSqr(S)/(S & db);
}


void Foam::fsbi::stokesOperator::setDiagonal() const
{
    const vectorField& S = stencil_.area();
    scalarField diagonal(mesh_.nCells() + stencil_.halo().size(), Zero);
    forAll(S, i)
    {
        const faceGradient face
        (
            S[i], stencil_.fromOwner()[i], stencil_.fromNeighbour()[i]
        );
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const scalar link = 0.5*(viscosity(P) + viscosity(N))*face.compact();
        diagonal[P] += link;
        diagonal[N] += link;
    }
    forAll(velocityGiven_, i)
    {
        const label celli = mesh_.faceOwner()[mesh_.nInternalFaces() + i];
        if (velocityGiven_[i])
        {
            diagonal[celli] += wallCoeff(i);
        }
    }
    diagonal_ = SubList<scalar>(diagonal, mesh_.nCells());
    setStabilisation();
}


void Foam::fsbi::stokesOperator::setStabilisation() const
{
    stabilisation_.setSize(mesh_.nCells() + stencil_.halo().size());
    forAll(diagonal_, celli)
    {
        const scalar inertia =
            massRate_.size() ? massRate_[celli]/stiffest : 0;
        stabilisation_[celli] =
            mesh_.cellVolumes()[celli]/(diagonal_[celli] + inertia);
    }
    stencil_.halo().fill(stabilisation_.data(), 1);
}


void Foam::fsbi::stokesOperator::limitStabilisation
(
    const scalarField& massRate
)
{
    massRate_ = massRate;
    setStabilisation();
}


Foam::scalarField Foam::fsbi::stokesOperator::viscosities() const
{
    return
        viscosity_.empty()
      ? scalarField(mesh_.nCells(), mu_)
      : scalarField(SubList<scalar>(viscosity_, mesh_.nCells()));
}


bool Foam::fsbi::stokesOperator::closed() const
{
    bool closed = true;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label start = pp.start() - mesh_.nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            closed &= velocityGiven_[i];
        }
    }
    return returnReduce(closed, andOp<bool>());
}
