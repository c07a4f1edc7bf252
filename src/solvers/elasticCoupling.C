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
    forAll(points, i)
    {
        if (body.heldPoints[i])
        {
            points[i] = Zero;
        }
    }
}


void Foam::fsbi::setSurfaceVelocity
(
    const elasticRows& body, const bool derivative, boundaryValues& values
)
{
    const surfaceDisplacement d(body, derivative);
    vectorField faces(body.rate*d.faces), points(body.rate*d.points);
    if (!derivative)
    {
        faces += body.knownFaces;
        points += body.knownPoints;
    }
    body.fluid.spreadFaces(faces, values.faces);
    body.fluid.spreadPoints(points, values.vertices);
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
