/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "secondOrderStokes.H"

Foam::vector Foam::fsbi::secondOrderStokes::transposedAtWall
(
    const label facei
) const
{
    const face& f = mesh_.faces()[facei];
    const pointField& x = mesh_.points();
    vector sum(Zero);
    forAll(f, k)
    {
        const label v = f[k], next = f.nextLabel(k);
        const scalar* a = vertexValues_.cdata() + 4*v;
        const scalar* b = vertexValues_.cdata() + 4*next;
        sum +=
            (x[next] - x[v])
          ^ vector(0.5*(a[0] + b[0]), 0.5*(a[1] + b[1]), 0.5*(a[2] + b[2]));
    }
    return sum;
}


Foam::fsbi::wallGradient Foam::fsbi::secondOrderStokes::wall
(
    const label facei
) const
{
    const label P = mesh_.faceOwner()[facei];
    return wallGradient
    (
        mesh_.faceAreas()[facei],
        mesh_.faceCentres()[facei] - mesh_.cellCentres()[P],
        stencil_.wallWeight()[facei - mesh_.nInternalFaces()]
    );
}


Foam::fsbi::secondOrderStokes::throughFace
Foam::fsbi::secondOrderStokes::withVelocity
(
    const label facei, const vector& u, vector& traction
) const
{
    const label P = mesh_.faceOwner()[facei];
    const scalar* x = values_.cdata() + 4*P;
    const scalar* g = gradients_.cdata() + 12*P;
    const vector& S = mesh_.faceAreas()[facei];
    const wallGradient at(wall(facei));
    const vector Hu(at.gradient(x[0], u.x(), g));
    const vector Hv(at.gradient(x[1], u.y(), g + 3));
    const vector Hw(at.gradient(x[2], u.z(), g + 6));
    const scalar p = at.value(x[3], g + 9);
    const vector force(mu_*vector(Hu & S, Hv & S, Hw & S) - p*S);
    traction = force + mu_*transposedAtWall(facei);
    return {force, u & S};
}


Foam::fsbi::secondOrderStokes::throughFace
Foam::fsbi::secondOrderStokes::withTraction
(
    const label facei, const vector& given, vector& traction
) const
{
    const label P = mesh_.faceOwner()[facei];
    const scalar* x = values_.cdata() + 4*P;
    const scalar* g = gradients_.cdata() + 12*P;
    const vector& S = mesh_.faceAreas()[facei];
    const wallGradient at(wall(facei));
    const vector& n = at.normal();
    const vector transposed
    (
        S.x()*vector(g[0], g[1], g[2])
      + S.y()*vector(g[3], g[4], g[5])
      + S.z()*vector(g[6], g[7], g[8])
    );
    // the pressure that the given traction asks for, against the one
    // extrapolated, drives the stabilising flux
    const scalar p = 2*mu_*(transposed & n)/mag(S) - (given & n);
    traction = mag(S)*given;
    return
    {
        traction - mu_*transposed,
        S.x()*at.value(x[0], g)
      + S.y()*at.value(x[1], g + 3)
      + S.z()*at.value(x[2], g + 6)
      - stabilisation_[P]*mag(S)/at.distance()*(p - at.value(x[3], g + 9))
    };
}


Foam::scalar Foam::fsbi::secondOrderStokes::fluxPerPressure
(
    const label i
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    return
       -stabilisation_[mesh_.faceOwner()[facei]]
       *mag(mesh_.faceAreas()[facei])/wall(facei).distance();
}


void Foam::fsbi::secondOrderStokes::addBoundaryFaces
(
    const boundaryValues& b,
    scalar* r,
    vectorField& traction
) const
{
    boundaryFlux_.setSize(nBoundaryFaces(), 0);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        for (label k = 0; !pp.coupled() && k < pp.size(); ++k)
        {
            const label facei = pp.start() + k;
            const label i = facei - mesh_.nInternalFaces();
            const throughFace out
            (
                velocityGiven_[i]
              ? withVelocity(facei, b.faces[i], traction[i])
              : withTraction(facei, b.faces[i], traction[i])
            );
            scalar* row = r + 4*mesh_.faceOwner()[facei];
            row[0] -= out.force.x();
            row[1] -= out.force.y();
            row[2] -= out.force.z();
            row[3] += out.flux;
            boundaryFlux_[i] = out.flux;
        }
    }
}


Foam::tmp<Foam::scalarField>
Foam::fsbi::secondOrderStokes::boundaryPressure() const
{
    auto result = tmp<scalarField>::New(nBoundaryFaces());
    forAll(result(), i)
    {
        const label facei = mesh_.nInternalFaces() + i;
        const label P = mesh_.faceOwner()[facei];
        const vector db(mesh_.faceCentres()[facei] - mesh_.cellCentres()[P]);
        const scalar* g = gradients_.cdata() + 12*P + 9;
        result.ref()[i] =
            values_[4*P + 3] + g[0]*db.x() + g[1]*db.y() + g[2]*db.z();
    }
    return result;
}
