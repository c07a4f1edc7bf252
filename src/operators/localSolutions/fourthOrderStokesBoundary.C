/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderStokes.H"

namespace Foam
{
namespace fsbi
{

//- |sum S| over sum |S| of a patch that closes on itself
static const scalar closedBelow = 1e-9;

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::fourthOrderStokes::setBalanced()
{
    DynamicList<labelList> closed;
    DynamicList<label> rest;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const labelList faces
        (
            identity(pp.size(), pp.start() - mesh_.nInternalFaces())
        );
        const vectorField S(pp.faceAreas());
        if (pp.size() && mag(sum(S)) < closedBelow*sum(mag(S)))
        {
            closed.append(faces);
        }
        else
        {
            rest.append(faces);
        }
    }
    if (rest.size())
    {
        closed.append(rest);
    }
    balanced_ = closed;
}


Foam::vector Foam::fsbi::fourthOrderStokes::velocityAt
(
    const label v, const point& x
) const
{
    const scalar* c =
        coefficients_.cdata() + stokesPolynomials::nCoefficients*v;
    scalar a[nCubic];
    setMonomials(fits_.perLength()[v]*(x - mesh_.points()[v]), a);
    fourNumbers sum = {0, 0, 0, 0};
    for (label k = 0; k < nCubic; ++k)
    {
        sum += a[k]*four(c + 4*k);
    }
    return velocity(sum);
}


Foam::vector Foam::fsbi::fourthOrderStokes::transposedAtWall
(
    const label facei
) const
{
    const face& f = mesh_.faces()[facei];
    const pointField& x = mesh_.points();
    vector sum(Zero);
    forAll(f, k)
    {
        const label a = f[k], b = f.nextLabel(k);
        const point middle(0.5*(x[a] + x[b]));
        sum +=
            (x[b] - x[a])
          ^ (
                velocityAt(a, x[a]) + velocityAt(b, x[b])
              + 2*(velocityAt(a, middle) + velocityAt(b, middle))
            )/6;
    }
    return sum;
}


void Foam::fsbi::fourthOrderStokes::addBoundaryFaces
(
    const boundaryValues& b,
    scalar* r,
    vectorField& traction
) const
{
    forAll(velocityGiven_, i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const label P = mesh_.faceOwner()[facei];
        const vector& S = mesh_.faceAreas()[facei];
        faceValue q;
        evaluate(facei, q);
        const fourNumbers e = defect(facei, &corner::owner);
        const scalar p = q.mean[3] + e[3];
        const vector t
        (
            mu_*(velocity(q.slope) - p*S) - wallCoeff(i)*velocity(e)
        );
        r[4*P] -= t.x();
        r[4*P + 1] -= t.y();
        r[4*P + 2] -= t.z();
        traction[i] = t + mu_*transposedAtWall(facei);
        wallFlux_[i] = velocity(q.mean) & S;
    }
    addWallFluxes(b, r);
}


void Foam::fsbi::fourthOrderStokes::addWallFluxes
(
    const boundaryValues& b, scalar* r
) const
{
    const label nInternal = mesh_.nInternalFaces();
    for (const labelList& faces : balanced_)
    {
        scalar excess = 0, area = 0;
        for (const label i : faces)
        {
            const vector& S = mesh_.faceAreas()[nInternal + i];
            excess += wallFlux_[i] - (b.faces[i] & S);
            area += mag(S);
        }
        for (const label i : faces)
        {
            const label facei = nInternal + i;
            r[4*mesh_.faceOwner()[facei] + 3] +=
                wallFlux_[i] - excess/area*mag(mesh_.faceAreas()[facei]);
        }
    }
}


Foam::tmp<Foam::scalarField>
Foam::fsbi::fourthOrderStokes::boundaryPressure() const
{
    auto result = tmp<scalarField>::New(nBoundaryFaces());
    forAll(result(), i)
    {
        faceValue q;
        evaluate(mesh_.nInternalFaces() + i, q);
        result.ref()[i] = mu_*q.mean[3];
    }
    return result;
}
