/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    What flowConditions give on the boundary at a time: velocities at faces,
    vertices and further points of walls, tractions, and their balance.

\*---------------------------------------------------------------------------*/

#include "flowConditions.H"
#include "pointwiseValue.H"
#include "tractionCondition.H"
#include "PrimitivePatchInterpolation.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Net flux over the gross one that is a rounding of profiles on faces, to be
//  spread out, rather than a mistake
static const scalar acceptedImbalance = 0.01;

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::flowConditions::evaluate
(
    volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    given.faces.setSize(stokes.nBoundaryFaces());
    given.faces = Zero;
    // not updateCoeffs(): that does nothing the second time, at a later time
    U.boundaryFieldRef().evaluate();
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled())
        {
            continue;
        }
        const label start = pf.patch().start() - mesh_.mesh().nInternalFaces();
        SubField<vector> values(given.faces, pf.size(), start);
        if (isA<tractionCondition>(pf))
        {
            values = refCast<const tractionCondition>(pf).traction();
        }
        else if (!mesh_.isBody(pf.patch().name()))
        {
            values = pf;
        }
    }
    setVertices(U, stokes, given);
    balanceFluxes(stokes, given);
    setBodies(U, stokes, given);
}


const Foam::fsbi::prescribedBody* Foam::fsbi::flowConditions::prescribed
(
    const word& patch
) const
{
    const label b = namesOf(mesh_.bodies()).find(patch);
    return b < 0 ? nullptr : isA<prescribedBody>(mesh_.bodies()[b]);
}


void Foam::fsbi::flowConditions::setBodies
(
    volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    for (fvPatchVectorField& pf : U.boundaryFieldRef())
    {
        if (const auto* body = prescribed(pf.patch().name()))
        {
            vectorField u(pf.size());
            forAll(u, i)
            {
                u[i] = body->velocityAt
                (
                    pf.patch().Cf()[i] - body->toImage(), pf.patch().Sf()[i]
                );
            }
            pf == u;
            const label start =
                pf.patch().start() - mesh_.mesh().nInternalFaces();
            SubField<vector>(given.faces, u.size(), start) = u;
        }
    }
}


void Foam::fsbi::flowConditions::setVertices
(
    const volVectorField& U,
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    // processors share vertices of the mesh; what is on edges they all have
    const labelList& wall = stokes.wallVertices();
    vectorField sum(mesh_.mesh().nPoints(), Zero);
    scalarField count(sum.size(), Zero);
    vectorField edgeSum(stokes.wallEdges().size(), Zero);
    scalarField edgeCount(edgeSum.size(), Zero);
    for (const fvPatchVectorField& pf : U.boundaryField())
    {
        if (pf.coupled() || isA<tractionCondition>(pf))
        {
            continue;
        }
        const labelList points
        (
            stokes.wallPointsOn(pf.patch().patch().meshPoints())
        );
        const vectorField u(wallVelocity(pf, stokes, points));
        forAll(u, k)
        {
            const label i = points[k], edgei = i - wall.size();
            (edgei < 0 ? sum[wall[i]] : edgeSum[edgei]) += u[k];
            (edgei < 0 ? count[wall[i]] : edgeCount[edgei]) += 1;
        }
    }
    syncTools::syncPointList(mesh_.mesh(), sum, plusEqOp<vector>(), vector::zero);
    syncTools::syncPointList(mesh_.mesh(), count, plusEqOp<scalar>(), scalar(0));

    given.vertices.setSize(stokes.wallPoints().size());
    forAll(wall, i)
    {
        given.vertices[i] = sum[wall[i]]/max(count[wall[i]], scalar(1));
    }
    forAll(edgeSum, i)
    {
        given.vertices[wall.size() + i] =
            edgeSum[i]/max(edgeCount[i], scalar(1));
    }
}


Foam::vectorField Foam::fsbi::flowConditions::wallVelocity
(
    const fvPatchVectorField& pf,
    const stokesOperator& stokes,
    const labelList& points
) const
{
    const polyPatch& pp = pf.patch().patch();
    const pointField x(stokes.wallPoints(), points);
    if (const auto* profile = isA<pointwiseValue>(pf))
    {
        return profile->valueAt(x, time_.value());
    }
    vectorField u(x.size(), Zero);
    if (const auto* body = prescribed(pp.name()))
    {
        forAll(u, i)
        {
            u[i] = body->velocityAt(x[i] - body->toImage());
        }
    }
    else if (!mesh_.isBody(pp.name()))
    {
        const vectorField corners
        (
            PrimitivePatchInterpolation<primitivePatch>(pp)
           .faceToPointInterpolate(static_cast<const vectorField&>(pf))
        );
        const auto at = [&](const label v)
        {
            return corners[pp.meshPointMap()[v]];
        };
        const labelList& wall = stokes.wallVertices();
        forAll(u, i)
        {
            const label edgei = points[i] - wall.size();
            u[i] =
                edgei < 0
              ? at(wall[points[i]])
              : 0.5
               *(
                    at(stokes.wallEdges()[edgei].start())
                  + at(stokes.wallEdges()[edgei].end())
                );
        }
    }
    return u;
}


void Foam::fsbi::flowConditions::balanceFluxes
(
    const stokesOperator& stokes,
    boundaryValues& given
) const
{
    const boolList& velocityGiven = stokes.velocityGiven();
    scalar net = 0, gross = 0;
    bool open = false;
    for (const polyPatch& pp : mesh_.mesh().boundaryMesh())
    {
        const label start = pp.start() - mesh_.mesh().nInternalFaces();
        for (label i = start; !pp.coupled() && i < start + pp.size(); ++i)
        {
            open |= !velocityGiven[i];
            const scalar flux =
                given.faces[i]
              & mesh_.mesh().faceAreas()[mesh_.mesh().nInternalFaces() + i];
            net += flux;
            gross += mag(flux);
        }
    }
    reduce(open, orOp<bool>());
    reduce(net, sumOp<scalar>());
    reduce(gross, sumOp<scalar>());
    if (open || gross < VSMALL)
    {
        return;
    }
    if (mag(net) > acceptedImbalance*gross)
    {
        FatalErrorInFunction
            << "The velocities given on the boundary of region "
            << mesh_.name() << " do not balance: net outflow " << net
            << " of " << gross << ". Correct field U, or give one patch the condition 'traction'"
            << exit(FatalError);
    }
    forAll(given.faces, i)
    {
        if (velocityGiven[i])
        {
            const vector& S =
                mesh_.mesh().faceAreas()[mesh_.mesh().nInternalFaces() + i];
            const scalar share = mag(given.faces[i] & S)/gross;
            given.faces[i] -= net*share*S/magSqr(S);
        }
    }
}
