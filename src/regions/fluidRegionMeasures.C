/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidRegion.H"
#include "bodyCoupling.H"
#include "cyclicPolyPatch.H"

Foam::fsbi::sixVector Foam::fsbi::fluidRegion::load(const label bodyi) const
{
    List<bodyRows> rows(1);
    rows[0].centre = mesh_.bodies()[bodyi].meshedPlacement().centre;
    rows[0].faces = bodyFaces_[bodyi];
    return bodyLoads(stokes(), rows, traction_)[0];
}


Foam::fsbi::patchFlow Foam::fsbi::fluidRegion::flowThrough
(
    const word& patch
) const
{
    const polyPatch& pp = mesh().boundaryMesh()[patch];
    scalarList sums(4, Zero);
    forAll(pp, k)
    {
        const label i = pp.start() - mesh().nInternalFaces() + k;
        const vector& S = mesh().faceAreas()[pp.start() + k];
        const scalar out = stokes().boundaryFlux()[i];
        sums[out > 0 ? 1 : 0] += mag(out);
        sums[2] -= (traction_[i] & S)/mag(S);
        sums[3] += mag(S);
    }
    reduce(sums, sumOp<scalarList>());
    return {sums[0], sums[1], sums[2]/max(sums[3], VSMALL)};
}


Foam::symmTensor Foam::fsbi::fluidRegion::stresslet
(
    const label bodyi
) const
{
    const point centre(mesh_.bodies()[bodyi].meshedPlacement().centre);
    const tensorField& moments = stokes().tractionMoments();
    const vectorField& mean = stokes().meanVelocities();
    const vectorField& velocity = mean.empty() ? given_.faces : mean;
    // Facets inside of the surface tell the same: what is between adds
    // sigma - mu (grad u + (grad u)^T), a pressure, which has no deviator
    tensor sum(Zero);
    for (const label i : bodyFaces_[bodyi])
    {
        const label facei = mesh().nInternalFaces() + i;
        // areas of the fluid's mesh point into the body
        sum -= (mesh().faceCentres()[facei] - centre)*traction_[i];
        if (moments.size())
        {
            sum -= moments[i];
        }
        sum += 2*stokes().mu()*velocity[i]*mesh().faceAreas()[facei];
    }
    reduce(sum, sumOp<tensor>());
    return dev(symm(sum));
}


bool Foam::fsbi::fluidRegion::periodic() const
{
    bool found = false;
    for (const polyPatch& pp : mesh().boundaryMesh())
    {
        found = found || isA<cyclicPolyPatch>(pp);
    }
    return returnReduce(found, orOp<bool>());
}


Foam::vector Foam::fsbi::fluidRegion::meanVelocity() const
{
    scalar volume = 0;
    vector sum(Zero);
    const scalarField& V = mesh().cellVolumes();
    forAll(V, celli)
    {
        volume += V[celli];
        sum += V[celli]*U_()[celli];
    }
    forAll(bodyFaces_, b)
    {
        const point centre(mesh_.bodies()[b].meshedPlacement().centre);
        for (const label i : bodyFaces_[b])
        {
            const label facei = mesh().nInternalFaces() + i;
            const vector arm(mesh().faceCentres()[facei] - centre);
            // areas of the fluid's mesh point into the body
            volume -= (arm & mesh().faceAreas()[facei])/3;
            sum -= arm*stokes().boundaryFlux()[i];
        }
    }
    reduce(volume, sumOp<scalar>());
    reduce(sum, sumOp<vector>());
    return sum/volume;
}
