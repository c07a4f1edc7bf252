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

//- Drag of the slip, as a part of the compact operator's. Without it GMRES does not
//  converge at mu/(G dt) = 10; with all of it errors on coarse meshes are larger
static const scalar slipDrag = 0.5;

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::fourthOrderStokes::setBalanced()
{
    DynamicList<labelList> closed;
    DynamicList<label> rest;
    const label nPatches = mesh_.boundaryMesh().nNonProcessor();
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        DynamicList<label> faces(pp.size());
        for (label k = 0; k < pp.size(); ++k)
        {
            const label i = pp.start() + k - mesh_.nInternalFaces();
            if (velocityGiven_[i])
            {
                faces.append(i);
            }
        }
        const vectorField S(pp.faceAreas());
        if (mag(gSum(S)) < closedBelow*gSum(mag(S)))
        {
            closed.append(faces);
        }
        else
        {
            rest.append(faces);
        }
    }
    closed.append(rest);
    balanced_ = closed;
}


Foam::vector Foam::fsbi::fourthOrderStokes::velocityAt
(
    const label v, const point& x
) const
{
    return velocityOf
    (
        coefficients_.cdata() + stokesPolynomials::nCoefficients*v,
        fits_.perLength()[v]*(x - fits_.origins()[v])
    );
}


Foam::vector Foam::fsbi::fourthOrderStokes::tractionAt
(
    const labelUList& vertices, const point& x, const vector& S
) const
{
    tensor gradient(Zero);
    scalar p = 0;
    const scalar share = 1.0/vertices.size();
    for (const label v : vertices)
    {
        const scalar s = fits_.perLength()[v];
        const scalar* c =
            coefficients_.cdata() + stokesPolynomials::nCoefficients*v;
        scalar a[nCubic], g[nCubic];
        setMonomials(s*(x - fits_.origins()[v]), a);
        fourNumbers value = {0, 0, 0, 0};
        addProducts<nCubic>(a, c, value);
        p += share*value[3];
        for (direction i = 0; i < 3; ++i)
        {
            vector e(Zero);
            e[i] = share*s;
            setGradientMeans(e, a, g);
            fourNumbers slope = {0, 0, 0, 0};
            addProducts<nCubic>(g, c, slope);
            const vector row(velocity(slope));
            for (direction j = 0; j < 3; ++j)
            {
                gradient(i, j) += row[j];
            }
        }
    }
    return ((gradient + gradient.T()) & S) - p*S;
}


void Foam::fsbi::fourthOrderStokes::addStrips
(
    const label patchi, vectorField& traction
) const
{
    const polyPatch& pp = mesh_.boundaryMesh()[patchi];
    const label first = pp.start() - mesh_.nInternalFaces();
    forAll(pp, i)
    {
        const face& f = pp[i];
        forAll(f, k)
        {
            // of the edge's ends: the same for both of its facets
            label ends[] = {f[k], f.nextLabel(k)};
            const wallStrip strip(fits_.wall().strip(ends[0], ends[1]));
            const vector t
            (
                -mu_*tractionAt(labelUList(ends, 2), strip.middle, strip.area)
            );
            traction[first + i] += t;
            tractionMoments_[first + i] +=
                (strip.middle - pp.faceCentres()[i])*t;
        }
    }
}


void Foam::fsbi::fourthOrderStokes::setTractionMoments() const
{
    tractionMoments_.setSize(nBoundaryFaces());
    tractionMoments_ = Zero;
    // by the rule of the three edges' middles, exact for linear tractions
    for (label k = 0; k < balanced_.size() - 1; ++k)
    {
        for (const label i : balanced_[k])
        {
            const label facei = mesh_.nInternalFaces() + i;
            const face& f = mesh_.faces()[facei];
            for (label j = 0; j < f.size(); ++j)
            {
                const point x(f.faceEdge(j).centre(mesh_.points()));
                tractionMoments_[i] +=
                    (x - mesh_.faceCentres()[facei])
                   *(mu_/3*tractionAt(f, x, mesh_.faceAreas()[facei]));
            }
            const auto addMode = [&](const modeOnFace& mode, const scalar a)
            {
                tractionMoments_[i] += mu_*a*mode.moment;
            };
            fits_.wedges().forFace(facei, addMode);
        }
    }
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
    const auto addMode = [&](const modeOnFace& mode, const scalar a)
    {
        sum += a*mode.transposed;
    };
    fits_.wedges().forFace(facei, addMode);
    return sum;
}


Foam::vector Foam::fsbi::fourthOrderStokes::slip
(
    const label i, const boundaryValues& b
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    if
    (
        b.facePoints.empty() || b.facePoints[i] == boundaryValues::nowhere
     || fits_.wedges().at(facei)
    )
    {
        return Zero;
    }
    const face& f = mesh_.faces()[facei];
    vector u(Zero);
    for (const label v : f)
    {
        u += velocityAt(v, b.facePoints[i]);
    }
    return b.faces[i] - u/f.size();
}


