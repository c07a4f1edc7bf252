/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticCoupling.H"

Foam::fsbi::surfaceDisplacement::surfaceDisplacement
(
    const elasticRows& body, const bool derivative
)
{
    const elasticOperator& elastic = *body.elastic;
    const vectorField atFaces
    (
        derivative
      ? elastic.boundaryIncrement()
      : elastic.boundaryDisplacement()
    );
    const vectorField atPoints
    (
        derivative ? elastic.vertexIncrement() : elastic.vertexDisplacement()
    );
    vectorField moving(atFaces);
    for (const label i : body.solid.faces)
    {
        if (elastic.kinds()[i] == solidBoundary::displacement)
        {
            moving[i] = derivative ? vector::zero : body.given->faces[i];
        }
    }
    faces = body.solid.collectFaces(moving);
    points = body.solid.collectPoints(atPoints);
    if (!derivative)
    {
        faces += body.movedFaces;
        points += body.movedPoints;
    }
    forAll(points, i)
    {
        if (body.heldPoints[i])
        {
            points[i] = derivative ? vector::zero : body.heldAt[i];
        }
    }
}


Foam::fsbi::surfaceDisplacement::surfaceDisplacement
(
    const elasticRows& body, const vectorField& both
)
:
    faces
    (
        SubField<vector>(both, body.solid.nFaces, body.solid.nPoints)
    ),
    points(SubField<vector>(both, body.solid.nPoints))
{}


void Foam::fsbi::setSurfaceVelocity
(
    const elasticRows& body, const surfaceDisplacement& d,
    boundaryValues& values
)
{
    body.fluid.spreadFaces
    (
        vectorField(body.rate*d.faces + body.knownFaces), values.faces
    );
    body.fluid.spreadPoints
    (
        vectorField(body.rate*d.points + body.knownPoints), values.vertices
    );
}


void Foam::fsbi::setSurfaceVelocity
(
    const elasticRows& body, const bool derivative, boundaryValues& values
)
{
    const surfaceDisplacement d(body, derivative);
    if (!derivative)
    {
        setSurfaceVelocity(body, d, values);
        return;
    }
    body.fluid.spreadFaces(vectorField(body.rate*d.faces), values.faces);
    body.fluid.spreadPoints(vectorField(body.rate*d.points), values.vertices);
}


Foam::vectorField Foam::fsbi::surfaceForce
(
    const elasticRows& body, const vectorField& traction
)
{
    vectorField force(body.elastic->kinds().size(), Zero);
    body.solid.spreadFaces(-body.fluid.collectFaces(traction), force);
    return force;
}
