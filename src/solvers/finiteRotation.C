/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "finiteRotation.H"
#include "asVectors.H"
#include "quaternion.H"

namespace Foam
{
namespace fsbi
{

//- Does nothing in the body resist its rotation: no support, no law for small
//  rotations? Collective
static bool turnsFreely(const elasticOperator& elastic)
{
    for (const solidMaterial* law : elastic.parts().laws)
    {
        if (law->linear())
        {
            return false;
        }
    }
    return !solidBoundary::hold(elastic.boundary().kinds());
}


//- Mean rotation, by volume, of u at places d from their centre. Collective
static vector meanRotation
(
    const scalarField& volumes, const vectorField& d, const vectorField& u
)
{
    return inv(momentOfInertia(volumes, d)) & gSum(volumes*(d ^ u));
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::finishRotation
(
    const elasticRows& body, const scalar* before, scalar* x
)
{
    const elasticOperator& elastic = *body.elastic;
    if (!turnsFreely(elastic))
    {
        return;
    }
    scalarList places(elastic.size(), Zero);
    elastic.set([](const point& X){ return X; }, places.begin());
    vectorField now(body.volumes.size()), moved(now.size());
    forAll(now, i)
    {
        now[i] = asVectors(places.cdata())[i] + asVectors(before)[i];
        moved[i] = asVectors(x)[i] - asVectors(before)[i];
    }
    const point centre(gSum(body.volumes*now)/gSum(body.volumes));
    const vector theta(meanRotation(body.volumes, now - centre, moved));
    if (mag(theta) < SMALL)
    {
        return;
    }
    const tensor beyond
    (
        quaternion(theta/mag(theta), mag(theta)).R() - tensor(I) - *theta
    );
    const auto turn = [&](const label start, const label n)
    {
        const vector* X = asVectors(places.cdata() + start);
        const vector* u = asVectors(before + start);
        vector* v = asVectors(x + start);
        for (label i = 0; i < n; ++i)
        {
            v[i] += beyond & (X[i] + u[i] - centre);
        }
    };
    const elasticStencil& stencil = elastic.stencil();
    turn(0, stencil.nCells() + stencil.nGhosts());
    turn(elastic.firstJointRow(), stencil.joints().owned().size());
}