void Foam::fsbi::fourthOrderStokes::addFaceWithVelocity
(
    const label i, const boundaryValues& b, scalar* r, vector& traction
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const vector& S = mesh_.faceAreas()[facei];
    const faceSolutions solutions(faces());
    fourNumbers mean, slope, e;
    solutions.evaluate(facei, mean, slope);
    solutions.setDefect(facei, &faceCorner::owner, e);
    const scalar p = mean[3] + e[3];
    const vector slip(this->slip(i, b));
    const vector t
    (
        mu_*(velocity(slope) - p*S)
      + wallCoeff(i)*(slipDrag*slip - velocity(e))
    );
    four(r + 4*mesh_.faceOwner()[facei]) -= fourNumbers{t.x(), t.y(), t.z(), 0};
    traction = t + mu_*transposedAtWall(facei);
    meanVelocities_[i] = velocity(mean);
    wallFlux_[i] = (meanVelocities_[i] + slip) & S;
}


void Foam::fsbi::fourthOrderStokes::addFaceWithTraction
(
    const label i, const vector& given, scalar* r, vector& traction
) const
{
    const label facei = mesh_.nInternalFaces() + i;
    const label P = mesh_.faceOwner()[facei];
    const vector& S = mesh_.faceAreas()[facei];
    const vector n(S/mag(S));
    const faceSolutions solutions(faces());
    fourNumbers mean, slope, e;
    solutions.evaluate(facei, mean, slope);
    solutions.setDefect(facei, &faceCorner::owner, e);
    mean += e;
    const vector transposed(transposedAtWall(facei));
    traction = mag(S)*given;
    const vector t(traction - mu_*transposed);
    four(r + 4*P) -= fourNumbers{t.x(), t.y(), t.z(), 0};
    const scalar p = 2*(transposed & n)/mag(S) - (given & n)/mu_;
    wallFlux_[i] =
        (velocity(mean) & S)
      - stabilisationScale*stabilisation_[P]*wallCoeff(i)*(p - mean[3]);
}


Foam::scalar Foam::fsbi::fourthOrderStokes::fluxPerPressure
(
    const label i
) const
{
    const label P = mesh_.faceOwner()[mesh_.nInternalFaces() + i];
    return -stabilisationScale*stabilisation_[P]*wallCoeff(i)/mu_;
}


void Foam::fsbi::fourthOrderStokes::addBoundaryFaces
(
    const boundaryValues& b,
    scalar* r,
    vectorField& traction
) const
{
    meanVelocities_ = b.faces;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        const label start = pp.start() - mesh_.nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            if (velocityGiven_[i])
            {
                addFaceWithVelocity(i, b, r, traction[i]);
            }
            else
            {
                addFaceWithTraction(i, b.faces[i], r, traction[i]);
                r[4*pp.faceCells()[i - start] + 3] += wallFlux_[i];
            }
        }
    }
    boundaryFlux_ = wallFlux_;
    addWallFluxes(b, r);
    setTractionMoments();
}


void Foam::fsbi::fourthOrderStokes::addWallFluxes
(
    const boundaryValues& b, scalar* r
) const
{
    const label nInternal = mesh_.nInternalFaces();
    scalarList sums(2*balanced_.size(), Zero);
    forAll(balanced_, k)
    {
        for (const label i : balanced_[k])
        {
            const vector& S = mesh_.faceAreas()[nInternal + i];
            sums[2*k] += wallFlux_[i] - (b.faces[i] & S);
            sums[2*k + 1] += mag(S);
        }
    }
    reduce(sums, sumOp<scalarList>());
    forAll(balanced_, k)
    {
        const scalar excess = sums[2*k]/max(sums[2*k + 1], VSMALL);
        for (const label i : balanced_[k])
        {
            const label facei = nInternal + i;
            boundaryFlux_[i] =
                wallFlux_[i] - excess*mag(mesh_.faceAreas()[facei]);
            r[4*mesh_.faceOwner()[facei] + 3] += boundaryFlux_[i];
        }
    }
}


Foam::tmp<Foam::scalarField>
Foam::fsbi::fourthOrderStokes::boundaryPressure() const
{
    const faceSolutions solutions(faces());
    auto result = tmp<scalarField>::New(nBoundaryFaces());
    forAll(result(), i)
    {
        fourNumbers mean, slope;
        solutions.evaluate(mesh_.nInternalFaces() + i, mean, slope);
        result.ref()[i] = mu_*mean[3];
    }
    return result;
}
