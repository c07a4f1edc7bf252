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


void Foam::fsbi::secondOrderStokes::addBoundaryFaces
(
    const boundaryValues& b,
    scalar* r,
    vectorField& traction
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& C = mesh_.cellCentres();

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled())
        {
            continue;
        }
        for (label facei = pp.start(); facei < pp.start() + pp.size(); ++facei)
        {
            const label i = facei - mesh_.nInternalFaces();
            const label P = owner[facei];
            const vector& S = mesh_.faceAreas()[facei];
            const wallGradient wall
            (
                S, Cf[facei] - C[P], stencil_.wallWeight()[i]
            );
            const scalar* x = values_.cdata() + 4*P;
            const scalar* g = gradients_.cdata() + 12*P;
            scalar* rP = r + 4*P;

            vector t;
            scalar flux;
            if (velocityGiven_[i])
            {
                const vector& ub = b.faces[i];
                const vector Hu(wall.gradient(x[0], ub.x(), g));
                const vector Hv(wall.gradient(x[1], ub.y(), g + 3));
                const vector Hw(wall.gradient(x[2], ub.z(), g + 6));
                const scalar p = wall.value(x[3], g + 9);
                t = mu_*vector(Hu & S, Hv & S, Hw & S) - p*S;
                traction[i] = t + mu_*transposedAtWall(facei);
                flux = ub & S;
            }
            else
            {
                // the pressure that the given traction asks for, against
                // the one extrapolated, drives the stabilising flux
                const vector& n = wall.normal();
                const vector transposed
                (
                    S.x()*vector(g[0], g[1], g[2])
                  + S.y()*vector(g[3], g[4], g[5])
                  + S.z()*vector(g[6], g[7], g[8])
                );
                const scalar p =
                    2*mu_*(transposed & n)/mag(S) - (b.faces[i] & n);
                traction[i] = mag(S)*b.faces[i];
                t = traction[i] - mu_*transposed;
                flux =
                    S.x()*wall.value(x[0], g)
                  + S.y()*wall.value(x[1], g + 3)
                  + S.z()*wall.value(x[2], g + 6)
                  - stabilisation_[P]*mag(S)/wall.distance()
                   *(p - wall.value(x[3], g + 9));
            }
            rP[0] -= t.x();
            rP[1] -= t.y();
            rP[2] -= t.z();
            rP[3] += flux;
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
